import { useEffect, useRef, type RefObject } from "react";
import { sizeOf, usePageUnit } from "../../base/unit.ts";
import type { Viewport } from "./viewport.ts";

/** The size of the picture's element sets the size of the viewport. */
export function useViewportSize(viewport: Viewport): RefObject<HTMLDivElement | null> {
  const stage = useRef<HTMLDivElement>(null),
    unit = usePageUnit();
  useEffect(() => {
    const element = stage.current;
    if (!element) return undefined;
    const measure = () => {
      const size = sizeOf(element);
      if (size.width > 0 && size.height > 0) viewport.setSize(size);
    };
    measure();
    const sizes = new ResizeObserver(measure);
    sizes.observe(element);
    return () => sizes.disconnect();
  }, [viewport, unit]);
  return stage;
}
