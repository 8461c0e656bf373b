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

/** The same with its camera: what the tools and keys of a view move. */
export interface Sight extends PlaceProjection, Pick<Viewport, "pan" | "zoom" | "fit" | "show"> {}

const flat = new WeakMap<Viewport, Sight>();

/** The mapping of a flat picture. */
export function sectionProjection(viewport: Viewport): Sight {
  const seeing = flat.get(viewport) ?? { ...viewport, at: (place: Pt) => toScreen(viewport.get(), place) };
  flat.set(viewport, seeing);
  return seeing;
}

/** Re-renders whenever the mapping changes. */
export function useProjection(seeing: PlaceProjection): PlaceProjection {
  useSyncExternalStore(seeing.subscribe, seeing.get);
  return seeing;
}
