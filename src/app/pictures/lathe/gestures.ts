import { panned, pinched, type Place } from "../../../view/camera.ts";
import type { Viewport } from "./viewport.ts";

/** What the picture does with a pointer beside looking around. */
export interface Touches {
  /** A press without a drag. */
  readonly tap: (at: Place) => void;
  /** The pointer moves over the picture without pressing. */
  readonly hover: (at: Place | null) => void;
  /**
   * Takes drags of one pointer for itself, from where they began to where they are; null leaves them to looking around.
   */
  readonly drag?: ((from: Place, to: Place, done: boolean, byFinger?: boolean) => void) | null;
}

/** A pointer that moved less than this was a tap, pixels. */
const TAP = 6;
/** Zoom per wheel pixel. */
const WHEEL = 0.0015;

/** Wheel zooms, one pointer drags, two pinch. Returns what takes it all off again. */
export function listenToGestures(
  element: Element & GlobalEventHandlers,
  viewport: Viewport,
  touches: Touches,
): () => void {
  const down = new Map<number, Place>();
  let begun: Place | null = null;
  let dragged = false;
  /** A drag that is not looking around, by where it began. */
  let drawn: Place | null = null;

  /** Where the mouse was heard of last, on the page. */
  let rests: Place | null = null;
  /** Browsers tell of a mouse again where it rests when something comes or goes under it: nobody moved it. */
  const isResting = ({ pointerType, clientX: x, clientY: y }: PointerEvent): boolean => {
    const before = rests;
    rests = { x, y };
    return pointerType === "mouse" && before?.x === x && before.y === y;
  };
  const enter = (event: PointerEvent) => {
    if (event.movementX === 0 && event.movementY === 0) isResting(event);
  };

  const placeOf = (event: MouseEvent): Place => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
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
    if (!dragged && !other && touches.drag) drawn = begun;
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
