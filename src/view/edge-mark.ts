import type { Place } from "./camera.ts";

/** The visible area of a picture, CSS pixels. */
export interface VisibleArea {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/**
 * The mark of a place outside the visible area: the nearest point on the edge, and the direction to the place, degrees
 * clockwise from right.
 */
export interface EdgeMark {
  readonly at: Place;
  readonly turn: number;
}

/** The mark of a place outside the visible area; null if the place is visible. */
export function edgeMark(place: Place, { left, right, top, bottom }: VisibleArea): EdgeMark | null {
  const at = { x: Math.min(right, Math.max(left, place.x)), y: Math.min(bottom, Math.max(top, place.y)) };
  if (at.x === place.x && at.y === place.y) return null;
  return { at, turn: (Math.atan2(place.y - at.y, place.x - at.x) * 180) / Math.PI };
}
