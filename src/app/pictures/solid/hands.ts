import type { Place } from "../../../view/camera.ts";
import { placeIn } from "../../base/unit.ts";
import type { Eye } from "./eye.ts";

/** Radians for each pixel of a drag, zoom for each pixel of the wheel. */
const TURN = 0.008;
const WHEEL = 0.0015;
/** Radians, pixels and zoom for each press of a key. */
const KEY = { turn: Math.PI / 18, slide: 40, zoom: 1.25 } as const;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const VIEWS = { 1: "iso", 2: "front", 3: "end" } as const;
const isView = (key: string): key is `${keyof typeof VIEWS}` => key in VIEWS;

/** Handles a key of the eye; false if it has none. Arrows turn, with Shift they pan; digits choose named views. */
export function eyeKey(eye: Eye, { key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">): boolean {
  const arrow = ARROWS[key];
  if (arrow && shiftKey) eye.slide(-arrow[0] * KEY.slide, arrow[1] * KEY.slide);
  else if (arrow) eye.turn(arrow[0] * KEY.turn, arrow[1] * KEY.turn);
  else if (key === "+" || key === "=") eye.zoom(KEY.zoom);
  else if (key === "-") eye.zoom(1 / KEY.zoom);
  else if (key === "0") eye.fit();
  else if (isView(key)) eye.go(VIEWS[key]);
  else return false;
  return true;
}

/**
 * One pointer turns, two pan and zoom; so does the wheel, and the right or middle button pans. The picture below gets
 * none of these events. Returns the function that removes the listeners.
 */
export function listenToHands(element: HTMLElement, eye: Eye): () => void {
  const down = new Map<number, Place>(),
    sliding = new Set<number>(),
    ending = new AbortController();
  const listen = <Name extends keyof HTMLElementEventMap>(
    name: Name,
    hear: (event: HTMLElementEventMap[Name]) => void,
  ) => element.addEventListener(name, hear, { passive: false, signal: ending.signal });
  const release = (event: PointerEvent) => {
    event.stopPropagation();
    down.delete(event.pointerId);
    sliding.delete(event.pointerId);
  };

  listen("pointerdown", (event) => {
    event.stopPropagation();
    if (event.target instanceof Element && event.target.closest("button")) return;
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, placeIn(element, event));
    if (event.button > 0 || event.shiftKey) sliding.add(event.pointerId);
  });
  listen("pointermove", (event) => {
    event.stopPropagation();
    const before = down.get(event.pointerId),
      here = placeIn(element, event);
    if (!before) return;
    const [other] = [...down].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    down.set(event.pointerId, here);
    const [dx, dy] = [here.x - before.x, here.y - before.y];
    if (other) {
      const apart = (p: Place) => Math.hypot(p.x - other.x, p.y - other.y);
      eye.slide(dx / 2, dy / 2);
      if (apart(before) > 1) eye.zoom(apart(here) / apart(before));
    } else if (sliding.has(event.pointerId)) eye.slide(dx, dy);
    else eye.turn(-dx * TURN, dy * TURN);
  });
  listen("pointerup", release);
  listen("pointercancel", release);
  listen("contextmenu", (event) => event.preventDefault());
  listen("wheel", (event) => {
    event.preventDefault();
    event.stopPropagation();
    eye.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 33 : 1) * WHEEL));
  });
  listen("keydown", (event) => {
    if (event.target !== element || event.ctrlKey || event.metaKey || event.altKey || !eyeKey(eye, event)) return;
    event.preventDefault();
    event.stopPropagation();
  });
  return () => ending.abort();
}
