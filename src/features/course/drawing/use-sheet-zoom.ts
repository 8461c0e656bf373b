import {
  useEffect,
  useEffectEvent,
  useLayoutEffect,
  useRef,
  useState,
  type KeyboardEvent,
  type MouseEvent,
  type RefObject,
} from "react";
import type { Place } from "../../../view/camera.ts";

/** Zoom factor of a button or key, and largest scale, pixels per millimetre. */
const STEP = 1.25,
  MOST = 16;
/** A mouse that moved further since its press drags the sheet, pixels. */
export const DRAG = 6;
/** Zoom per wheel pixel. */
const WHEEL = 0.0025;

export interface SheetZoom {
  /** Pixels per millimetre, in page units. */
  readonly scale: number;
  readonly larger: () => void;
  readonly smaller: () => void;
  /** Shows all of it. */
  readonly whole: () => void;
  /** Double click: the clicked place at readable scale, then the whole sheet again. */
  readonly turn: (event: MouseEvent) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}

/**
 * Zoom of a sheet in a scrolling frame: at first `begin`, and at least `fit`, which shows all of it; a double click
 * zooms to `readable`. Two fingers and the wheel with Ctrl zoom about their place, the mouse drags; one finger and the arrow
 * keys scroll.
 */
export function useSheetZoom(
  frame: RefObject<HTMLElement | null>,
  fit: number,
  readable: number,
  begin = fit,
): SheetZoom {
  const [chosen, choose] = useState<number | null>(null);
  const scale = Math.min(MOST, Math.max(fit, chosen ?? begin));
  /** The fixed point of the zoom, as shares of the sheet, and its position in the frame. */
  const kept = useRef<{ readonly share: Place; readonly at: Place } | null>(null);
  const boxes = (node: HTMLElement) =>
    [node, node.firstElementChild ?? node].map((each) => each.getBoundingClientRect()) as [DOMRect, DOMRect];
  useLayoutEffect(() => {
    const { current: node } = frame,
      { current: stays } = kept;
    kept.current = null;
    if (!node || !stays) return;
    const [view, sheet] = boxes(node),
      { share, at } = stays;
    node.scrollBy(
      sheet.left + share.x * sheet.width - view.left - at.x,
      sheet.top + share.y * sheet.height - view.top - at.y,
    );
  }, [frame, scale]);

  const zoom = (factor: number, about?: Place) => {
    const { current: node } = frame;
    if (!node) return;
    const at = about ?? { x: node.clientWidth / 2, y: node.clientHeight / 2 },
      [view, sheet] = boxes(node);
    kept.current = {
      share: { x: (view.left + at.x - sheet.left) / sheet.width, y: (view.top + at.y - sheet.top) / sheet.height },
      at,
    };
    choose(Math.min(MOST, Math.max(fit, scale * factor)));
  };

  const placed = (
    node: HTMLElement,
    points: readonly { readonly clientX: number; readonly clientY: number }[],
  ): Place => {
    const box = node.getBoundingClientRect();
    const middle = (each: (point: { readonly clientX: number; readonly clientY: number }) => number) =>
      points.reduce((sum, point) => sum + each(point), 0) / points.length;
    return { x: middle((p) => p.clientX) - box.left, y: middle((p) => p.clientY) - box.top };
  };
  const turned = useEffectEvent((event: WheelEvent, node: HTMLElement) =>
    zoom(Math.exp(-event.deltaY * WHEEL), placed(node, [event])),
  );
  const pinched = useEffectEvent((factor: number, touches: readonly Touch[], node: HTMLElement) =>
    zoom(factor, placed(node, touches)),
  );
  useEffect(() => {
    const { current: node } = frame;
    if (!node) return undefined;
    let apart = 0;
    const stop = new AbortController(),
      { signal } = stop;
    node.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        turned(event, node);
      },
      { passive: false, signal },
    );
    // One finger scrolls natively; two would zoom the whole page.
    const hold = (event: TouchEvent) => {
      const [a, b] = [...event.touches];
      if (!a || !b) return;
      event.preventDefault();
      const now = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      if (event.type === "touchmove" && apart > 0) pinched(now / apart, [a, b], node);
      apart = now;
    };
    node.addEventListener("touchstart", hold, { passive: false, signal });
    node.addEventListener("touchmove", hold, { passive: false, signal });
    // The mouse drags once it has moved: until then a press belongs to what is under it.
    let pressed: Place | null = null;
    const isMouse = ({ pointerType, button }: PointerEvent) => pointerType === "mouse" && button === 0;
    node.addEventListener(
      "pointerdown",
      (event) => void (pressed = isMouse(event) ? { x: event.clientX, y: event.clientY } : null),
      { signal },
    );
    node.addEventListener(
      "pointermove",
      (event) => {
        if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > DRAG) {
          pressed = null;
          node.setPointerCapture(event.pointerId);
        }
        if (node.hasPointerCapture(event.pointerId)) node.scrollBy(-event.movementX, -event.movementY);
      },
      { signal },
    );
    for (const end of ["pointerup", "pointercancel", "pointerleave"] as const)
      node.addEventListener(end, () => void (pressed = null), { signal });
    return () => stop.abort();
  }, [frame]);

  const turn = (event: MouseEvent) => {
    const { current: node } = frame;
    if (node)
      zoom(scale > fit * STEP ? fit / scale : Math.max(readable / scale, STEP * STEP * STEP), placed(node, [event]));
  };
  const larger = () => zoom(STEP),
    smaller = () => zoom(1 / STEP),
    whole = () => choose(fit);
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "+" || event.key === "=") larger();
    else if (event.key === "-") smaller();
    else if (event.key === "0") whole();
  };
  return { scale, larger, smaller, whole, turn, onKeyDown };
}
