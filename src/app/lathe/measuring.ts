import { useState } from "react";
import type { Pt } from "../../kernel/point.ts";
import { toPlace, type Place } from "../../view/camera.ts";
import { nudged, snappedPoint } from "../../view/measure.ts";
import type { Viewport } from "./viewport.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** A pointer this near to a point of the drawing means that point, pixels. */
const REACH = 12;
/** One arrow key, pixels. */
const NUDGE = 2;

interface State {
  readonly on: boolean;
  /** Where the cross stands. */
  readonly cross: Pt | null;
  readonly first: Pt | null;
  readonly second: Pt | null;
}

/** The ruler: two places, picked by pointer or by keys. */
export interface Measuring extends State {
  readonly toggle: () => void;
  readonly tap: (at: Place) => void;
  readonly hover: (at: Place | null) => void;
  /** Measures from where a pointer was pressed to where it is. */
  readonly drag: (from: Place, to: Place, done: boolean) => void;
  /** True when the key was meant for the ruler. */
  readonly key: (name: string) => boolean;
}

const OFF: State = { on: false, cross: null, first: null, second: null };

const picked = (s: State, place: Pt): State =>
  s.first && !s.second ? { ...s, cross: place, second: place } : { ...s, cross: place, first: place, second: null };

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** A ruler over a viewport that snaps to these points. */
export function useMeasuring(viewport: Viewport, points: readonly Pt[]): Measuring {
  const [state, set] = useState<State>(OFF);
  const placeOf = (at: Place) => snappedPoint(toPlace(viewport.get(), at), points, REACH / viewport.get().scale);
  const middle = () => {
    const { width, height } = viewport.size();
    return placeOf({ x: width / 2, y: height / 2 });
  };
  const next = (from: Pt, way: number): Pt => {
    const here = points.findIndex((p) => Math.hypot(p.z - from.z, p.r - from.r) < SAME);
    const at = here < 0 ? (way > 0 ? 0 : points.length - 1) : (here + way + points.length) % points.length;
    return points[at] ?? from;
  };
  return {
    ...state,
    toggle: () => set((s) => (s.on ? OFF : { ...OFF, on: true, cross: middle() })),
    tap: (at) => set((s) => (s.on ? picked(s, placeOf(at)) : s)),
    hover: (at) => set((s) => (s.on && at ? { ...s, cross: placeOf(at) } : s)),
    drag: (from, to, done) =>
      set((s) => (s.on ? { ...s, cross: placeOf(to), first: placeOf(from), second: done ? placeOf(to) : null } : s)),
    key(name) {
      if (!state.on) return false;
      const { scale, xUp } = viewport.get(), cross = state.cross ?? middle(), arrow = ARROWS[name];
      if (name === "Escape") set(OFF);
      else if (name === "Enter") set(picked(state, cross));
      else if (name === "n" || name === "N") set({ ...state, cross: next(cross, 1) });
      else if (name === "p" || name === "P") set({ ...state, cross: next(cross, -1) });
      else if (arrow) set({ ...state, cross: nudged(cross, (arrow[0] * NUDGE) / scale, ((xUp ? 1 : -1) * arrow[1] * NUDGE) / scale) });
      else return false;
      return true;
    },
  };
}
