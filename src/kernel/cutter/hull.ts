import { ROUND } from "../tolerance.ts";

/** A corner of a holder from the theoretical tip, mm; x is a radius. */
export type Corner = readonly [z: number, x: number];

const turn = (a: Corner, b: Corner, c: Corner) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/**
 * Convex hull of corners, counter-clockwise, without corners on a straight side; fewer than three when they lie on a
 * line.
 */
export function hullOf(corners: readonly Corner[]): readonly Corner[] {
  const sorted = [...corners].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const side = (order: readonly Corner[]) => {
    const out: Corner[] = [];
    for (const c of order) {
      while (out.length > 1 && turn(out[out.length - 2] as Corner, out[out.length - 1] as Corner, c) <= ROUND)
        out.pop();
      out.push(c);
    }
    return out.slice(0, -1);
  };
  return [...side(sorted), ...side(sorted.reverse())];
}
