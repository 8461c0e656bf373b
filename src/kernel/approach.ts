import type { Issue } from "./issue.ts";
import type { PlanePoint, PlaneSegment, Side } from "./plane.ts";
import type { Turn } from "./point.ts";

/** The geometry of APPR and DEP. The polar forms (PLT, PLN, PCT, PLCT) differ only in how their point is written. */
export type ApproachShape = "LT" | "LN" | "CT" | "LCT";

/** What an approach or a departure is made from. Lengths mm, angles degrees; a missing word is absent. */
export interface ApproachRequest {
  readonly shape: ApproachShape;
  readonly departing: boolean;
  /** RL, RR or R0: for APPR of its own block, for DEP of the contour before it. */
  readonly side: Side;
  /** Radius of the mill, or of the nose. */
  readonly toolRadius: number;
  /** First (APPR) or last (DEP) element of the programmed contour. */
  readonly element: PlaneSegment;
  /** APPR: the tool centre before the block (PS). DEP LCT: the programmed end point PN. Null where nobody knows or none is needed. */
  readonly outside: PlanePoint | null;
  /** LEN of LT and LN, with its sign. */
  readonly length?: number;
  /** R of CT and LCT, with its sign. */
  readonly radius?: number;
  /** CCA of CT. */
  readonly centreAngle?: number;
}

export type PointName = "PS" | "PH" | "PA" | "PE" | "PN";
/** The points that a form has, each on the path of the tool centre. */
export type NamedPoints = { readonly [N in PointName]?: PlanePoint };

/** One leg of the path, in the order of travel. */
export interface ApproachLeg {
  readonly segment: PlaneSegment;
  /** "before": at the feed (or rapid) programmed last before the block; "block": at the feed of the block. */
  readonly feed: "before" | "block";
}

/** How the tool centre comes onto the contour (PS, PH, PA) or leaves it (PE, PH, PN). What is impossible is left out and reported. */
export interface Approach {
  readonly shape: ApproachShape;
  readonly departing: boolean;
  readonly side: Side;
  readonly points: NamedPoints;
  readonly legs: readonly ApproachLeg[];
  /** Direction of the contour in PA or PE, length 1. */
  readonly tangent: PlanePoint;
  /** The arc of CT and LCT: centre angle in degrees. */
  readonly arc: { readonly centre: PlanePoint; readonly radius: number; readonly angle: number; readonly turn: Turn } | null;
  readonly issues: readonly Issue[];
}
