import { panned, pinched, type Place } from "../../../view/camera.ts";
import { placeIn } from "../../base/unit.ts";
import type { Viewport } from "./viewport.ts";

/** Pointer actions of a picture besides panning and zooming. */
export interface PointerActions {
  /** A click without a drag. */
  readonly tap: (at: Place) => void;
  /** The pointer hovers over the picture. */
  readonly hover: (at: Place | null) => void;
  /** Handles drags of one pointer, from their start to the current place; null leaves them to panning. */
  readonly drag?: ((from: Place, to: Place, done: boolean, byFinger?: boolean) => void) | null;
  /** Whether a drag from this place is one of those; without it all are. */
  readonly grabs?: (from: Place, byFinger: boolean) => boolean;
}

/** A pointer that moved less than this is a click, pixels. */
const TAP = 6;
/** Zoom per wheel pixel. */
const WHEEL = 0.0015;

/** Wheel zooms, one pointer pans, two pinch. Returns the function that removes the listeners. */
export function listenToGestures(
  element: Element & GlobalEventHandlers,
  viewport: Pick<Viewport, "get" | "look" | "zoom">,
  touches: PointerActions,
): () => void {
  const down = new Map<number, Place>();
  let begun: Place | null = null;
  let dragged = false;
  /** Start of a drag that is not panning. */
  let drawn: Place | null = null;

  /** Last position of the mouse on the page. */
  let rests: Place | null = null;
  /** Browsers repeat mouse events at the same position when something appears or disappears under it. */
  const isResting = ({ pointerType, clientX: x, clientY: y }: PointerEvent): boolean => {
    const before = rests;
    rests = { x, y };
    return pointerType === "mouse" && before?.x === x && before.y === y;
  };
  const enter = (event: PointerEvent) => {
    if (event.movementX === 0 && event.movementY === 0) isResting(event);
  };

  const placeOf = (event: MouseEvent): Place => placeIn(element, event);
  const press = (event: PointerEvent) => {
    if (event.pointerType === "mouse" && event.button !== 0 && event.button !== 1) return;
    if (event.target instanceof Element && event.target.closest("button, .measure-panel")) return;
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, placeOf(event));
    if (down.size === 1) {
      begun = placeOf(event);
      dragged = false;
    } else dragged = true;
    drawn = null;
  };
  const move = (event: PointerEvent) => {
    const before = down.get(event.pointerId),
      here = placeOf(event),
      rested = isResting(event);
    if (!before) return rested ? undefined : touches.hover(here);
    const [other] = [...down].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    if (!dragged && begun && Math.hypot(here.x - begun.x, here.y - begun.y) < TAP) return;
    const from = dragged || !begun ? before : begun;
    const grabs = begun && (touches.grabs?.(begun, event.pointerType === "touch") ?? true);
    if (!dragged && !other && touches.drag && grabs) drawn = begun;
    dragged = true;
    down.set(event.pointerId, here);
    if (drawn) return touches.drag?.(drawn, here, false, event.pointerType === "touch");
    viewport.look(
      other
        ? pinched(viewport.get(), [before, other], [here, other])
        : panned(viewport.get(), here.x - from.x, here.y - from.y),
    );
  };
  const release = (event: PointerEvent) => {
    if (!down.delete(event.pointerId)) return;
    if (down.size > 0 || event.type !== "pointerup") return;
    if (drawn) touches.drag?.(drawn, placeOf(event), true, event.pointerType === "touch");
    else if (!dragged) touches.tap(placeOf(event));
  };
  const leave = () => {
    rests = null;
    touches.hover(null);
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 33 : 1;
    viewport.zoom(Math.exp(-event.deltaY * lines * WHEEL), placeOf(event));
  };

  element.addEventListener("pointerenter", enter);
  element.addEventListener("pointerdown", press);
  element.addEventListener("pointermove", move);
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
  element.addEventListener("pointerleave", leave);
  element.addEventListener("wheel", wheel, { passive: false });
  return () => {
    element.removeEventListener("pointerenter", enter);
    element.removeEventListener("pointerdown", press);
    element.removeEventListener("pointermove", move);
    element.removeEventListener("pointerup", release);
    element.removeEventListener("pointercancel", release);
    element.removeEventListener("pointerleave", leave);
    element.removeEventListener("wheel", wheel);
  };
}
