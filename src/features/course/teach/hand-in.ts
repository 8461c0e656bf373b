import { judge } from "../../../course/judge/judge.ts";
import { RESULT_FORMAT, type HandedResult, type TaskResult } from "../../../course/made/result.ts";
import { progressOfTask, type CourseProgress } from "../../../course/progress.ts";
import type { Task } from "../../../course/task.ts";
import type { Language } from "../../../i18n/languages.ts";
import { shippedList } from "../../../program/tools/tool-list.ts";
import { time } from "../../../app/base/clock.ts";
import { outcomeOfOther } from "../../../app/calculation/other-outcome.ts";
import { printedText } from "../../../app/document/printed.ts";
import { readWork } from "../../../app/records/device.ts";
import { refreshWorks } from "../../../app/records/keep.ts";
import { isProgram } from "../../../app/document/work.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { fetchTask } from "../../../app/records/course/content.ts";
import { newestWorkOfTask } from "../task/begin.ts";
import type { RerunOutcome } from "../../../app/records/course/result-rows.ts";
import { taskRecord } from "../../../app/records/course/saved-tasks.ts";
import { countWork, workedIn } from "../../../app/records/course/working-time.ts";

/** A task by its id: a kept one, or one of the course; null if this device has none. */
export async function taskOfId(id: string): Promise<Task | null> {
  return taskRecord.now().find((task) => task.id === id) ?? fetchTask(id);
}

/**
 * The verdict on a program in a task, from a background run with the same settings on every device; null if the run
 * fails.
 */
export async function verdictHere(task: Task, program: string): Promise<TaskResult["verdict"]> {
  const answer = await outcomeOfOther(
    { name: `${task.id}.h`, text: program, encoding: "utf-8", tools: shippedList },
    null,
  );
  if (!answer) return null;
  const { passed, marks } = judge(task, answer);
  return { passed, refused: [...new Set(marks.filter((mark) => !mark.passed).map(({ rule }) => rule))] };
}

/** The verdict on a received result on this device, with the device's version of the task. */
export async function rerunResult({ id, program }: TaskResult): Promise<RerunOutcome> {
  const task = await taskOfId(id);
  if (task?.kind === "predict") return "foretold";
  if (program === null) return "none";
  if (!task) return "unknown";
  const verdict = await verdictHere(task, program);
  if (!verdict) return "stopped";
  return verdict.passed ? "passes" : "fails";
}

/** The newest program for a task on this device. */
async function lastProgram(id: string): Promise<string | null> {
  const work = newestWorkOfTask(id),
    kept = work === undefined ? null : await readWork(work);
  if (!kept) return null;
  return isProgram(kept.job) ? kept.job.text : printedText(kept.job);
}

const SECOND = 1000;

/** The result of one task. */
export async function resultOf(id: string, progress: CourseProgress, language: Language): Promise<TaskResult> {
  const task = await taskOfId(id),
    program = await lastProgram(id);
  const { tries, hints, solution, passed, seconds, score } = progressOfTask(progress, id);
  const { ms, steps } = workedIn(id);
  return {
    id,
    title: (task && inScreenLanguage(task.words, language)?.title) ?? id,
    tries,
    hints,
    solution,
    passed,
    seconds,
    score,
    worked: Math.round(ms / SECOND),
    steps,
    program,
    verdict: task && program !== null && task.kind !== "predict" ? await verdictHere(task, program) : null,
  };
}

/** The results of tasks under a name, which may be empty. */
export async function resultsToHandIn(
  ids: readonly string[],
  name: string,
  progress: CourseProgress,
  language: Language,
): Promise<HandedResult> {
  countWork();
  await refreshWorks();
  const tasks: TaskResult[] = [];
  for (const id of ids) tasks.push(await resultOf(id, progress, language));
  return { format: RESULT_FORMAT, name: name.trim(), made: time(), tasks };
}
