import type { Pt, Segment } from "../geometry/point.ts";

/**
 * What is measured: with the caliper across, along or down, between two places, an arc, an angle, the thickness of a
 * wall.
 */
export type MeasuredKind = "diameter" | "length" | "depth" | "distance" | "radius" | "angle" | "wall";

/** What a place was taken from: a corner, the centre of an arc, somewhere on an edge, the end of a move, or nothing. */
export type MeasuredSpot = "corner" | "centre" | "edge" | "path" | "free";

/** The edge that a place was taken from, as it was then. */
export interface MeasuredEdge {
  /** The finished contour, the blank, or the stock of a moment. */
  readonly of: "contour" | "blank" | "stock";
  /** Which of the contours or outlines, and which element of it, from 0. */
  readonly chain: number;
  readonly element: number;
  /** How many contours there were, and what this one consisted of: while that stays, the element is the same one. */
  readonly shape: string;
  /** Never mirrored. */
  readonly segment: Segment;
}

/** A measured place, mm; on a turned part below the axis where the mirrored side was pointed at. */
export interface MeasuredPlace {
  readonly at: Pt;
  readonly spot: MeasuredSpot;
  readonly edge?: MeasuredEdge;
}

/** The moment of a program whose stock was measured: a step, and how much of its way was done. */
export interface MeasuredMoment {
  readonly step: number;
  readonly fraction: number;
  /** Number of the block that runs, and its pass; absent at the end. */
  readonly block?: number;
  readonly pass?: number;
  /** A print of everything that made the stock of this moment. */
  readonly print: string;
}

/** Something measured that stays on the picture: a remark about the work. */
export interface Measurement {
  readonly id: string;
  readonly kind: MeasuredKind;
  /** The half plane of turning, or the working plane of milling. */
  readonly plane: "ZX" | "XY";
  /** One place or two, as the kind needs them. */
  readonly places: readonly MeasuredPlace[];
  /** The middle of its text, where it was put by hand, mm. */
  readonly text?: Pt;
  /** Absent where no stock was measured. */
  readonly moment?: MeasuredMoment;
}
