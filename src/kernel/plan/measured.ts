import type { Pt, Segment } from "../geometry/point.ts";

/**
 * Kind of measurement: with the caliper across, along or down, between two places, an arc, an angle, the thickness of a
 * wall.
 */
export type MeasuredKind = "diameter" | "length" | "depth" | "distance" | "radius" | "angle" | "wall";

/** What a place was picked on: a corner, the centre of an arc, a point on an edge, the end of a move, or nothing. */
export type MeasuredSpot = "corner" | "centre" | "edge" | "path" | "free";

/** The edge that a place was picked on, as it was at that time. */
export interface MeasuredEdge {
  /** The finished contour, the blank, or the stock at a moment of the program. */
  readonly of: "contour" | "blank" | "stock";
  /** Index of the contour or outline, and of its element, from 0. */
  readonly chain: number;
  readonly element: number;
  /** Number of contours and shape of this one: while both are unchanged, the element is the same. */
  readonly shape: string;
  /** Never mirrored. */
  readonly segment: Segment;
}

/** A measured place, mm; on a turned part below the axis if the mirrored side was picked. */
export interface MeasuredPlace {
  readonly at: Pt;
  readonly spot: MeasuredSpot;
  readonly edge?: MeasuredEdge;
}

/** The moment of a program whose stock was measured: a step, and the fraction of it that was done. */
export interface MeasuredMoment {
  readonly step: number;
  readonly fraction: number;
  /** Number of the block executed, and its pass; absent at the end. */
  readonly block?: number;
  readonly pass?: number;
  /** Fingerprint of everything that made the stock of this moment. */
  readonly print: string;
}

/** A measurement kept on the picture, as a note on the program. */
export interface Measurement {
  readonly id: string;
  readonly kind: MeasuredKind;
  /** The half plane of turning, or the working plane of milling. */
  readonly plane: "ZX" | "XY";
  /** One or two places, depending on the kind. */
  readonly places: readonly MeasuredPlace[];
  /** Middle of its text if placed by hand, mm. */
  readonly text?: Pt;
  /** Absent where no stock was measured. */
  readonly moment?: MeasuredMoment;
}
