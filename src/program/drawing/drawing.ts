import type { Pt, Segment } from "../../kernel/geometry/point.ts";
import type { ContourRow } from "../job/job.ts";

/** Unit of the numbers of a drawing, and where it comes from; "assumed" when the file names none. */
export interface DrawingUnit {
  readonly unit: "mm" | "inch";
  readonly source: "file" | "measurement" | "assumed" | "chosen";
}

/** A line or arc of a drawing in mm, drawing x as z and drawing y as r; or a part of a curve made plain. */
export interface DrawnCurve {
  readonly segment: Segment;
  readonly layer: string;
  /** Kind of entity it was made from, as the file calls it: LINE, SPLINE. */
  readonly kind: string;
  /** Linetype of a centre line: a proposal for the axis, never part of a contour. */
  readonly isCentreLine: boolean;
}

/** Text or dimension of a drawing: shown as a hint, never taken. */
export interface DrawnText {
  readonly text: string;
  readonly at: Pt;
}

/** What a reader left out, joined or assumed; sizes in mm. `count`: entities. */
export interface DrawingNote {
  readonly code: string;
  readonly severity: "error" | "warning" | "info";
  readonly values: Readonly<Record<string, string | number>>;
  /** Where in the drawing it is, when it has a place. */
  readonly at?: Pt;
}

/** A drawing as lines and arcs in mm, independent of the kind of its file. */
export interface Drawing {
  readonly curves: readonly DrawnCurve[];
  readonly unit: DrawingUnit;
  readonly texts: readonly DrawnText[];
  /** Tolerance within which splines and ellipses were made arcs and lines, mm; 0 when none was. */
  readonly tolerance: number;
  readonly notes: readonly DrawingNote[];
}

/** How the contour of a turned part is taken from a drawing; places in mm of the drawing. */
export interface ContourChoice {
  /** Direction of the axis of rotation in the drawing, and its distance from the drawing's origin. */
  readonly axis: "x" | "y";
  readonly axisAt: number;
  /** Place of Z0 along the axis. */
  readonly zero: number;
  /** Z runs against the direction of the drawing. */
  readonly mirrored: boolean;
  /** Side of the axis that is taken. */
  readonly half: "upper" | "lower";
  /** Distances from the axis are diameters. */
  readonly diameters: boolean;
  /** Index of the piece, 0 for the likeliest. */
  readonly piece: number;
  /** Of a closed section: the outside or the bore. */
  readonly side: "outside" | "bore";
  /** Ends no farther apart are joined, mm. */
  readonly gap: number;
  /** The contour runs from its other end. */
  readonly reversed: boolean;
}

/** Connected curves of one half, to be picked on the picture; curves as indexes into the drawing. */
export interface DrawnPiece {
  readonly curves: readonly number[];
  readonly closed: boolean;
  readonly length: number;
}

/** Contour of a choice: rows of the table, and the same as lines and arcs in part coordinates (mm, r as radius). */
export interface DrawnContour {
  readonly rows: readonly ContourRow[];
  readonly segments: readonly Segment[];
  /** Pieces to choose from under this axis and half, the likeliest first. */
  readonly pieces: readonly DrawnPiece[];
  /** Whether the piece has both an outside and a bore. */
  readonly hasSides: boolean;
  readonly notes: readonly DrawingNote[];
}
