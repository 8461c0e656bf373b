import type { PlayPosition } from "../../sim/simulation.ts";
import { atStart, reduce, settled, trackOf, type Action, type Playback } from "../../view/playback.ts";
import type { Clock } from "../base/clock.ts";

/** A playback that runs on a clock, for anything on the page that shows or moves it. */
export interface PlaybackStore {
  readonly get: () => Playback;
  /** The position to show: without motion, only ends of moves while it plays. */
  readonly shown: () => PlayPosition;
  /**
   * The moment of the clock that the position belongs to, ms; null at rest, without motion, and where time does not
   * pass by itself.
   */
  readonly since: () => number | null;
  /** Whether time passes by itself. */
  readonly flows: boolean;
  readonly dispatch: (action: Action) => void;
  /** Says whose run is played from now on: another work begins at its start, the same one goes on where it stands. */
  readonly playsOf: (work: string | null) => void;
  /** Calls after each change; returns what ends it. */
  readonly subscribe: (listener: () => void) => () => void;
  /** The same for what is read and not looked at: while it plays, no oftener than it can be read. */
  readonly subscribeReader: (listener: () => void) => () => void;
  /** Motion as usual, or from end of move to end of move. */
  readonly setStill: (still: boolean) => void;
}

/** Numbers that change oftener than this cannot be read, ms; each change of a text costs the page a layout. */
const READABLE = 120;

/** A new playback of an empty run. Time passes only while it plays, by the clock's pictures. */
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
    // What a press does is read at once, and where the playing ends.
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
