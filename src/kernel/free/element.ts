import type { Turn } from "../geometry/segments.ts";
import type { PlanePoint } from "../plane/plane.ts";

/** A number that is given outright, or counted from that of the end point of element `of` (0: the start point). */
export type FreeValue = { readonly at: number } | { readonly by: number; readonly of: number } | null;

/** A point given by its distance and angle (radians) from a pole. */
export interface FromPole {
  readonly pole: PlanePoint;
  readonly radius: FreeValue;
  readonly angle: FreeValue;
}

/**
 * An element of a free contour with what is given of it: lengths in one unit, angles in radians, counter-clockwise from
 * the first axis. Elements count from 1; 0 is what stands before the contour.
 */
export interface FreeElement {
  readonly kind: "line" | "arc";
  /** It leaves the element before it in that one's direction. */
  readonly tangent: boolean;
  readonly x: FreeValue;
  readonly y: FreeValue;
  readonly polar: FromPole | null;
  /** Direction of a line; of an arc that in which it begins. Counted from the direction of a line where it says so. */
  readonly angle: FreeValue;
  /** Length of a line, chord of an arc. */
  readonly length: number | null;
  /** Of an arc. */
  readonly turn: Turn;
  readonly radius: number | null;
  readonly centreX: FreeValue;
  readonly centreY: FreeValue;
  readonly centrePolar: FromPole | null;
  readonly sweep: number | null;
  /** Points that it, or its extension, runs through. */
  readonly through: readonly PlanePoint[];
  /** A point at a distance from it. */
  readonly beside: { readonly point: PlanePoint; readonly distance: number } | null;
  /** A line that a line is parallel to, and how far from it. */
  readonly parallel: { readonly of: number; readonly distance: number | null } | null;
  /** Its end point is the end point of this element. */
  readonly closes: number | null;
}

/**
 * The whole line or circle that an element lies on; a line by its direction and its distance from zero, to the left.
 */
export type Curve =
  | { readonly kind: "line"; readonly angle: number; readonly offset: number }
  | { readonly kind: "arc"; readonly centre: PlanePoint; readonly radius: number; readonly turn: Turn };
