import type { Pt } from "../../kernel/point.ts";
import type { Step } from "../../kernel/step.ts";
import { bendsBetween } from "../../view/bends.ts";
import { tipAt } from "../../view/tip.ts";
import { glide, type Gliding } from "./glide.ts";
import type { PlaybackStore } from "./playback-store.ts";

/** A tip that something on the page goes along with. */
export interface Carrying {
  /** Where it stands now; null: nowhere. */
  readonly tip: () => Pt | null;
  /** Calls when it has moved; returns what ends it. */
  readonly follow: (listener: () => void) => () => void;
  /** Takes an element along: `place` gives the transform that lays it where it belongs; null where that is nowhere. */
  readonly carry: (element: HTMLElement, place: (tip: Pt) => string | null) => Gliding;
}

/** The tip of the running move. */
export const runningTip = (steps: readonly Step[], playback: PlaybackStore): Carrying => ({
  tip: () => tipAt(steps, playback.shown()),
  follow: playback.subscribe,
  carry: (element, place) =>
    glide(element, playback, {
      at(position) {
        const tip = tipAt(steps, position);
        return tip && place(tip);
      },
      bends: (track, between, fine) => bendsBetween(track, between, fine, (step) => steps[step]?.move.kind === "arc"),
    }),
});

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
