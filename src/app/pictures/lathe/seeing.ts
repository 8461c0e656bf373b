import { useSyncExternalStore } from "react";
import type { Pt } from "../../../kernel/geometry/point.ts";
import { toScreen, type Place, type Size } from "../../../view/camera.ts";
import type { Viewport } from "./viewport.ts";

/** Where places of the half plane are seen in a picture, flat or in space: for marks over it. */
export interface Seeing {
  /** Another object whenever places are seen elsewhere. */
  readonly get: () => object;
  readonly subscribe: (listener: () => void) => () => void;
  readonly size: () => Size;
  /** Pixels from the upper left corner; null for what cannot be seen. */
  readonly at: (place: Pt) => Place | null;
}

const flat = new WeakMap<Viewport, Seeing>();

/** How the section is seen. */
export function seenFlat(viewport: Viewport): Seeing {
  const known = flat.get(viewport);
  const { get, subscribe, size } = viewport,
    seeing = known ?? { get, subscribe, size, at: (place: Pt) => toScreen(viewport.get(), place) };
  flat.set(viewport, seeing);
  return seeing;
}

/** Renders anew whenever places are seen elsewhere. */
export function useSeeing(seeing: Seeing): Seeing {
  useSyncExternalStore(seeing.subscribe, seeing.get);
  return seeing;
}
