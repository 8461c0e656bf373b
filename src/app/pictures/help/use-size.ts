import { useEffect, useState, type RefObject } from "react";
import type { Size } from "../../../view/camera.ts";
import { usePageUnit } from "../../base/unit.ts";

/**
 * The current size of an element in the units of lettering (CSS pixels over the page's unit); a guess until it is
 * measured. A drawing with this view box grows with the page.
 */
export function useSize(element: RefObject<HTMLElement | null>, guess: Size): Size {
  const unit = usePageUnit();
  const [size, setSize] = useState<Size>(guess);
  useEffect(() => {
    const node = element.current;
    if (!node) return undefined;
    const take = () => {
      const [width, height] = [node.clientWidth / unit, node.clientHeight / unit];
      if (width > 0 && height > 0)
        setSize((old) => (old.width === width && old.height === height ? old : { width, height }));
    };
    take();
    if (typeof ResizeObserver !== "function") return undefined;
    const observer = new ResizeObserver(take);
    observer.observe(node);
    return () => observer.disconnect();
  }, [element, unit]);
  return size;
}
