import type { Pt } from "../../../kernel/geometry/point.ts";
import type { Step } from "../../../kernel/time/step.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { directionChanges } from "../../../view/direction-changes.ts";
import { tipAt } from "../../../view/tip.ts";
import { glide, type Gliding } from "../../calculation/glide.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** A tip that page elements follow. */
export interface MovingAnchor {
  /** Its position; null: nowhere. */
  readonly tip: () => Pt | null;
  /** Calls the listener after each move; returns the function that stops it. */
  readonly follow: (listener: () => void) => () => void;
  /** Moves an element with the tip. `place` gives its transform; null if it has no place. */
  readonly carry: (element: HTMLElement, place: (tip: Pt) => string | null) => Gliding;
}

/** A tip with a position for each moment of a playback; in `isRound` steps it moves along an arc. */
export const movingTip = (
  playback: PlaybackStore,
  tipOf: (position: PlayPosition) => Pt | null,
  isRound: (step: number) => boolean,
): MovingAnchor => ({
  tip: () => tipOf(playback.shown()),
  follow: playback.subscribe,
  carry: (element, place) =>
    glide(element, playback, {
      at(position) {
        const tip = tipOf(position);
        return tip && place(tip);
      },
      bends: (track, between, fine) => directionChanges(track, between, fine, isRound),
    }),
});

/** The tip of the running move. */
export const runningTip = (steps: readonly Step[], playback: PlaybackStore): MovingAnchor =>
  movingTip(
    playback,
    (position) => tipAt(steps, position),
    (step) => steps[step]?.move.kind === "arc",
  );

/** A tip that stays where it is. */
export const restingTip = (at: Pt): MovingAnchor => ({
  tip: () => at,
  follow: () => () => undefined,
  carry(element, place) {
    const recompute = () => {
      element.style.transform = place(at) ?? "";
    };
    recompute();
    return { recompute, end: () => undefined };
  },
});
