import type { PlayPosition } from "../sim/simulation.ts";

/**
 * Playing a run back, as a pure state machine. A position is a move and how much of it is done; seconds are machine
 * time (feeds and rapids as programmed), and the rate says how many of them pass in one second of the clock.
 */

/** When each move ends, seconds from the start of the run. */
export interface PlayedTrack {
  readonly ends: readonly number[];
  readonly total: number;
}

export interface Playback {
  readonly track: PlayedTrack;
  readonly position: PlayPosition;
  readonly playing: boolean;
  /** Machine seconds per second of the clock. */
  readonly rate: number;
}

export type Action =
  | { readonly do: "play" | "pause" | "toggle" | "forward" | "back" | "first" | "last" }
  | { readonly do: "seek"; readonly position: PlayPosition }
  | { readonly do: "seekSeconds"; readonly seconds: number }
  | { readonly do: "rate"; readonly rate: number }
  /** So many seconds of the clock have gone by. */
  | { readonly do: "tick"; readonly seconds: number }
  /** Another run takes the place of this one. */
  | { readonly do: "load"; readonly track: PlayedTrack };

/** The offered rates. */
export const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 25, 50, 100] as const;

const START: PlayPosition = { step: 0, fraction: 0 };

type Timed = readonly { readonly seconds: number }[];

/** Cache: several callers need the track of the same run. */
const tracks = new WeakMap<Timed, PlayedTrack>();

/** The track of moves that last so long; a duration that is no number counts as none. */
export function trackOf(steps: Timed): PlayedTrack {
  const known = tracks.get(steps);
  if (known) return known;
  let total = 0;
  const ends = steps.map((s) => (total += Number.isFinite(s.seconds) && s.seconds > 0 ? s.seconds : 0));
  const track = { ends, total };
  tracks.set(steps, track);
  return track;
}

/** The playback before anything is loaded or played. */
export const atStart = (track: PlayedTrack, rate = 1): Playback => ({ track, position: START, playing: false, rate });

const count = (track: PlayedTrack) => track.ends.length;
const begin = (track: PlayedTrack, step: number) =>
  step > 0 ? (track.ends[Math.min(step, count(track)) - 1] ?? 0) : 0;
const endOf = (track: PlayedTrack): PlayPosition => ({ step: count(track), fraction: 0 });
const isEnd = (p: Playback) => p.position.step >= count(p.track);

/** Machine seconds from the start of the run to a position. */
export function secondsAt(track: PlayedTrack, position: PlayPosition): number {
  const from = begin(track, position.step),
    to = track.ends[position.step];
  return to === undefined ? track.total : from + (to - from) * position.fraction;
}

/** The position after so many machine seconds; moves that take no time are passed at once. */
export function positionAt(track: PlayedTrack, seconds: number): PlayPosition {
  if (!(seconds > 0)) return START;
  if (seconds >= track.total) return endOf(track);
  let low = 0,
    high = count(track) - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((track.ends[middle] ?? 0) > seconds) high = middle;
    else low = middle + 1;
  }
  const from = begin(track, low),
    lasts = (track.ends[low] ?? from) - from;
  return inRange(track, { step: low, fraction: lasts > 0 ? (seconds - from) / lasts : 0 });
}

/** The nearest position that exists on a track. */
export function inRange(track: PlayedTrack, { step, fraction }: PlayPosition): PlayPosition {
  const whole = Math.floor(step);
  if (!(whole >= 0)) return START;
  if (whole >= count(track)) return endOf(track);
  if (!(fraction > 0)) return { step: whole, fraction: 0 };
  return fraction >= 1 ? inRange(track, { step: whole + 1, fraction: 0 }) : { step: whole, fraction };
}

const moved = (p: Playback, position: PlayPosition): Playback => ({ ...p, position: inRange(p.track, position) });

/** The same place in another run: its start stays the start, its end the end, else the same second. */
function loaded(p: Playback, track: PlayedTrack): Playback {
  const same =
    p.track.ends.length === track.ends.length
      ? inRange(track, p.position)
      : positionAt(track, secondsAt(p.track, p.position));
  const position = isEnd(p) && count(p.track) > 0 ? endOf(track) : same;
  return { ...p, track, position, playing: p.playing && position.step < count(track) };
}

/** What the playback does next. */
export function reduce(p: Playback, action: Action): Playback {
  switch (action.do) {
    case "play":
      if (count(p.track) === 0) return p;
      return { ...(isEnd(p) ? moved(p, START) : p), playing: true };
    case "pause":
      return { ...p, playing: false };
    case "toggle":
      return reduce(p, { do: p.playing ? "pause" : "play" });
    case "forward":
      return { ...moved(p, { step: p.position.step + 1, fraction: 0 }), playing: false };
    case "back":
      return {
        ...moved(p, { step: p.position.fraction > 0 ? p.position.step : p.position.step - 1, fraction: 0 }),
        playing: false,
      };
    case "first":
      return { ...moved(p, START), playing: false };
    case "last":
      return { ...moved(p, endOf(p.track)), playing: false };
    case "seek":
      return moved(p, action.position);
    case "seekSeconds":
      return moved(p, positionAt(p.track, action.seconds));
    case "rate":
      return { ...p, rate: Math.min(100, Math.max(0.1, action.rate)) };
    case "tick": {
      if (!p.playing || !(action.seconds > 0)) return p;
      const next = moved(p, later(p, action.seconds * p.rate));
      return isEnd(next) ? { ...next, playing: false } : next;
    }
    case "load":
      return loaded(p, action.track);
  }
}

/** Advances the time; never backwards, even with the rounding errors of long runs. */
function later(p: Playback, seconds: number): PlayPosition {
  const next = positionAt(p.track, secondsAt(p.track, p.position) + seconds);
  const back = next.step < p.position.step || (next.step === p.position.step && next.fraction < p.position.fraction);
  return back ? p.position : next;
}

/** Without motion, playback shows the end of the last whole move. */
export const settled = (position: PlayPosition): PlayPosition => ({ step: position.step, fraction: 0 });
