import type { Turn } from "../geometry/segments.ts";
import type { PlanePoint } from "../plane/plane.ts";

/** A given number: absolute, or relative to the end point of element `of` (0: the start point). */
export type FreeValue = { readonly at: number } | { readonly by: number; readonly of: number } | null;

/** A point given by its distance and angle (radians) from a pole. */
export interface FromPole {
  readonly pole: PlanePoint;
  readonly radius: FreeValue;
  readonly angle: FreeValue;
}

/**
 * An element of a free contour with its given values: lengths in one unit, angles in radians, counter-clockwise from
 * the first axis. Elements count from 1; 0 is the element before the contour.
 */
export interface FreeElement {
  readonly kind: "line" | "arc";
  /** Continues the previous element tangentially. */
  readonly tangent: boolean;
  readonly x: FreeValue;
  readonly y: FreeValue;
  readonly polar: FromPole | null;
  /** Direction of a line, or start direction of an arc; relative to the direction of a line if stated so. */
  readonly angle: FreeValue;
  /** Length of a line, chord of an arc. */
  readonly length: number | null;
  /** Arcs only. */
  readonly turn: Turn;
  readonly radius: number | null;
  readonly centreX: FreeValue;
  readonly centreY: FreeValue;
  readonly centrePolar: FromPole | null;
  readonly sweep: number | null;
  /** Points that the element, or its extension, runs through. */
  readonly through: readonly PlanePoint[];
  /** A point at a given distance from the element. */
  readonly distancePoint: { readonly point: PlanePoint; readonly distance: number } | null;
  /** The line that this line is parallel to, and the distance between them. */
  readonly parallel: { readonly of: number; readonly distance: number | null } | null;
  /** The element whose end point is also the end point of this one. */
  readonly closes: number | null;
}

/**
 * The whole line or circle that an element lies on; a line by its direction and its distance from the origin, positive
 * to the left.
 */
export type Curve =
  | { readonly kind: "line"; readonly angle: number; readonly offset: number }
  | { readonly kind: "arc"; readonly centre: PlanePoint; readonly radius: number; readonly turn: Turn };
