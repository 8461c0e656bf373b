import { useEffect, useRef, type RefObject } from "react";
import { sizeOf, usePageUnit } from "../../base/unit.ts";
import type { Viewport } from "./viewport.ts";

/** The viewport has the size of the left `share` of the picture's element. */
export function useViewportSize(viewport: Viewport, share = 1): RefObject<HTMLDivElement | null> {
  const stage = useRef<HTMLDivElement>(null),
    unit = usePageUnit();
  useEffect(() => {
    const element = stage.current;
    if (!element) return undefined;
    const measure = () => {
      const { width, height } = sizeOf(element);
      if (width > 0 && height > 0) viewport.setSize({ width: width * share, height });
    };
    measure();
    const sizes = typeof ResizeObserver === "undefined" ? null : new ResizeObserver(measure);
    sizes?.observe(element);
    return () => sizes?.disconnect();
  }, [viewport, share, unit]);
  return stage;
}
