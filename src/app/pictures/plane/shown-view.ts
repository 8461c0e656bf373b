import { create } from "zustand";
import type { PathChoice } from "../../../program/run/path-index.ts";
import { crossing, momentOn, motionsOf, sideOfChoice, type MachineSide } from "../../../program/run/plane-index.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { trackOf } from "../../../view/playback.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** The chosen picture of a program with turning and milling; null leaves it to the program. */
interface AskedView {
  readonly asked: MachineSide | null;
  /** Chosen by the switch: stays during playback, until something of the other picture is chosen. */
  readonly byHand: boolean;
}

export const useAskedView = create<AskedView>(() => ({ asked: null, byHand: false }));

type Paths = Pick<Run, "plane" | "steps" | "stepBlocks">;

/** True if the working plane is shown; milling cannot be seen in the section of the lathe. */
export const showsPlane = (run: Paths, asked: MachineSide | null): boolean =>
  run.plane.length > 0 && (run.steps.length === 0 || asked === "plane");

const shownSide = (run: Paths): MachineSide => (showsPlane(run, useAskedView.getState().asked) ? "plane" : "lathe");

/** Index of the block of a step of the shown picture; null in an empty program. */
export function shownBlock(run: Paths, step: number): number | null {
  if (shownSide(run) === "plane") return run.plane[Math.min(step, run.plane.length - 1)]?.index ?? null;
  return run.stepBlocks[Math.min(step, run.steps.length - 1)] ?? null;
}

/** Shows one picture. Steps refer to its path from now on, so that a seek is right before the picture is there. */
function show(run: Paths, playback: PlaybackStore, side: MachineSide, byHand: boolean): void {
  playback.dispatch({ do: "load", track: trackOf(motionsOf(run, side)) });
  useAskedView.setState({ asked: side, byHand });
}

/** Switches the picture at the same moment of the program. */
export function switchSide(run: Paths, playback: PlaybackStore, side: MachineSide): void {
  if (shownSide(run) === side) return useAskedView.setState({ asked: side, byHand: true });
  const step = momentOn(run, side, playback.get().position.step);
  show(run, playback, side, true);
  playback.dispatch({ do: "seek", position: { step, fraction: 0 } });
}

/** Shows the picture that has the chosen item. */
export function showSide(run: Paths, playback: PlaybackStore, side: MachineSide): void {
  if (run.plane.length > 0 && run.steps.length > 0 && shownSide(run) !== side) show(run, playback, side, false);
}

/** Shows the picture of a choice; true for the working plane. */
export function showChoice(run: Run, playback: PlaybackStore, choice: PathChoice): boolean {
  const side = sideOfChoice(run, choice);
  if (side !== null) showSide(run, playback, side);
  return shownSide(run) === "plane";
}

/**
 * Switches the picture during playback to the one in which the program continues. Returns the function that stops it.
 */
export function followProgramSides(run: Paths, playback: PlaybackStore): () => void {
  let last = playback.get();
  return playback.subscribe(() => {
    const before = last,
      now = playback.get(),
      side = shownSide(run);
    last = now;
    if (!before.playing || useAskedView.getState().byHand || before.track !== now.track) return;
    const next =
      now.position.step > before.position.step ? crossing(run, side, before.position.step, now.position.step) : null;
    if (next === null) return;
    show(run, playback, side === "plane" ? "lathe" : "plane", false);
    playback.dispatch({ do: "seek", position: { step: next, fraction: 0 } });
    playback.dispatch({ do: "play" });
  });
}
