import type { Flat } from "../flat.ts";
import { NOTHING, SAME } from "../tolerance.ts";

/** Where the finished groove of a thread runs. Strategy space, mm. */
export interface ThreadLine {
  /** The crest from the beginning of the thread to its end, u rising. */
  readonly crest: readonly Flat[];
  readonly depth: number;
  readonly runIn: number;
  readonly overrun: number;
  /** Way before the end over which the tool rises from the depth to the crest; 0 leaves at full depth. */
  readonly runOut: number;
}

/** Height of a line of points at a place; beyond its ends it goes on straight. */
export function heightOn(line: readonly Flat[], u: number): number {
  let i = 1;
  while (i < line.length - 1 && (line[i] as Flat).u < u) i += 1;
  const [a, b] = [line[i - 1], line[i]];
  if (!a) return 0;
  if (!b || b.u - a.u < NOTHING) return a.v;
  return a.v + ((b.v - a.v) * (u - a.u)) / (b.u - a.u);
}

/** Corners of the way of the tip in the deepest pass, run-in and overrun included. */
export function deepestPass({ crest, depth, runIn, overrun, runOut }: ThreadLine): Flat[] {
  const [first, last] = [crest[0] as Flat, crest.at(-1) as Flat];
  const rises = last.u - runOut;
  const below = (u: number) => {
    if (runOut <= 0 || u <= rises) return depth;
    return depth * Math.max(0, (last.u - u) / runOut);
  };
  const places = [first.u - runIn, ...crest.map((p) => p.u), ...(runOut > 0 ? [rises] : []), last.u + overrun].sort((a, b) => a - b);
  const corners = places.map((u): Flat => ({ u, v: heightOn(crest, u) - below(u) }));
  return corners.filter((p, i) => !isBetween(corners[i - 1], p, corners[i + 1]));
}

/** A corner at which the way goes on straight, or does not go on at all, is none. */
function isBetween(a: Flat | undefined, p: Flat, b: Flat | undefined): boolean {
  if (a && p.u - a.u < SAME) return true;
  if (!a || !b || b.u - a.u < SAME) return false;
  return Math.abs(a.v + ((b.v - a.v) * (p.u - a.u)) / (b.u - a.u) - p.v) < NOTHING;
}

/** The way of a shallower pass: the deepest one, moved back along the direction of infeed, so that it stays inside its groove. */
export const passAt = (deepest: readonly Flat[], missing: number, slope: number): Flat[] =>
  deepest.map((p) => ({ u: p.u - missing * slope, v: p.v + missing }));
