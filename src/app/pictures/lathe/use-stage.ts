import { useEffect, useEffectEvent, useRef, type RefObject } from "react";
import { sizeOf, usePageUnit } from "../../base/unit.ts";
import { listenToGestures, type PointerActions } from "./gestures.ts";
import type { Viewport } from "./viewport.ts";

/** The element of the picture. The viewport gets the size of its left `share`; pointers zoom, pan and measure. */
export function useStage(viewport: Viewport, touches: PointerActions, share = 1): RefObject<HTMLDivElement | null> {
  const stage = useRef<HTMLDivElement>(null),
    unit = usePageUnit(),
    now = useEffectEvent(() => touches);
  useEffect(() => {
    const element = stage.current;
    if (!element) return;
    const measure = () => {
      const { width, height } = sizeOf(element);
      if (width > 0 && height > 0) viewport.setSize({ width: width * share, height });
    };
    measure();
    const sizes = typeof ResizeObserver === "undefined" ? null : new ResizeObserver(measure);
    sizes?.observe(element);
    const deaf = listenToGestures(element, viewport, {
      tap: (at) => now().tap(at),
      hover: (at) => now().hover(at),
      get drag() {
        return now().drag ?? null;
      },
    });
    return () => {
      deaf();
      sizes?.disconnect();
    };
  }, [viewport, share, unit]);
  return stage;
}
