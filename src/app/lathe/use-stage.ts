import { useEffect, useRef, type RefObject } from "react";
import { listenToGestures, type Touches } from "./gestures.ts";
import type { Viewport } from "./viewport.ts";

/** The element of the picture: the size of its `share` from the left goes to the viewport, its pointers to zoom, pan and the ruler. */
export function useStage(viewport: Viewport, touches: Touches, share = 1): RefObject<HTMLDivElement | null> {
  const stage = useRef<HTMLDivElement>(null), now = useRef(touches);
  useEffect(() => {
    now.current = touches;
  });
  useEffect(() => {
    const element = stage.current;
    if (!element) return;
    const measure = () => {
      const { clientWidth: width, clientHeight: height } = element;
      if (width > 0 && height > 0) viewport.setSize({ width: Math.round(width * share), height });
    };
    measure();
    const sizes = typeof ResizeObserver === "undefined" ? null : new ResizeObserver(measure);
    sizes?.observe(element);
    const deaf = listenToGestures(element, viewport, {
      tap: (at) => now.current.tap(at),
      hover: (at) => now.current.hover(at),
      get drag() {
        return now.current.drag ?? null;
      },
    });
    return () => {
      deaf();
      sizes?.disconnect();
    };
  }, [viewport, share]);
  return stage;
}
