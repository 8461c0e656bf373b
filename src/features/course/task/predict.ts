import { areAllRight, comparePredictedAnswers, type ComparedAnswer } from "../../../course/predicted-answers.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { progressOfTask } from "../../../course/progress.ts";
import { programOfLines } from "../../../course/task-start.ts";
import type { Task } from "../../../course/task.ts";
import { varyNumbers, withNumbers, type OtherNumbers } from "../../../course/varied-numbers.ts";
import type { TaskWork } from "../../../program/job/job.ts";
import { reducedMotion } from "../../../app/base/settings/appearance.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { stopwatch } from "../../../app/base/clock.ts";
import { calculation } from "../../../app/calculation/calculation.ts";
import { outcomeOfOther } from "../../../app/calculation/other-outcome.ts";
import { playback } from "../../../app/calculation/playback.ts";
import { changeProgram, useEditor } from "../../../app/document/store.ts";
import { changeTask, taskOfWork } from "../../../app/document/work-task.ts";
import { asProgram } from "../../../app/document/printed.ts";
import { restartComparison } from "../../../app/findings/effect/compared.ts";
import { notePass, noteSolution, noteTry, progressRecord } from "../../../app/records/course/progress.ts";
import { workOfTask } from "./begin.ts";
import { awaitOutcome } from "./check.ts";
import { useTaskView } from "./task-view.ts";

/** Longest search for other numbers, ms. */
const SEARCHING = 4000;

const cachedStartOutcomes = new WeakMap<object, Answer>();

/** The result of the program that the task starts with, or of the one with other numbers. */
async function answerAtStart(task: Task, varied: OtherNumbers | undefined): Promise<Answer | null> {
  const key = varied ?? task;
  const known = cachedStartOutcomes.get(key);
  if (known) return known;
  const made = await outcomeOfOther(asProgram(workOfTask(withNumbers(task, varied))));
  if (made) cachedStartOutcomes.set(key, made);
  return made;
}

/** Compares the predictions with the actual run; null if that is not available. */
export async function comparePredictions(task: Task): Promise<readonly ComparedAnswer[] | null> {
  const { work } = useEditor.getState();
  const truth = await answerAtStart(task, taskOfWork(useEditor.getState())?.varied);
  const now = useEditor.getState();
  const { told = [], veiled = false, varied, asked } = taskOfWork(now) ?? {};
  if (!truth || now.work !== work || veiled) return null;
  const answers = comparePredictedAnswers(withNumbers(task, varied), told, truth, asked);
  useTaskView.setState({ comparedAnswers: answers });
  return answers;
}

/** Whether the right answers to the current questions were shown: the same numbers were tried before. */
export const isAnswerKnown = (task: Task, work: TaskWork | undefined, tries: number): boolean =>
  task.kind === "predict" && tries > (work?.varied?.at ?? 0);

/** Shows and plays the run once all predictions are made; this counts as a try. */
export async function showRun(task: Task): Promise<void> {
  const { tries, passed } = progressOfTask(progressRecord.now(), task.id);
  const isKnown = isAnswerKnown(task, taskOfWork(useEditor.getState()), tries) && passed === null;
  changeTask(({ veiled: _, ...told }) => told);
  // The cached result belongs to the hidden run.
  calculation.recalculate();
  void awaitOutcome().then(() => {
    // Showing the run is not a change of values.
    restartComparison();
    playback.dispatch({ do: "first" });
    playback.dispatch({ do: reducedMotion(useSettings.getState()) ? "last" : "play" });
  });
  const answers = await comparePredictions(task);
  if (!answers) return;
  noteTry(task.id);
  if (task.kind !== "predict" || !areAllRight(task, answers)) return;
  if (isKnown) noteSolution(task.id);
  notePass(task.id);
}

/**
 * Asks the wrong predictions again, with the run hidden: with other numbers where the task allows it, since the right
 * answers have been shown.
 */
export async function retryPredictions(task: Task): Promise<void> {
  const { comparedAnswers, checking } = useTaskView.getState();
  const { work } = useEditor.getState();
  if (checking) return;
  const wrong = (comparedAnswers ?? []).flatMap(({ right }, i) => (right ? [] : [i]));
  useTaskView.setState({ checking: true });
  const start = asProgram(workOfTask(task)),
    end = stopwatch() + SEARCHING;
  const runOf = (text: string) => (stopwatch() < end ? outcomeOfOther({ ...start, text }) : Promise.resolve(null));
  const { tries } = progressOfTask(progressRecord.now(), task.id);
  const other = await varyNumbers(task, wrong, tries, runOf);
  if (useEditor.getState().work !== work) return;
  const asking = ({ told = [], ...rest }: TaskWork): TaskWork => ({
    ...rest,
    veiled: true,
    told: told.map((text, i) => (wrong.includes(i) ? "" : text)),
    ...(other && { varied: other, asked: wrong }),
  });
  if (other)
    changeProgram((program) => ({
      ...program,
      text: programOfLines(other.lines),
      ...(program.task && { task: asking(program.task) }),
    }));
  else changeTask(asking);
  useTaskView.setState({ checking: false, comparedAnswers: null, checked: null, live: null, question: wrong[0] ?? 0 });
  calculation.recalculate();
}
