import type { Place } from "./camera.ts";
import type { Seen } from "./edge-mark.ts";

/** Where a badge stands from its place, pixels: beside it, so that the place stays to be seen. */
const ASIDE = { x: 18, y: -18 };
/** Badges nearer than this would hide one another; half of the badge itself, pixels. */
const APART = 24, HALF = 11;
/** A row of badges stands higher over its places by this much for each of them, up to the second, pixels. */
const RISE = 5, HIGHEST = 40;

interface Asked {
  readonly index: number;
  readonly place: Place;
}

const near = (a: Place, b: Place) => Math.abs(a.x - b.x) < APART && Math.abs(a.y - b.y) < APART;

/** Those whose badges would hide one another if each stood beside its place, together. */
function crowdsOf(places: readonly Place[]): Asked[][] {
  const crowds: Asked[][] = [];
  places.forEach((place, index) => {
    const [met, apart] = [
      crowds.filter((c) => c.some((other) => near(other.place, place))),
      crowds.filter((c) => c.every((other) => !near(other.place, place))),
    ];
    crowds.splice(0, crowds.length, ...apart, [...met.flat(), { index, place }]);
  });
  return crowds.toSorted((a, b) => a.length - b.length);
}

/** The badges of a crowd in rows over its places, from left to right as the places lie: so their leaders hardly cross. */
function rowsOver(crowd: readonly Asked[], seen: Seen): readonly Place[] {
  const inRow = Math.max(1, Math.floor((seen.right - seen.left) / APART)), rows = Math.ceil(crowd.length / inRow);
  const middle = crowd.reduce((sum, { place }) => sum + place.x, 0) / crowd.length + (crowd.length > 1 ? 0 : ASIDE.x);
  const over = Math.min(...crowd.map(({ place }) => place.y)) + ASIDE.y - Math.min(HIGHEST, RISE * (crowd.length - 1));
  const lowest = crowd.length > 1 ? Math.max(over, seen.top + HALF + (rows - 1) * APART) : over;
  return crowd.map((_, i) => {
    const row = i % rows, column = Math.floor(i / rows), wide = (Math.ceil((crowd.length - row) / rows) - 1) * APART;
    const left = Math.max(seen.left + HALF, Math.min(seen.right - HALF - wide, middle - wide / 2));
    return { x: left + column * APART, y: lowest - row * APART };
  });
}

/** Columns and rows by which a whole crowd may be shifted, the nearest first: rather to a side than down on the work. */
const SIDE = 4, FAR = 12, DOWN = 3;
const SHIFTS: readonly Place[] = Array.from({ length: 2 * FAR + 1 }, (_, i) => i - FAR).flatMap((y) =>
  Array.from({ length: 2 * SIDE + 1 }, (_, i): Place => ({ x: i - SIDE, y }))
).sort((a, b) => seemsFar(a) - seemsFar(b) || a.x - b.x);

function seemsFar({ x, y }: Place): number {
  return Math.abs(x) + Math.abs(y) + (y > 0 ? DOWN : 0);
}

/**
 * The middle of the badge of each place: beside it, or, where badges would hide one another, in a row over their places. Nothing stands
 * on what stands there already, nor out of what is seen, as long as there is room above or below.
 */
export function badgePlaces(places: readonly Place[], seen: Seen): readonly Place[] {
  const put: Place[] = [], found: Place[] = places.map(({ x, y }) => ({ x: x + ASIDE.x, y: y + ASIDE.y }));
  for (const crowd of crowdsOf(places)) {
    const sorted = crowd.toSorted((a, b) => a.place.x - b.place.x), first = rowsOver(sorted, seen);
    const shifted = (by: Place) => first.map(({ x, y }) => ({ x: x + by.x * APART, y: y + by.y * APART }));
    const isFree = (row: readonly Place[]) =>
      row.every((at) =>
        at.x - HALF >= seen.left && at.x + HALF <= seen.right && at.y - HALF >= seen.top && at.y + HALF <= seen.bottom
        && !put.some((other) => near(other, at))
      );
    const by = SHIFTS.find((each) => isFree(shifted(each))) ?? { x: 0, y: 0 }, row = shifted(by);
    sorted.forEach(({ index }, i) => {
      const at = row[i];
      if (!at) return;
      found[index] = at;
      put.push(at);
    });
  }
  return found;
}
