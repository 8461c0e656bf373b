import type { Measuring } from "../measure/measuring.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { ZOOM } from "./ViewBar.tsx";
import type { Sight } from "./place-projection.ts";

/** An arrow key with Shift pans the picture by this much, pixels. */
const PAN = 40;
const PANS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [PAN, 0],
  ArrowRight: [-PAN, 0],
  ArrowUp: [0, PAN],
  ArrowDown: [0, -PAN],
};

/** A key press in the lathe view, and its target. */
export interface Typed {
  readonly key: string;
  readonly shift: boolean;
  /** Lower-case name of the element that has the focus. */
  readonly element: string;
  /** The focus is in the picture itself. */
  readonly picture: boolean;
}

/** Elements that need these keys for themselves. */
const takes = ({ element, key }: Typed) =>
  element === "select" ||
  element === "textarea" ||
  ((element === "button" || element === "summary") && (key === " " || key === "Enter"));

/** Pans and zooms with a key in a picture; true if it did something. */
export function lookByKey(key: string, shift: boolean, sight: Pick<Sight, "pan" | "zoom" | "fit">): boolean {
  const pan = PANS[key];
  if (shift && pan) sight.pan(pan[0], pan[1]);
  else if (key === "+" || key === "=") sight.zoom(ZOOM);
  else if (key === "-") sight.zoom(1 / ZOOM);
  else if (key === "0") sight.fit();
  else return false;
  return true;
}

/** Handles a key; true if it did something. Ruler keys go first, then playback and zoom. */
export function pressKey(typed: Typed, playback: PlaybackStore, sight: Sight, measuring: Measuring): boolean {
  const { key, shift } = typed;
  if (takes(typed)) return false;
  if (shift && typed.picture && PANS[key]) return lookByKey(key, shift, sight);
  if ((typed.picture || key === "Escape" || (key.length === 1 && typed.element !== "input")) && measuring.key(key))
    return true;
  switch (key) {
    case " ":
      playback.dispatch({ do: "toggle" });
      return true;
    case "ArrowRight":
      playback.dispatch({ do: "forward" });
      return true;
    case "ArrowLeft":
      playback.dispatch({ do: "back" });
      return true;
    case "Home":
      playback.dispatch({ do: "first" });
      return true;
    case "End":
      playback.dispatch({ do: "last" });
      return true;
    default:
      return lookByKey(key, false, sight);
  }
}
