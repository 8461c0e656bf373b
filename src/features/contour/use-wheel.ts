import { useEffect, useEffectEvent, type RefObject } from "react";
import type { Place } from "../../view/camera.ts";
import { placeIn } from "../../app/base/unit.ts";

/** Zoom per wheel pixel, and pixels of one line. */
const WHEEL = 0.0015,
  LINE = 33;

/** The wheel zooms about the pointer. Uses a native listener, since the page must not scroll along. */
export function useWheel(element: RefObject<HTMLElement | null>, zoom: (factor: number, at: Place) => void): void {
  const turned = useEffectEvent((e: WheelEvent, node: HTMLElement) => {
    zoom(Math.exp(-e.deltaY * (e.deltaMode === 1 ? LINE : 1) * WHEEL), placeIn(node, e));
  });
  useEffect(() => {
    const node = element.current;
    if (!node) return undefined;
    const onWheel = (e: WheelEvent) => {
      e.preventDefault();
      turned(e, node);
    };
    node.addEventListener("wheel", onWheel, { passive: false });
    return () => node.removeEventListener("wheel", onWheel);
  }, [element]);
}
