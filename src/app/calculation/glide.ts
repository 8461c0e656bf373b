import type { PlayPosition } from "../../sim/simulation.ts";
import type { DirectionChange } from "../../view/direction-changes.ts";
import { positionAt, secondsAt, type Playback, type PlayedTrack } from "../../view/playback.ts";
import type { PlaybackStore } from "./playback-store.ts";

/** The path of an element that follows a playback. */
export interface GlideWay {
  /** The CSS transform at a position; null if there is none, and the element stays. */
  readonly at: (position: PlayPosition) => string | null;
  /**
   * Bends of the path between two times, machine seconds, no closer than `fine` seconds. Between bends the path is
   * straight.
   */
  readonly bends: (track: PlayedTrack, between: readonly [number, number], fine: number) => readonly DirectionChange[];
  /**
   * Steps per second, if the element moves in steps: without a graphics card each frame redraws everything between two
   * moving elements.
   */
  readonly jerks?: number;
}

/** The handle of an element that follows a playback. */
export interface Gliding {
  /** The path has changed: animates it again. */
  readonly recompute: () => void;
  readonly end: () => void;
}

/** Length of the animation sent ahead and age at which the next is sent; smallest distance of bends. All in ms. */
const AHEAD = 2000,
  NEXT = 1500,
  FINE = 8;
/** Largest deviation before the element jumps to its position, ms. */
const ASIDE = 4;

/** A running playback: from `from` machine seconds at the clock time `since`, ms. */
export interface PlayCourse extends Pick<Playback, "track" | "rate"> {
  readonly from: number;
  readonly since: number;
}

/** Whether a playback at a clock time is where its course predicts. */
export const isOnCourse = ({ track, rate, from, since }: PlayCourse, state: Playback, now: number): boolean =>
  track === state.track &&
  rate === state.rate &&
  Math.abs(from - secondsAt(track, state.position) + (rate * (now - since)) / 1000) < (ASIDE * rate) / 1000;

/** A part of the path that was sent to the browser. */
interface SentAnimation extends PlayCourse {
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
 * Moves an element with a playback. While it plays the browser animates the element along parts of its path, which
 * costs the page nothing in between; when paused, with reduced motion, or with a manual clock, the element is placed
 * directly.
 */
export function glide(element: HTMLElement, playback: PlaybackStore, way: GlideWay): Gliding {
  let told: SentAnimation | null = null;
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
  const recompute = () => {
    const now = playback.since();
    if (now === null || !told) rest();
    else tell(playback.get(), now);
  };
  follow();
  const deaf = playback.subscribe(follow);
  return {
    recompute,
    end() {
      deaf();
      told?.animation.cancel();
    },
  };
}
