import type { Place } from "./camera.ts";

/** What a picture shows, CSS pixels. */
export interface Seen {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/**
 * Where a place beyond the edge is pointed to: the nearest place on the edge, and which way it lies, degrees clockwise
 * from right.
 */
export interface EdgeMark {
  readonly at: Place;
  readonly turn: number;
}

/** The mark of a place that is not to be seen; null where it is. */
export function edgeMark(place: Place, { left, right, top, bottom }: Seen): EdgeMark | null {
  const at = { x: Math.min(right, Math.max(left, place.x)), y: Math.min(bottom, Math.max(top, place.y)) };
  if (at.x === place.x && at.y === place.y) return null;
  return { at, turn: (Math.atan2(place.y - at.y, place.x - at.x) * 180) / Math.PI };
}
