import { useEffect, useEffectEvent, type RefObject } from "react";
import { listenToGestures, type PointerActions } from "./gestures.ts";
import { useViewportSize } from "./use-viewport-size.ts";
import type { Viewport } from "./viewport.ts";

/** The element of the picture. The viewport gets the size of its left `share`; pointers zoom, pan and measure. */
export function useStage(viewport: Viewport, touches: PointerActions, share = 1): RefObject<HTMLDivElement | null> {
  const stage = useViewportSize(viewport, share),
    now = useEffectEvent(() => touches);
  useEffect(() => {
    const element = stage.current;
    if (!element) return undefined;
    return listenToGestures(element, viewport, {
      tap: (at) => now().tap(at),
      hover: (at) => now().hover(at),
      get drag() {
        return now().drag ?? null;
      },
    });
  }, [stage, viewport]);
  return stage;
}
