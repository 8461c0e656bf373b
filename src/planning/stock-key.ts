import { inBox } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { regionsOf } from "../sim/region.ts";
import type { Action, PlanRequest } from "./types.ts";

/** The rings of connected pieces as they are: equal texts are equal rings. */
const exactly = (rings: readonly Ring[]): string =>
  rings.map((ring) => ring.map(({ z, r }) => `${z},${r}`).join(" ")).join("|");

/**
 * Asks for each connected piece of an area larger than `least` mm² once in a request: most pieces of a stock stay as
 * they are from one state to the next. `name`: what the answer depends on besides the piece.
 */
export const ofPieces = <T>(
  area: readonly Ring[],
  least: number,
  name: string,
  ask: (piece: readonly Ring[]) => readonly T[],
  { shop: { memory } }: PlanRequest,
): readonly T[] =>
  regionsOf(area, least).flatMap(({ outline, holes }) => {
    const piece = [outline, ...holes];
    return memory ? memory.cached(`${name} ${exactly(piece)}`, () => ask(piece)) : ask(piece);
  });

/** Stocks that differ less are the same, as steps per mm: chords and the grid of the polygon engine. */
const STEPS = 200;

function ringKey(ring: Ring): string {
  const points = ring.map(({ z, r }) => `${Math.round(z * STEPS)},${Math.round(r * STEPS)}`);
  const own = points.filter((p, i) => p !== points.at(i - 1));
  const [first] = own.toSorted();
  const begin = own.indexOf(first ?? "");
  return [...own.slice(begin), ...own.slice(0, begin)].join(" ");
}

/** The same text for the same stock, whatever order of operations made it. */
export const stockKey = (stock: readonly Ring[]): string => stock.map(ringKey).sort().join("|");

/** Farther than any stock, mm; distance around a place in which stock can matter to an action. */
const [FAR, AROUND] = [10_000, 2];

/** Where the stock decides what an action does: its place and the way to it. */
function boxOfAction({ place: { front, rear, high, low }, site }: Action): Box {
  return {
    left: rear - AROUND,
    right: site === "outside" ? front + AROUND : FAR,
    low: site === "inside" ? -FAR : low - AROUND,
    high: site === "outside" ? FAR : high + AROUND,
  };
}

/** The stock that decides what an action does, as a text. */
export const localKey = (stock: readonly Ring[], action: Action): string => stockKey(inBox(stock, boxOfAction(action)));

/** Volume of an area turned round the axis, mm³. */
export function turnedVolume(area: readonly Ring[]): number {
  let sum = 0;
  for (const ring of area) {
    let a: Pt | undefined = ring.at(-1);
    for (const b of ring) {
      if (a) {
        const [from, to] = [Number(a.r), Number(b.r)];
        sum += (a.z - b.z) * (from * from + from * to + to * to);
      }
      a = b;
    }
  }
  return (Math.PI / 3) * sum;
}
