import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { choiceOf } from "../../../program/run/path-index.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { draftOf } from "../../../app/document/edits.ts";
import { chooseFinding } from "../../../app/document/chosen-finding.ts";
import { showPrompt, usePlace } from "../../../app/place/place.ts";
import { playback } from "../../../app/calculation/playback.ts";
import { readJob } from "../../../app/document/reading.ts";
import { chooseLine, choosePath } from "../../../app/pictures/selection.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { useEditor } from "../../../app/document/store.ts";
import { useTaskView } from "./task-view.ts";

/** Fraction of the step: a cut is shown once made, a rapid before it enters material. */
const SEEN = { cut: 0.999, rapid: 0 } as const;

/** The moment that shows a mark; residual material is shown at the end. */
export function momentOf({ rule, step }: TaskMark, { steps }: Run): PlayPosition {
  if (rule === "residue" || step === undefined) return { step: steps.length, fraction: 0 };
  return { step, fraction: rule === "rapid" || rule === "holder" ? SEEN.rapid : SEEN.cut };
}

/** Id of a mark in the picture. */
export const markId = (index: number): string => `task ${index}`;

/** The parameter to change: the one concerned, or the one that shapes the contour at the place. */
const promptOf = ({ q, shapedBy }: TaskMark): string | null => q ?? (shapedBy && "q" in shapedBy ? shapedBy.q : null);

/** Shows a mark: selects its block in the program, seeks to its moment, and moves the picture to its place. */
export async function showMark(mark: TaskMark, index: number, run: Run): Promise<void> {
  const { job, program, work } = useEditor.getState();
  const choice = mark.step === undefined ? null : choiceOf(run, mark.step);
  if (program && mark.block !== undefined) {
    const { openBlockByNumber } = await import("./block-by-number.ts");
    if (useEditor.getState().work !== work) return;
    openBlockByNumber(mark.block, mark.q ?? null);
  }
  const read = job && readJob(job);
  const q = promptOf(mark);
  if (read && q !== null && read.cycle.params[q]) showPrompt(q, draftOf(read.job)[q] ?? "");
  if (job && choice && mark.block !== undefined)
    chooseLine(run, choice, { block: mark.block, q: mark.q ?? null, prompt: usePlace.getState().prompt });
  else if (choice) choosePath(run, choice);
  if (mark.step !== undefined) {
    playback.dispatch({ do: "pause" });
    playback.dispatch({ do: "seek", position: momentOf(mark, run) });
  }
  chooseFinding(mark.place && index >= 0 ? markId(index) : null);
}

/** Shows a failed mark of the last check, or of the goals since then. */
export function showTaskMark(mark: TaskMark): void {
  const { checked } = useTaskView.getState();
  const index = checked?.judgement.marks.filter(({ passed }) => !passed).indexOf(mark) ?? -1;
  const run = index >= 0 ? checked?.answer.run : useOutcome.getState().newest?.run;
  if (!run) return;
  if (index >= 0) useTaskView.setState({ place: index });
  void showMark(mark, index, run);
}
