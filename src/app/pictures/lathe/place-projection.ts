import { useSyncExternalStore } from "react";
import type { Pt } from "../../../kernel/geometry/point.ts";
import { toScreen, type Place, type Size } from "../../../view/camera.ts";
import type { Viewport } from "./viewport.ts";

/** Maps places of the half plane to pixels of a picture, flat or in space, for marks over it. */
export interface PlaceProjection {
  /** Returns another object whenever the mapping changes. */
  readonly get: () => object;
  readonly subscribe: (listener: () => void) => () => void;
  readonly size: () => Size;
  /** Pixels from the upper left corner; null if not visible. */
  readonly at: (place: Pt) => Place | null;
}

const flat = new WeakMap<Viewport, PlaceProjection>();

/** The mapping of the section view. */
export function sectionProjection(viewport: Viewport): PlaceProjection {
  const known = flat.get(viewport);
  const { get, subscribe, size } = viewport,
    seeing = known ?? { get, subscribe, size, at: (place: Pt) => toScreen(viewport.get(), place) };
  flat.set(viewport, seeing);
  return seeing;
}

/** Re-renders whenever the mapping changes. */
export function useProjection(seeing: PlaceProjection): PlaceProjection {
  useSyncExternalStore(seeing.subscribe, seeing.get);
  return seeing;
}
