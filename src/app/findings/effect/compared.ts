import { create } from "zustand";
import { useOutcome, type Outcome, type Planned } from "../../calculation/outcome.ts";
import { usePlace } from "../../place/place.ts";
import { openText } from "../../document/printed.ts";
import { openReading } from "../../document/reading.ts";
import { closeStep } from "../../document/steps.ts";
import { change, openContent, useEditor, type Editor } from "../../document/store.ts";
import { chipArea, cutAtOnce, effectNow, type Effect } from "./effect.ts";

/** A setting with its results, for comparison. */
export interface MeasuredSetting {
  readonly outcome: Outcome;
  readonly effect: Effect;
  readonly chip: number | null;
  /** Number of gouges, rapids through material and other findings of the simulation. */
  readonly faults: number;
}

/** The settings that the present one is compared with. */
interface Compared {
  /** The text when the open prompt was opened, and its result once that is known. */
  readonly text: string | null;
  readonly before: MeasuredSetting | null;
  /** The pinned setting, with its state of the work. */
  readonly pinned: (MeasuredSetting & { readonly work: Editor }) | null;
}

const NOTHING: Compared = { text: null, before: null, pinned: null };
export const useCompared = create<Compared>(() => NOTHING);

/** A result with its numbers; those of the run are from a newer planned path if there is one. */
export function settingOf(outcome: Outcome, made: Outcome | Planned = outcome): MeasuredSetting {
  const read = openReading();
  return {
    outcome,
    effect: effectNow(made, outcome),
    chip: read ? chipArea(read, cutAtOnce(made)) : null,
    faults: outcome.simulation.findings.length,
  };
}

/** The newest result, if it belongs to this text. */
function resultOf(text: string | null): MeasuredSetting | null {
  const { newest } = useOutcome.getState();
  return newest !== null && newest.text === text ? settingOf(newest) : null;
}

/** Restarts the comparison from the present state of the work. */
export function restartComparison(): void {
  const text = openText();
  useCompared.setState({ text, before: resultOf(text) });
}

/** Compares each change with the state when the open prompt was opened. */
export function followComparing(): () => void {
  restartComparison();
  const stops = [
    usePlace.subscribe((now, before) => {
      if (now.prompt !== before.prompt) restartComparison();
    }),
    useOutcome.subscribe((now, last) => {
      const { before, text } = useCompared.getState();
      if (now.newest !== last.newest && before === null) useCompared.setState({ before: resultOf(text) });
    }),
    useEditor.subscribe((now, last) => {
      if (now.work !== last.work) useCompared.setState(NOTHING);
    }),
  ];
  return () => {
    for (const stop of stops) stop();
    useCompared.setState(NOTHING);
  };
}

/** Pins the present setting as a reference, or unpins it. */
export function setPinned(on: boolean): void {
  const work = useEditor.getState();
  const now = on ? resultOf(openText(work)) : null;
  useCompared.setState({ pinned: now && { ...now, work } });
}

/** Restores the pinned state of the work, in one step of undo. */
export function restorePinned(): void {
  const { pinned } = useCompared.getState();
  const content = pinned && openContent(pinned.work);
  closeStep();
  if (content) change(() => content);
  closeStep();
}
