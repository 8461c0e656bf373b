import type { Bounds, Size } from "../../../view/camera.ts";
import {
  zoomedOrbit,
  namedView,
  nearTo,
  orbited,
  projected,
  slid,
  viewBetween,
  type NamedView,
  type Orbit,
} from "../../../view/solid/orbit.ts";
import type { Clock } from "../../base/clock.ts";
import type { Sight } from "../lathe/place-projection.ts";

/** The viewpoint, followed by what draws the body. */
export interface Eye {
  readonly get: () => Orbit;
  readonly size: () => Size;
  readonly subscribe: (listener: () => void) => () => void;
  /** Turns by angles in radians, at once, as it follows a finger. */
  readonly turn: (turn: number, rise: number) => void;
  readonly slide: (dx: number, dy: number) => void;
  readonly zoom: (factor: number) => void;
  readonly go: (view: NamedView) => void;
  /** Returns to the last named view, so that the whole body is visible. */
  readonly fit: () => void;
  /** Zooms to a box of the half plane, from its side; `down`: X grows downwards. */
  readonly show: (bounds: Bounds, down: boolean) => void;
  readonly setSize: (size: Size) => void;
  /** Sets the visible bounds; `isFlat`: only lines in the plane of the tool, no body. */
  readonly setBounds: (bounds: Bounds, isFlat?: boolean) => void;
  /** Ends the running movement. */
  readonly end: () => void;
}

/** Duration of a movement to a named view, ms. */
const WAY = 200;
const START: Bounds = { left: -80, right: 20, low: 0, high: 40 };

const isSame = (a: Bounds, b: Bounds) =>
  a.left === b.left && a.right === b.right && a.low === b.low && a.high === b.high;

/** Creates an eye in the isometric view. `still`: without motion views change at once. */
export function createEye(clock: Clock, still: () => boolean): Eye {
  let size: Size = { width: 640, height: 400 };
  let bounds = START;
  let flat = false;
  let byHand = false;
  let name: NamedView = "iso";
  const named = () => namedView(name, bounds, size, flat);
  let orbit = named();
  let stop: (() => void) | null = null;
  /** Goal of the running movement. */
  let goal: Orbit | null = null;
  const listeners = new Set<() => void>();
  const set = (next: Orbit) => {
    orbit = next;
    for (const listener of [...listeners]) listener();
  };
  const end = () => {
    stop?.();
    stop = goal = null;
  };
  /** A hand continues from the goal of a movement, so that choosing a view and turning it both count. */
  const look = (change: (from: Orbit) => Orbit) => {
    const from = goal ?? orbit;
    end();
    byHand = true;
    set(change(from));
  };
  const flyTo = (to: Orbit, hand: boolean) => {
    end();
    byHand = hand;
    const from = orbit,
      begun = clock.now();
    if (still()) return set(to);
    goal = to;
    const picture = (now: number) => {
      const share = (now - begun) / WAY;
      stop = share < 1 ? clock.frame(picture) : null;
      if (!stop) goal = null;
      set(viewBetween(from, to, share));
    };
    stop = clock.frame(picture);
  };
  const fly = () => flyTo(named(), false);
  const refit = () => {
    end();
    set(byHand ? { ...orbit } : named());
  };

  return {
    get: () => orbit,
    size: () => size,
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    turn: (turn, rise) => look((from) => orbited(from, turn, rise)),
    slide: (dx, dy) => look((from) => slid(from, dx, dy, size)),
    zoom: (factor) => look((from) => zoomedOrbit(from, factor)),
    go(view) {
      name = view;
      fly();
    },
    fit: fly,
    show: (near, down) => flyTo(nearTo(goal ?? orbit, near, down), true),
    setSize(next) {
      if (next.width === size.width && next.height === size.height) return;
      size = next;
      refit();
    },
    setBounds(next, isFlat = false) {
      if (isSame(next, bounds) && isFlat === flat) return;
      [bounds, flat] = [next, isFlat];
      refit();
    },
    end,
  };
}

/** Maps places of the section to the view of an eye, in the plane of the tool. `down`: X grows downwards. */
export const spaceProjection = ({ get, subscribe, size, slide, zoom, fit, show }: Eye, down: boolean): Sight => ({
  get,
  subscribe,
  size,
  at: ({ z, r }) => projected(get(), size(), [down ? -r : r, 0, z]),
  pan: slide,
  zoom: (factor) => zoom(factor),
  fit,
  show: (bounds) => show(bounds, down),
});
