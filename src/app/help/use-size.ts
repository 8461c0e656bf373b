import { useEffect, useState, type RefObject } from "react";
import type { Size } from "../../view/camera.ts";

/** The size of an element in CSS pixels, kept up to date; a guess until it is measured. */
export function useSize(element: RefObject<HTMLElement | null>, guess: Size): Size {
  const [size, setSize] = useState<Size>(guess);
  useEffect(() => {
    const node = element.current;
    if (!node) return undefined;
    const take = () => {
      const { clientWidth: width, clientHeight: height } = node;
      if (width > 0 && height > 0) setSize((old) => (old.width === width && old.height === height ? old : { width, height }));
    };
    take();
    if (typeof ResizeObserver !== "function") return undefined;
    const observer = new ResizeObserver(take);
    observer.observe(node);
    return () => observer.disconnect();
  }, [element]);
  return size;
}
