import { at, direction } from "./curve.ts";
import type { Pt, Segment, Turn } from "./point.ts";
import { ARC_END, ROUND, SAME } from "./tolerance.ts";

/** A straight segment. */
export const line = (from: Pt, to: Pt): Segment => ({ kind: "line", from, to });

/**
 * An arc by its end, radius (mm; negative: the longer way round) and turn. When the radius can not span the two points,
 * `nearest` is the smallest that can, on the grid a control prints.
 */
export function arcByRadius(from: Pt, to: Pt, radius: number, turn: Turn): { readonly segment: Segment | null; readonly nearest: number } {
  const [dz, dr] = [to.z - from.z, to.r - from.r];
  const chord = Math.hypot(dz, dr);
  const nearest = (Math.ceil((chord / 2) * 1000 - 1e-6) / 1000) * (radius < 0 ? -1 : 1);
  if (chord <= SAME || chord / 2 - Math.abs(radius) > ARC_END / 2) return { segment: null, nearest };
  const height = Math.sqrt(Math.max(0, radius * radius - (chord * chord) / 4));
  const side = (turn === "ccw") === radius > 0 ? height / chord : -height / chord;
  const centre = at((from.z + to.z) / 2 - dr * side, (from.r + to.r) / 2 + dz * side);
  return { segment: { kind: "arc", from, to, centre, turn }, nearest };
}

/** The arc (or line) that leaves a segment in its direction and ends in `to`; null when that would have to turn back. */
export function arcTangential(before: Segment, to: Pt): Segment | null {
  const from = before.to;
  const way = direction(before, from);
  const [dz, dr] = [to.z - from.z, to.r - from.r];
  const aside = way.z * dr - way.r * dz;
  const square = dz * dz + dr * dr;
  if (Math.abs(aside) <= ROUND * Math.max(1, square)) return way.z * dz + way.r * dr > 0 ? line(from, to) : null;
  const k = square / (2 * aside);
  return { kind: "arc", from, to, centre: at(from.z - way.r * k, from.r + way.z * k), turn: k > 0 ? "ccw" : "cw" };
}
