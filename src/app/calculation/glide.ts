import type { PlayPosition } from "../../sim/simulation.ts";
import type { WayBend } from "../../view/bends.ts";
import { positionAt, secondsAt, type Playback, type PlayedTrack } from "../../view/playback.ts";
import type { PlaybackStore } from "./playback-store.ts";

/** The way of something on the page that goes along with a playback. */
export interface GlideWay {
  /** The CSS transform that lays it where it belongs at a position; null where it belongs nowhere, and stays. */
  readonly at: (position: PlayPosition) => string | null;
  /**
   * Where its way bends between two moments, machine seconds, told apart no finer than so many of them. Between bends
   * it goes straight.
   */
  readonly bends: (track: PlayedTrack, between: readonly [number, number], fine: number) => readonly WayBend[];
  /**
   * Goes in jerks, so many a second: all that lies between two things that move is drawn anew with each, where no
   * graphics card helps.
   */
  readonly jerks?: number;
}

/** Something that goes along. */
export interface Gliding {
  /** Its way leads over other places of the page now. */
  readonly again: () => void;
  readonly end: () => void;
}

/**
 * How far ahead the way is told to the browser, and when the next part of it follows, ms; how close together its bends
 * are told.
 */
const AHEAD = 2000,
  NEXT = 1500,
  FINE = 8;
/** Further from where it should be than this it is taken there at once, ms. */
const ASIDE = 4;

/** How a playback goes on by itself: from so many machine seconds at a moment of the clock, ms. */
export interface PlayCourse extends Pick<Playback, "track" | "rate"> {
  readonly from: number;
  readonly since: number;
}

/** Whether a playback at a moment of the clock is where its course took it. */
export const isOnCourse = ({ track, rate, from, since }: PlayCourse, state: Playback, now: number): boolean =>
  track === state.track &&
  rate === state.rate &&
  Math.abs(from - secondsAt(track, state.position) + (rate * (now - since)) / 1000) < (ASIDE * rate) / 1000;

/** A part of the way that was told. */
interface Told extends PlayCourse {
  readonly animation: Animation;
}

function keyframes(
  { at, bends }: GlideWay,
  { track, rate }: Playback,
  [from, to]: readonly [number, number],
): Keyframe[] {
  let last = at(positionAt(track, from));
  const frame = (position: PlayPosition, seconds: number): Keyframe[] => {
    last = at(position) ?? last;
    return last === null ? [] : [{ transform: last, offset: Math.min(1, (seconds - from) / (to - from)) }];
  };
  return [
    ...frame(positionAt(track, from), from),
    ...bends(track, [from, to], (FINE * rate) / 1000).flatMap((b) => [
      ...frame(b.to, b.seconds),
      ...frame(b.from, b.seconds),
    ]),
    ...frame(to >= track.total ? { step: track.ends.length - 1, fraction: 1 } : positionAt(track, to), to),
  ];
}

/**
 * Takes an element along with a playback. While it plays the browser moves the element by itself on a way that it is
 * told in parts, which costs the page nothing in between; at rest, without motion, and where time is held, the element
 * is laid where it belongs.
 */
export function glide(element: HTMLElement, playback: PlaybackStore, way: GlideWay): Gliding {
  let told: Told | null = null;
  const rest = () => {
    const place = way.at(playback.shown());
    if (place !== null) element.style.transform = place;
    told?.animation.cancel();
    told = null;
  };
  const tell = (state: Playback, since: number) => {
    const { track, rate } = state,
      from = secondsAt(track, state.position),
      to = Math.min(track.total, from + (AHEAD * rate) / 1000);
    const frames = to > from ? keyframes(way, state, [from, to]) : [];
    if (frames.length === 0) return rest();
    const duration = (1000 * (to - from)) / rate,
      jerks = way.jerks && Math.ceil((way.jerks * duration) / 1000);
    const animation = element.animate(frames, { duration, fill: "both", ...(jerks && { easing: `steps(${jerks})` }) });
    animation.startTime = since;
    told?.animation.cancel();
    told = { track, rate, from, since, animation };
  };
  const follow = () => {
    const state = playback.get(),
      now = playback.since();
    if (now === null || !("animate" in element)) return rest();
    if (!told || now - told.since > NEXT || !isOnCourse(told, state, now)) tell(state, now);
  };
  const again = () => {
    const now = playback.since();
    if (now === null || !told) rest();
    else tell(playback.get(), now);
  };
  follow();
  const deaf = playback.subscribe(follow);
  return {
    again,
    end() {
      deaf();
      told?.animation.cancel();
    },
  };
}
