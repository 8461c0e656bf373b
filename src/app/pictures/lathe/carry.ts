import type { Pt } from "../../../kernel/geometry/point.ts";
import type { Step } from "../../../kernel/time/step.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { bendsBetween } from "../../../view/bends.ts";
import { tipAt } from "../../../view/tip.ts";
import { glide, type Gliding } from "../../calculation/glide.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** A tip that something on the page goes along with. */
export interface Carrying {
  /** Where it stands now; null: nowhere. */
  readonly tip: () => Pt | null;
  /** Calls when it has moved; returns what ends it. */
  readonly follow: (listener: () => void) => () => void;
  /** Takes an element along: `place` gives the transform that lays it where it belongs; null where that is nowhere. */
  readonly carry: (element: HTMLElement, place: (tip: Pt) => string | null) => Gliding;
}

/** A place of its own at each moment of a playback; within some steps its way is round. */
export const movingTip = (
  playback: PlaybackStore,
  tipOf: (position: PlayPosition) => Pt | null,
  isRound: (step: number) => boolean,
): Carrying => ({
  tip: () => tipOf(playback.shown()),
  follow: playback.subscribe,
  carry: (element, place) =>
    glide(element, playback, {
      at(position) {
        const tip = tipOf(position);
        return tip && place(tip);
      },
      bends: (track, between, fine) => bendsBetween(track, between, fine, isRound),
    }),
});

/** The tip of the running move. */
export const runningTip = (steps: readonly Step[], playback: PlaybackStore): Carrying =>
  movingTip(
    playback,
    (position) => tipAt(steps, position),
    (step) => steps[step]?.move.kind === "arc",
  );

/** A tip that stays where it is. */
export const restingTip = (at: Pt): Carrying => ({
  tip: () => at,
  follow: () => () => undefined,
  carry(element, place) {
    const again = () => {
      element.style.transform = place(at) ?? "";
    };
    again();
    return { again, end: () => undefined };
  },
});
