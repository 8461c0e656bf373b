import type { Action } from "./types.ts";

/** Whether two actions work in the same place. */
export const isInPlace = (a: Action, b: Action): boolean =>
  Math.min(a.place.front, b.place.front) > Math.max(a.place.rear, b.place.rear) &&
  Math.min(a.place.high, b.place.high) > Math.max(a.place.low, b.place.low);

/** Whether two actions do the same in the same place, with whatever tool. */
export const isSameWork = (a: Action, b: Action): boolean =>
  a.key === b.key || (a.kind === b.kind && a.site === b.site && isInPlace(a, b));
