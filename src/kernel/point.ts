import type { Axial, Radius } from "./units.ts";

/**
 * Part space, mm: z along the spindle axis, positive away from the chuck; r the distance from the axis.
 * Named fields, never pairs, so no argument order can be wrong.
 */
export interface Pt {
  readonly z: Axial;
  readonly r: Radius;
}

/** A closed polygon in part space, without a repeated last point; outer rings run counter-clockwise (z right, r up). */
export type Ring = readonly Pt[];

/** Turning direction as seen with Z to the right and X up; DR+ is "ccw". */
export type Turn = "cw" | "ccw";

/** One element of a contour or path in part space. An arc keeps its centre; it is never flattened here. */
export type Segment =
  | { readonly kind: "line"; readonly from: Pt; readonly to: Pt }
  | { readonly kind: "arc"; readonly from: Pt; readonly to: Pt; readonly centre: Pt; readonly turn: Turn };
