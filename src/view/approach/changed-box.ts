import { wayOf, type MillMotion } from "../../kernel/plane/mill-motion.ts";
import { partSegment, plane } from "../../kernel/plane/plane.ts";
import { part } from "../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { grownBounds, joined } from "../bounds.ts";
import type { Bounds } from "../camera.ts";

/** Limit of motions between two moments that are checked one by one; with more, everything counts as touched. */
const MOST_MOTIONS = 200;

/** The area that a motion reaches between two fractions of its way; an arc counts whole. */
function reachFrom(m: MillMotion, begin: number, end: number): Bounds {
  const way = wayOf(m);
  const run = way.kind === "line" ? plane.line(plane.pointOn(way, begin), plane.pointOn(way, end)) : way;
  return grownBounds(part.boxOf(partSegment(run)), m.radius);
}

/**
 * The box in which the milled stock of two moments may differ, mm: the tool paths between them. Null if there are none,
 * "all" if there are too many to check. A motion that ended between the moments counts whole: its edges are drawn when
 * it is done.
 */
export function changedPlaneBox(
  motions: readonly MillMotion[],
  one: PlayPosition,
  other: PlayPosition,
): Bounds | "all" | null {
  const swap = other.step < one.step || (other.step === one.step && other.fraction < one.fraction);
  const [a, b] = swap ? [other, one] : [one, other];
  if (b.step - a.step > MOST_MOTIONS) return "all";
  let box: Bounds | null = null;
  for (let i = a.step; i <= b.step; i += 1) {
    const m = motions[i],
      end = i < b.step ? 1 : b.fraction;
    if (m && end > 0) box = joined(box, reachFrom(m, i === a.step && i === b.step ? a.fraction : 0, end));
  }
  return box;
}
