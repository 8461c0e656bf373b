import type { Flat } from "../geometry/flat.ts";
import { NOTHING, ROUND, SAME } from "../tolerance.ts";
import { radians } from "../units.ts";

/** Path of the finished groove of a thread. Strategy space, mm. */
export interface ThreadLine {
  /** The crest from start to end of the thread, u rising. */
  readonly crest: readonly Flat[];
  readonly depth: number;
  readonly runIn: number;
  readonly overrun: number;
  /** Length before the end over which the tool rises from the depth to the crest; 0 retracts at full depth. */
  readonly runOut: number;
}

/** Height of a line of points at a place; extended straight beyond its ends. */
export function heightOn(line: readonly Flat[], u: number): number {
  let i = 1;
  while (i < line.length - 1 && (line[i] as Flat).u < u) i += 1;
  const [a, b] = [line[i - 1], line[i]];
  if (!a) return 0;
  if (!b || b.u - a.u < NOTHING) return a.v;
  return a.v + ((b.v - a.v) * (u - a.u)) / (b.u - a.u);
}

/** Place where the tool begins to rise along a run-out; Infinity without one. */
export const risesAt = ({ crest, runOut }: ThreadLine): number =>
  runOut > 0 ? (crest.at(-1) as Flat).u - runOut : Infinity;

/** Share of its depth that a pass has at a place. */
export const shareAt = (line: ThreadLine, u: number): number =>
  u <= risesAt(line) ? 1 : Math.max(0, ((line.crest.at(-1) as Flat).u - u) / line.runOut);

/**
 * Corners of the tip's path in a pass of `depth`, run-in and overrun included. A shallower pass is set back along the
 * thread by `slope` per mm of missing depth, so that it stays inside the finished groove; along a run-out it rises from
 * its own depth to the crest at the end of the thread.
 */
export function passAt(line: ThreadLine, depth: number, slope: number): Flat[] {
  const { crest, runIn, overrun, runOut } = line;
  const [first, last] = [crest[0] as Flat, crest.at(-1) as Flat];
  const rises = risesAt(line);
  const back = (line.depth - depth) * slope;
  const share = (u: number) => shareAt(line, u);
  const corners = crest.map(({ u }) => (u - back <= rises ? u - back : u));
  const ends = runOut > 0 ? [rises, last.u, last.u + overrun] : [last.u + overrun - back];
  const places = [first.u - runIn - back, ...corners, ...ends]
    .sort((a, b) => a - b)
    .filter((u, i, all) => i === 0 || u - (all[i - 1] as number) >= SAME);
  const way = places.map((u): Flat => ({ u, v: heightOn(crest, u + back * share(u)) - depth * share(u) }));
  return way.filter((p, i) => !isBetween(way[i - 1], p, way[i + 1]));
}

/** True for a corner at which the path continues straight, or does not move. */
function isBetween(a: Flat | undefined, p: Flat, b: Flat | undefined): boolean {
  if (a && p.u - a.u < SAME) return true;
  if (!a || !b || b.u - a.u < SAME) return false;
  return Math.abs(a.v + ((b.v - a.v) * (p.u - a.u)) / (b.u - a.u) - p.v) < NOTHING;
}

/** Greatest rise of the crest, mm per mm. */
export const steepestRise = ({ crest }: ThreadLine): number =>
  Math.max(0, ...crest.slice(1).map((p, i) => Math.abs((p.v - (crest[i] as Flat).v) / (p.u - (crest[i] as Flat).u))));

/**
 * Required height of a flank, mm: on a cone the crest rises on one side of the tip. Infinite where it is as steep as
 * the flank.
 */
export function depthAlong(line: ThreadLine, half: number): number {
  const over = 1 - steepestRise(line) * Math.tan(radians(half));
  return over > ROUND ? line.depth / over : Infinity;
}
