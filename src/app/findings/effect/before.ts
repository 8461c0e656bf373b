import { create } from "zustand";
import { useOutcome, type Outcome, type Planned } from "../../calculation/outcome.ts";
import { usePlace } from "../../place/place.ts";
import { printedText } from "../../document/printed.ts";
import { readJob } from "../../document/reading.ts";
import { closeStep } from "../../document/steps.ts";
import { changeProgram, edit, useEditor, type Editor } from "../../document/store.ts";
import { chipArea, cutAtOnce, effectNow, type Effect } from "./effect.ts";

/** A setting with what came of it, to compare another one with. */
export interface MeasuredSetting {
  readonly outcome: Outcome;
  readonly effect: Effect;
  readonly chip: number | null;
  /** Gouges, rapids in material, and what else the simulation met. */
  readonly faults: number;
}

/** What the present setting is compared with. */
interface Compared {
  /** The text at the moment when the open prompt opened, and what came of it once that is known. */
  readonly text: string | null;
  readonly before: MeasuredSetting | null;
  /** The setting that was pinned, with the work that it is. */
  readonly pinned: (MeasuredSetting & { readonly work: Editor }) | null;
}

const NOTHING: Compared = { text: null, before: null, pinned: null };
export const useCompared = create<Compared>(() => NOTHING);

const textOf = ({ job, program }: Editor): string | null => (job ? printedText(job) : (program?.text ?? null));

/** A result with its numbers; those of the run are of a newer path where one is planned that is not proved yet. */
export function settingOf(outcome: Outcome, made: Outcome | Planned = outcome): MeasuredSetting {
  const { job } = useEditor.getState();
  const read = job && readJob(job);
  return {
    outcome,
    effect: effectNow(made, outcome),
    chip: read ? chipArea(read, cutAtOnce(made)) : null,
    faults: outcome.simulation.findings.length,
  };
}

/** The newest result, where it is that of a text. */
function resultOf(text: string | null): MeasuredSetting | null {
  const { newest } = useOutcome.getState();
  return newest !== null && newest.text === text ? settingOf(newest) : null;
}

/** The comparison begins anew: with the work as it stands now. */
export function compareFromHere(): void {
  const text = textOf(useEditor.getState());
  useCompared.setState({ text, before: resultOf(text) });
}

/** From now on each change is compared with the state in which the open prompt was when it opened. */
export function followComparing(): () => void {
  compareFromHere();
  const stops = [
    usePlace.subscribe((now, before) => {
      if (now.prompt !== before.prompt) compareFromHere();
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

/** Keeps the present setting to compare others with, or lets it go. */
export function pin(on: boolean): void {
  const work = useEditor.getState();
  const now = on ? resultOf(textOf(work)) : null;
  useCompared.setState({ pinned: now && { ...now, work } });
}

/** The work becomes what it was when it was pinned, in one step of undo. */
export function takeBackPinned(): void {
  const { pinned } = useCompared.getState();
  const { job, program } = pinned?.work ?? {};
  if (program) return changeProgram(() => program);
  closeStep();
  if (job) edit(() => job);
  closeStep();
}
