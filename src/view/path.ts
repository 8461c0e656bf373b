import type { Move } from "../kernel/move.ts";
import type { Pt, Ring, Segment, Turn } from "../kernel/point.ts";

/**
 * Path data in part space: x is z, y is r, both mm. The layer that holds the path carries the camera's matrix,
 * so that zooming touches one attribute and no path.
 */

/** Four decimals are a tenth of what a control can keep; no zeros at the end. */
const n = (v: number) => String(Math.round(v * 1e4) / 1e4 + 0);
const at = (p: Pt) => `${n(p.z)} ${n(p.r)}`;

/** Part space counts turns with X up; in the unflipped path a counter-clockwise turn grows the angle, which is SVG's flag 1. */
function arc(from: Pt, to: Pt, centre: Pt, turn: Turn): string {
  const r = Math.hypot(from.z - centre.z, from.r - centre.r);
  const begin = Math.atan2(from.r - centre.r, from.z - centre.z), end = Math.atan2(to.r - centre.r, to.z - centre.z);
  const forward = turn === "ccw" ? end - begin : begin - end;
  const sweep = ((forward % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  const flag = turn === "ccw" ? 1 : 0;
  if (sweep < 1e-9 && r > 0) {
    const far = `${n(2 * centre.z - from.z)} ${n(2 * centre.r - from.r)}`;
    return `A${n(r)} ${n(r)} 0 0 ${flag} ${far}A${n(r)} ${n(r)} 0 0 ${flag} ${at(to)}`;
  }
  return `A${n(r)} ${n(r)} 0 ${sweep > Math.PI ? 1 : 0} ${flag} ${at(to)}`;
}

/** One motion from where the tip stands; without the leading "M". */
export const moveData = (from: Pt, move: Move): string =>
  move.kind === "arc" ? arc(from, move.to, move.centre, move.turn) : `L${at(move.to)}`;

/** Where a path begins. */
export const startData = (p: Pt): string => `M${at(p)}`;

/** Segments as one path; a gap between two of them begins a new stretch. */
export function segmentData(segments: Iterable<Segment>): string {
  let d = "", last: Pt | null = null;
  for (const s of segments) {
    if (!last || Math.hypot(last.z - s.from.z, last.r - s.from.r) > 1e-6) d += startData(s.from);
    d += s.kind === "arc" ? arc(s.from, s.to, s.centre, s.turn) : `L${at(s.to)}`;
    last = s.to;
  }
  return d;
}

/** Polygons, holes included, as one path for the even-odd rule. */
export const ringData = (rings: Iterable<Ring>): string =>
  [...rings].filter(ring => ring.length > 2).map(ring => `M${ring.map(at).join("L")}Z`).join("");
