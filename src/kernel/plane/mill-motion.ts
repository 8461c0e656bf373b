import { plane, type PlanePoint, type PlaneSegment } from "./plane.ts";
import type { Turn } from "../geometry/point.ts";

/** A position of a mill, mm: its centre in the plane, its end in the tool axis (null while unknown). */
export interface MillSpot {
  readonly x: number;
  readonly y: number;
  readonly z: number | null;
}

/**
 * An arc in a plane other than the working plane: its centre in the axes of that plane, its turn from the first axis to
 * the second.
 */
interface SideArc {
  readonly plane: "YZ" | "ZX";
  readonly centre: { readonly x?: number; readonly y?: number; readonly z?: number };
  readonly turn: Turn;
}

/** One motion of a mill, with the data that picture and stock need. */
export interface MillMotion {
  readonly kind: "rapid" | "feed" | "arc";
  readonly from: MillSpot;
  readonly to: MillSpot;
  readonly centre?: PlanePoint;
  readonly turn?: Turn;
  readonly side?: SideArc;
  /** Absent on a rapid. */
  readonly feed?: number;
  /** Radius of the tool, mm; 0 if unknown. */
  readonly radius: number;
  readonly index: number;
}

/** A rapid may run on an arc, so only a missing feed identifies it. */
export const isRapid = (m: MillMotion): boolean => m.feed === undefined;

/** The path of a motion in the plane. */
export const wayOf = ({ from, to, centre, turn }: MillMotion): PlaneSegment =>
  centre && turn ? { kind: "arc", from, to, centre, turn } : { kind: "line", from, to };

/** Tool position on an arc outside the working plane: the third axis moves evenly. */
function spotOnSide(
  { from, to }: MillMotion,
  { plane: across, centre, turn }: SideArc,
  fraction: number,
): MillSpot | null {
  if (from.z === null || to.z === null || centre.z === undefined) return null;
  const even = (a: number, b: number) => a + (b - a) * fraction;
  if (across === "YZ") {
    if (centre.y === undefined) return null;
    const ends = { from: { x: from.y, y: from.z }, to: { x: to.y, y: to.z }, centre: { x: centre.y, y: centre.z } };
    const on = plane.pointOn({ kind: "arc", ...ends, turn }, fraction);
    return { x: even(from.x, to.x), y: on.x, z: on.y };
  }
  if (centre.x === undefined) return null;
  const ends = { from: { x: from.z, y: from.x }, to: { x: to.z, y: to.x }, centre: { x: centre.z, y: centre.x } };
  const on = plane.pointOn({ kind: "arc", ...ends, turn }, fraction);
  return { x: on.y, y: even(from.y, to.y), z: on.x };
}

/** Tool position at a fraction of a motion. */
export function spotOn(m: MillMotion, fraction: number): MillSpot {
  const beside = m.side && spotOnSide(m, m.side, fraction);
  if (beside) return beside;
  const at = plane.pointOn(wayOf(m), fraction);
  const z = m.to.z === null ? m.from.z : m.from.z === null ? m.to.z : m.from.z + (m.to.z - m.from.z) * fraction;
  return { ...at, z };
}
