import type { Pt } from "../../../kernel/geometry/point.ts";

/** Store of the place under the pointer, which changes without rendering the view. */
export interface PointedPlace {
  readonly get: () => Pt | null;
  readonly set: (place: Pt | null) => void;
  readonly subscribe: (listener: () => void) => () => void;
}

/** Creates one without a place. */
export function createPointedPlace(): PointedPlace {
  const listeners = new Set<() => void>();
  let place: Pt | null = null;
  return {
    get: () => place,
    set(next) {
      if (next === place) return;
      place = next;
      for (const listener of [...listeners]) listener();
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
