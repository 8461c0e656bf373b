import { comparePredictedAnswers } from "../../../course/predicted-answers.ts";
import { goalsOf, isMet } from "../../../course/goals.ts";
import { judge } from "../../../course/judge/judge.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { RESULT_FORMAT, type HandedResult, type TaskResult } from "../../../course/made/result.ts";
import { checkIn, momentIn, type Exam, type ExamCheck } from "../../../course/exam.ts";
import { progressOfTask, type CourseProgress } from "../../../course/progress.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import type { Task } from "../../../course/task.ts";
import { withNumbers } from "../../../course/varied-numbers.ts";
import type { Language } from "../../../i18n/languages.ts";
import type { TaskWork } from "../../../program/job/job.ts";
import { shippedList } from "../../../program/tools/tool-list.ts";
import { time } from "../../../app/base/clock.ts";
import { outcomeOfOther } from "../../../app/calculation/other-outcome.ts";
import { asProgram, textOf } from "../../../app/document/printed.ts";
import { flushEdits } from "../../../app/document/store.ts";
import { newestState, refreshWorks } from "../../../app/records/keep.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { fetchTask } from "../../../app/records/course/content.ts";
import { newestWorkOfTask, workOfTask } from "../task/begin.ts";
import type { MissedGoal, Rerun } from "../../../app/records/course/result-rows.ts";
import { setOfTask, setRecord } from "../../../app/records/course/saved-sets.ts";
import { taskRecord } from "../../../app/records/course/saved-tasks.ts";
import { countWork, workedIn } from "../../../app/records/course/working-time.ts";

/** A task by its id: a kept one, one of a kept set, or one of the course; null if this device has none. */
export async function taskOfId(id: string): Promise<Task | null> {
  return (
    taskRecord.now().find((task) => task.id === id) ?? setOfTask(setRecord.now(), id)?.task ?? (await fetchTask(id))
  );
}

/** A program of a task as it runs with the same settings on every device, in the background; null if that fails. */
const answerHere = (task: Task, program: string): Promise<Answer | null> =>
  outcomeOfOther({ name: `${task.id}.h`, text: program, encoding: "utf-8", tools: shippedList }, null);

/** The verdict on a program in a task; null if the run fails. */
export async function verdictHere(task: Task, program: string): Promise<TaskResult["verdict"]> {
  const answer = await answerHere(task, program);
  if (!answer) return null;
  const { passed, marks } = judge(task, answer);
  return { passed, refused: [...new Set(marks.filter((mark) => !mark.passed).map(({ rule }) => rule))] };
}

/** How a program of an exam task does: the goals that it meets; null if nothing cuts yet, or the run fails. */
export async function examCheckHere(task: Task, program: string): Promise<Omit<ExamCheck, "count"> | null> {
  const answer = await answerHere(task, program);
  if (!answer?.run.steps.some(({ move }) => move.kind !== "rapid")) return null;
  const judgement = judge(task, answer);
  const goals = goalsOf(task).filter(({ kind }) => kind !== "predicted");
  const met = goals.filter((goal) => isMet(goal, judgement, [])).length;
  return { passed: judgement.passed, met, of: goals.length };
}

/**
 * Whether all questions of a task were answered correctly, by a run of its starting state with the numbers that the
 * learner had; null if that fails.
 */
async function areAnswersRight(task: Task, { told = [], varied, asked }: TaskResult): Promise<boolean | null> {
  const begun = await outcomeOfOther(asProgram(workOfTask(task, false, varied)));
  return begun && comparePredictedAnswers(withNumbers(task, varied), told, begun, asked).every(({ right }) => right);
}

/**
 * A received result, judged on this device with the device's version of the task: its program, and its answers where the
 * learner was not told whether they are right.
 */
export async function rerunResult(result: TaskResult): Promise<Rerun> {
  const { id, program, told } = result;
  const none: readonly MissedGoal[] = [];
  const task = await taskOfId(id);
  const isAsked = task?.predict !== undefined && told !== undefined;
  if (task?.kind === "predict" && !isAsked) return { is: "predicted", missed: none };
  if (program === null && task?.kind !== "predict") return { is: "none", missed: none };
  if (!task) return { is: "unknown", missed: none };
  const answers = isAsked ? await areAnswersRight(task, result) : true;
  const verdict =
    task.kind === "predict"
      ? { passed: true, refused: [] }
      : program === null
        ? null
        : await verdictHere(task, program);
  if (!verdict || answers === null) return { is: "stopped", missed: none };
  const missed = [...(answers ? none : (["answers"] as const)), ...verdict.refused];
  return { is: missed.length === 0 ? "passes" : "fails", missed };
}

/** The newest program for a task on this device, and its questions and answers; null where none was stored. */
async function lastWork(id: string): Promise<{ readonly program: string; readonly task: TaskWork | undefined } | null> {
  const work = newestWorkOfTask(id),
    kept = work === undefined ? null : await newestState(work);
  return kept && { program: textOf(kept), task: kept.task };
}

/** The answers to the questions as typed, with what they were asked for. */
const answersOf = ({ told = [], varied, asked }: Partial<TaskWork>): Pick<TaskResult, "told" | "varied" | "asked"> =>
  told.length === 0 ? {} : { told: [...told], ...(varied && { varied }), ...(asked && { asked }) };

const SECOND = 1000;

/** The result of one task; of an exam, without a verdict, which is the instructor's. */
export async function resultOf(
  id: string,
  progress: CourseProgress,
  language: Language,
  exam: Exam | null = null,
): Promise<TaskResult> {
  const task = await taskOfId(id),
    last = await lastWork(id),
    program = last?.program ?? null;
  const { tries, hints, solution, passed, seconds, score } = progressOfTask(progress, id);
  const { ms, steps } = workedIn(id);
  const check = exam && checkIn(exam, id);
  const isJudged = !exam && task && program !== null && task.kind !== "predict";
  return {
    id,
    title: (task && inScreenLanguage(task.words, language)?.title) ?? id,
    tries: check ? check.count : tries,
    hints,
    solution,
    passed,
    seconds,
    score,
    worked: Math.round(ms / SECOND),
    steps,
    program,
    ...(exam && answersOf(last?.task ?? {})),
    verdict: isJudged ? await verdictHere(task, program) : null,
  };
}

/** Who hands in: the name and the class, either may be empty. */
export interface Learner {
  readonly name: string;
  readonly group: string;
}

/** The results of tasks, of a whole set or of an exam. */
export async function resultsToHandIn(
  ids: readonly string[],
  { name, group }: Learner,
  progress: CourseProgress,
  language: Language,
  from: { readonly set?: TaskSet | undefined; readonly exam?: Exam | null; readonly by?: "learner" | "time" } = {},
): Promise<HandedResult> {
  const { set, exam = null, by = "learner" } = from;
  flushEdits();
  countWork();
  await refreshWorks();
  const tasks: TaskResult[] = [];
  for (const id of ids) tasks.push(await resultOf(id, progress, language, exam));
  return {
    format: RESULT_FORMAT,
    name: name.trim(),
    ...(group.trim() !== "" && { group: group.trim() }),
    made: exam ? momentIn(exam, time()) : time(),
    ...(set && {
      set: {
        id: set.id,
        title: inScreenLanguage(set.words, language)?.title ?? set.id,
        ...(set.due !== undefined && { due: set.due }),
      },
    }),
    ...(exam && { exam: { begun: exam.begun, by } }),
    tasks,
  };
}
