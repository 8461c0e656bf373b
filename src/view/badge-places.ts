import type { Place } from "./camera.ts";
import { arrange } from "./dimensions/arrange.ts";
import { boxAbout } from "./dimensions/labels.ts";
import type { VisibleArea } from "./edge-mark.ts";

/** Offset of a badge from its place, pixels, so that the place itself stays visible. */
const ASIDE = { x: 18, y: -18 };
/** Badges nearer than this would hide one another; half of the badge itself, pixels. */
const APART = 24,
  HALF = 11;
/** Width of a badge that several places share, pixels. */
export const SHARED = 44;
/** Largest share of the picture's width for a row of badges; a wider one would hide the part behind its leaders. */
const WIDEST = 0.6;
/** Extra height of a row above its places for each badge after the first, and its maximum, pixels. */
const RISE = 5,
  HIGHEST = 40;

interface Asked {
  readonly index: number;
  readonly place: Place;
}

const near = (a: Place, b: Place) => Math.abs(a.x - b.x) < APART && Math.abs(a.y - b.y) < APART;

/** Groups of places whose badges would hide one another if each were beside its place. */
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

/**
 * The badges of a crowd, left to right in the order of their places: one per place or, in a row without room for so
 * many, one per group of neighbours.
 */
interface Row {
  readonly shares: readonly (readonly Asked[])[];
  /** From badge to badge, pixels. */
  readonly pitch: number;
}

function rowOf(crowd: readonly Asked[], { left, right }: VisibleArea): Row {
  const sorted = crowd.toSorted((a, b) => a.place.x - b.place.x);
  const room = WIDEST * (right - left);
  if (crowd.length * APART <= room) return { shares: sorted.map((each) => [each]), pitch: APART };
  const size = Math.ceil(crowd.length / Math.max(1, Math.floor(room / SHARED)));
  return {
    shares: Array.from({ length: Math.ceil(crowd.length / size) }, (_, i) => sorted.slice(i * size, (i + 1) * size)),
    pitch: SHARED,
  };
}

/** Places of the badges of a row: above the places they belong to, so that leaders hardly cross. */
function rowOver({ shares, pitch }: Row, crowd: readonly Asked[], seen: VisibleArea): readonly Place[] {
  const middle = crowd.reduce((sum, { place }) => sum + place.x, 0) / crowd.length + (crowd.length > 1 ? 0 : ASIDE.x);
  const over = Math.min(...crowd.map(({ place }) => place.y)) + ASIDE.y - Math.min(HIGHEST, RISE * (crowd.length - 1));
  const wide = (shares.length - 1) * pitch,
    half = pitch / 2 - 1;
  const left = Math.max(seen.left + half, Math.min(seen.right - half - wide, middle - wide / 2));
  return shares.map((_, i) => ({ x: left + i * pitch, y: crowd.length > 1 ? Math.max(over, seen.top + HALF) : over }));
}

/**
 * Columns and rows by which a whole crowd may be shifted, the nearest first; sideways rather than down onto the work.
 */
const SIDE = 4,
  FAR = 12,
  DOWN = 3;
const SHIFTS: readonly Place[] = Array.from({ length: 2 * FAR + 1 }, (_, i) => i - FAR)
  .flatMap((y) => Array.from({ length: 2 * SIDE + 1 }, (_, i): Place => ({ x: i - SIDE, y })))
  .sort((a, b) => seemsFar(a) - seemsFar(b) || a.x - b.x);

function seemsFar({ x, y }: Place): number {
  return Math.abs(x) + Math.abs(y) + (y > 0 ? DOWN : 0);
}

/**
 * The centre of the badge of each place: beside the place, or in a row above the places where badges would hide one
 * another. In a row that is too long, neighbours share a badge. While there is room above or below, no badge covers
 * another or leaves the visible area.
 */
export function badgePlaces(places: readonly Place[], seen: VisibleArea): readonly Place[] {
  const rows = crowdsOf(places).map((crowd) => {
    const row = rowOf(crowd, seen),
      first = rowOver(row, crowd, seen);
    const size = { width: row.shares.length * row.pitch, height: APART };
    const candidates = SHIFTS.map((by) => {
      const put = first.map(({ x, y }) => ({ x: x + by.x * APART, y: y + by.y * APART }));
      const middle = { x: ((put[0]?.x ?? 0) + (put.at(-1)?.x ?? 0)) / 2, y: put[0]?.y ?? 0 };
      return { label: boxAbout(middle, size), lines: [], cost: 0, put, shares: row.shares };
    });
    return { q: "", candidates, needed: true };
  });
  const air = APART / 2 - HALF,
    [x, y] = [seen.left - air, seen.top - air];
  const room = { x, y, width: seen.right + air - x, height: seen.bottom + air - y };
  const found = [...places];
  for (const { put, shares } of arrange(rows, { width: seen.right, height: seen.bottom, room, avoid: [], kept: [] }))
    for (const [i, at] of put.entries()) for (const { index } of shares[i] ?? []) found[index] = at;
  return found;
}
