import { useEffect, useRef, type RefObject } from "react";
import type { Viewport } from "./viewport.ts";

/** The size of the picture's element sets the size of the viewport. */
export function useViewportSize(viewport: Viewport): RefObject<HTMLDivElement | null> {
  const stage = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = stage.current;
    if (!element) return undefined;
    const measure = () => {
      const { clientWidth: width, clientHeight: height } = element;
      if (width > 0 && height > 0) viewport.setSize({ width, height });
    };
    measure();
    const sizes = new ResizeObserver(measure);
    sizes.observe(element);
    return () => sizes.disconnect();
  }, [viewport]);
  return stage;
}
