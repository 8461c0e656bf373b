import type { Pt, Segment } from "../../kernel/geometry/point.ts";
import type { ContourRow } from "../job/job.ts";

/** Unit of the numbers of a drawing, and where it comes from; "assumed" when the file names none. */
export interface DrawingUnit {
  readonly unit: "mm" | "inch";
  readonly source: "file" | "measurement" | "assumed" | "chosen";
}

/**
 * What a line stands for, by its linetype, its weight and the name of its layer. Contours are made of outlines; centre
 * lines propose the axis; hidden edges and thin lines (threads, dimensions, hatching) are taken only when asked for.
 */
export type LineRole = "outline" | "centre" | "hidden" | "thin";

/** A line or arc of a drawing in mm, drawing x as z and drawing y as r; or a part of a curve made plain. */
export interface DrawnCurve {
  readonly segment: Segment;
  readonly layer: string;
  /** Kind of entity it was made from, as the file calls it: LINE, SPLINE. */
  readonly kind: string;
  readonly role: LineRole;
}

/** Text or dimension of a drawing: shown as a hint, never taken. */
export interface DrawnText {
  readonly text: string;
  readonly at: Pt;
}

/** Values of each note: lengths in mm, x (⌀) and z in part coordinates; `count`: entities. */
export interface NoteValues {
  /** The file is of no kind that is read; `kinds`: those that are. */
  readonly unknownKind: { readonly kinds: string };
  readonly unreadable: { readonly kind: string };
  readonly tooLarge: { readonly limit: number };
  readonly tooMany: { readonly limit: number };
  /** No line or arc in the drawing. */
  readonly nothing: {};
  readonly truncated: {};
  readonly hiddenLayer: { readonly layer: string; readonly count: number };
  readonly invisible: { readonly count: number };
  readonly paperSpace: { readonly count: number };
  /** Model space is empty: the layout was read, whose scale is unknown. */
  readonly paperUsed: {};
  readonly skipped: { readonly kind: string; readonly count: number };
  readonly broken: { readonly count: number };
  readonly missingBlock: { readonly block: string };
  readonly recursiveBlock: { readonly block: string };
  readonly otherPlane: { readonly count: number };
  /** The plane of the drawing is not xy. */
  readonly plane: { readonly plane: string };
  readonly doubled: { readonly count: number };
  readonly fitted: { readonly kind: string; readonly count: number; readonly tolerance: number };
  readonly unitAssumed: { readonly width: number; readonly height: number };
  readonly unitConverted: { readonly unit: string };
  readonly unitsDisagree: { readonly unit: string };
  /** No contour on this side of the axis. */
  readonly noContour: {};
  readonly onlyAxis: {};
  /** Nothing is drawn on the axis or beyond it; `x`: smallest ⌀ of the piece. */
  readonly axisUnmarked: { readonly x: number };
  readonly gapJoined: { readonly width: number; readonly x: number; readonly z: number };
  readonly gapOpen: { readonly width: number; readonly x: number; readonly z: number };
  readonly axisLines: { readonly count: number };
  readonly otherHalf: { readonly count: number };
  readonly otherPieces: { readonly count: number };
  readonly insideLines: { readonly count: number };
  readonly notOutline: { readonly count: number };
  readonly rearFace: { readonly z: number };
  /** Of a solid model: no solid in the file; no face of revolution. */
  readonly noSolid: {};
  readonly noRevolved: {};
  /** Bodies beside the one that was taken; `turned`: of them those that can be taken instead. */
  readonly otherBodies: { readonly name: string; readonly count: number; readonly turned: number };
  /** Faces, holes of the part that are not turned. */
  readonly notTurned: { readonly shape: "flats" | "holes" | "crossHoles" | "others"; readonly count: number };
}
export type NoteCode = keyof NoteValues;

/** What a reader left out, joined or assumed. */
export type DrawingNote = {
  readonly [C in NoteCode]: {
    readonly code: C;
    readonly severity: "error" | "warning" | "info";
    readonly values: NoteValues[C];
    /** Where in the drawing it is, when it has a place; coordinates of the drawing. */
    readonly at?: Pt;
  };
}[NoteCode];

/** A turned body of a solid model: its name, empty if it has none, and about its size, mm. */
export interface DrawnBody {
  readonly name: string;
  readonly across: number;
  readonly length: number;
}

/** What is given before a file is read, in place of what it says or of what is likely. */
export interface DrawingGiven {
  readonly unit?: DrawingUnit["unit"];
  /** Index of the body of a solid model, by `bodies`. */
  readonly body?: number;
}

/** A drawing as lines and arcs in mm, independent of the kind of its file. */
export interface Drawing {
  readonly curves: readonly DrawnCurve[];
  readonly unit: DrawingUnit;
  readonly texts: readonly DrawnText[];
  /** Tolerance within which splines and ellipses were made arcs and lines, mm; 0 when none was. */
  readonly tolerance: number;
  readonly notes: readonly DrawingNote[];
  /** Of a solid model: its turned bodies, that with the largest turned surface first, and the one that is drawn. */
  readonly bodies?: { readonly all: readonly DrawnBody[]; readonly drawn: number };
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
  /** Side of the axis that is taken: upper has the greater coordinates. */
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
  /** Hidden and thin lines are taken as outlines, too. */
  readonly thin: boolean;
  /** Layers that are left out. */
  readonly withoutLayers: readonly string[];
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
