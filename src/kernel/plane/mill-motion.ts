import { plane, type PlanePoint, type PlaneSegment } from "./plane.ts";
import type { Turn } from "../geometry/point.ts";

/** A place of a mill, mm: its centre in the plane, its end in the tool axis (null while unknown). */
export interface MillSpot {
  readonly x: number;
  readonly y: number;
  readonly z: number | null;
}

/**
 * An arc in a plane beside that of the tool axis: its centre in the axes of that plane, its turn from the first axis to
 * the second.
 */
interface SideArc {
  readonly plane: "YZ" | "ZX";
  readonly centre: { readonly x?: number; readonly y?: number; readonly z?: number };
  readonly turn: Turn;
}

/** One motion of a mill, as far as its picture and its stock need it. */
export interface MillMotion {
  readonly kind: "rapid" | "feed" | "arc";
  readonly from: MillSpot;
  readonly to: MillSpot;
  readonly centre?: PlanePoint;
  readonly turn?: Turn;
  readonly side?: SideArc;
  /** Absent on a rapid. */
  readonly feed?: number;
  /** Of the tool, mm; 0 when nobody knows it. */
  readonly radius: number;
  readonly index: number;
}

/** A rapid may run on an arc, so it is told by its feed. */
export const isRapid = (m: MillMotion): boolean => m.feed === undefined;

/** The way of a motion in the plane. */
export const wayOf = ({ from, to, centre, turn }: MillMotion): PlaneSegment =>
  centre && turn ? { kind: "arc", from, to, centre, turn } : { kind: "line", from, to };

/** Where the tool stands on an arc beside the plane: the third axis goes evenly. */
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

/** Where the tool stands at a fraction of a motion. */
export function spotOn(m: MillMotion, fraction: number): MillSpot {
  const beside = m.side && spotOnSide(m, m.side, fraction);
  if (beside) return beside;
  const at = plane.pointOn(wayOf(m), fraction);
  const z = m.to.z === null ? m.from.z : m.from.z === null ? m.to.z : m.from.z + (m.to.z - m.from.z) * fraction;
  return { ...at, z };
}
