import type { SegmentOf } from "./segments.ts";
import { spaceOf } from "./space.ts";
import { axial, radius, type Axial, type Radius } from "../units.ts";

/**
 * Part space, mm: z along the spindle axis, positive away from the chuck; r the distance from the axis. Named fields,
 * so that arguments cannot be swapped.
 */
export interface Pt {
  readonly z: Axial;
  readonly r: Radius;
}

/** A closed polygon in part space, without a repeated last point; outer rings run counter-clockwise (z right, r up). */
export type Ring = readonly Pt[];

/** One element of a contour or path in part space; turns are as seen with Z to the right and X up. */
export type Segment = SegmentOf<Pt>;
export type { Turn } from "./segments.ts";

/** A point from bare numbers. */
export const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });

/** Points, lines and arcs of part space. */
export const part = spaceOf<Pt>({ x: (p) => p.z, y: (p) => p.r, point: at });
