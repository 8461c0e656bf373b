import type { PlayPosition } from "../../sim/simulation.ts";
import { atStart, reduce, settled, trackOf, type Action, type Playback } from "../../view/playback.ts";
import type { Clock } from "../base/clock.ts";

/** A playback on a clock, for everything on the page that shows or moves it. */
export interface PlaybackStore {
  readonly get: () => Playback;
  /** The position to show: without motion, only ends of moves while it plays. */
  readonly shown: () => PlayPosition;
  /** The clock time of the position, ms; null when paused, with reduced motion, or with a manual clock. */
  readonly since: () => number | null;
  /** Whether time passes by itself. */
  readonly flows: boolean;
  readonly dispatch: (action: Action) => void;
  /** Sets the work that is played: another work starts at its beginning, the same one continues where it is. */
  readonly playsOf: (work: string | null) => void;
  /** Calls after each change; returns a function that unsubscribes. */
  readonly subscribe: (listener: () => void) => () => void;
  /** The same for read-outs: while it plays, no oftener than they can be read. */
  readonly subscribeReader: (listener: () => void) => () => void;
  /** Reduced motion: only the ends of moves are shown. */
  readonly setStill: (still: boolean) => void;
}

/** Shortest readable interval of changing numbers, ms; each change of a text costs the page a layout. */
const READABLE = 120;

/** A new playback of an empty run. Time passes only while it plays, by the clock's frames. */
export function createPlaybackStore(clock: Clock): PlaybackStore {
  let state = atStart(trackOf([]));
  let still = false;
  let stop: (() => void) | null = null;
  let last = 0;
  let read = 0;
  let of: string | null = null;
  const listeners = new Set<() => void>(),
    readers = new Set<() => void>();

  const picture = (now: number) => {
    stop = null;
    const seconds = (now - last) / 1000;
    last = now;
    set(reduce(state, { do: "tick", seconds }), true);
    follow();
  };
  const follow = () => {
    if (state.playing && !stop) stop = clock.frame(picture);
    if (!state.playing && stop) {
      stop();
      stop = null;
    }
  };
  const set = (next: Playback, isTick = false) => {
    if (next === state) return;
    state = next;
    for (const listener of [...listeners]) listener();
    // Read-outs update at once after a click and at the end of the playback.
    if (isTick && next.playing && last - read < READABLE) return;
    read = last;
    for (const reader of [...readers]) reader();
  };
  const subscriber = (all: Set<() => void>) => (listener: () => void) => {
    all.add(listener);
    return () => all.delete(listener);
  };

  const dispatch = (action: Action) => {
    if (!state.playing) last = clock.now();
    set(reduce(state, action));
    follow();
  };

  return {
    get: () => state,
    shown: () => (still && state.playing ? settled(state.position) : state.position),
    flows: clock.flows,
    since: () => (state.playing && !still && clock.flows ? last : null),
    dispatch,
    playsOf(work) {
      const isOther = of !== null && work !== null && work !== of;
      of = work ?? of;
      if (isOther) dispatch({ do: "first" });
    },
    subscribe: subscriber(listeners),
    subscribeReader: subscriber(readers),
    setStill(next) {
      still = next;
    },
  };
}
