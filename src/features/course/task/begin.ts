import { ncLanguageOf } from "../../../i18n/languages.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { Job } from "../../../program/job/job.ts";
import { progressOfTask } from "../../../course/progress.ts";
import { nextVariant, withNumbers, type OtherNumbers } from "../../../course/varied-numbers.ts";
import { startOfTask, toolsOfTask } from "../../../course/task-start.ts";
import type { Task } from "../../../course/task.ts";
import { draftOf } from "../../../app/document/edits.ts";
import { toFirstPrompt, usePlace } from "../../../app/place/place.ts";
import { openWork, refreshWorks, startWork, useSavedWorks } from "../../../app/records/keep.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useEditor } from "../../../app/document/store.ts";
import type { Work } from "../../../app/document/work.ts";
import { noteStart, progressRecord } from "../../../app/records/course/progress.ts";
import { unfoldNext } from "./task-view.ts";

/** The run is hidden until all predictions are made. */
const isVeiled = ({ predict = [] }: Task): boolean => predict.length > 0;

/**
 * The work that a task starts with. `fromOutside`: the task does not ship with the page, so the work includes its file.
 * `varied`: the numbers of its program, where they are others.
 */
export function workOfTask(task: Task, fromOutside = false, varied: OtherNumbers | null = null): Work {
  const start = startOfTask(withNumbers(task, varied ?? undefined));
  const brought = {
    tools: toolsOfTask(task),
    ...(task.material !== undefined && { material: task.material }),
    task: {
      id: task.id,
      ...(isVeiled(task) && { veiled: true }),
      ...(fromOutside && { file: task }),
      ...(varied && { varied }),
    },
  };
  const { language, output } = useSettings.getState();
  if (start.kind === "job") return { ...start.job, ncLanguage: ncLanguageOf(language), output, ...brought };
  return { name: start.name, text: start.text, encoding: "utf-8", ...brought };
}

/** The newest stored work of a task; undefined if there is none on this device. */
export const newestWorkOfTask = (id: string): string | undefined =>
  useSavedWorks.getState().works.find(({ task }) => task === id)?.work;

/** The first prompt without a value; if all have one, the first prompt. */
function firstOpenPrompt(job: Job): string | null {
  const asked = Object.keys(cycleByNumber(job.cycle)?.params ?? {}),
    draft = draftOf(job);
  return asked.find((q) => !draft[q]) ?? asked[0] ?? null;
}

function showFirstOpenPrompt(): void {
  const { job } = useEditor.getState();
  if (!job) return;
  const prompt = firstOpenPrompt(job);
  usePlace.setState({ section: "prompts", prompt, before: draftOf(job)[prompt ?? ""] ?? "", field: null });
}

/**
 * Starts a task with a new work; again, if it was passed with help before. Predictions that were tried before are asked
 * with other numbers.
 */
export function startTask(task: Task, fromOutside = false): void {
  unfoldNext();
  noteStart(task.id);
  const { tries } = progressOfTask(progressRecord.now(), task.id);
  void startWork(workOfTask(task, fromOutside, task.kind === "predict" ? nextVariant(task, tries) : null));
  showFirstOpenPrompt();
}

/** Resumes the newest stored work of a task, or starts the task. */
export async function resumeOrStartTask(task: Task, fromOutside = false): Promise<void> {
  await refreshWorks();
  unfoldNext();
  toFirstPrompt();
  const kept = newestWorkOfTask(task.id);
  if (kept === undefined || !(await openWork(kept))) startTask(task, fromOutside);
  else showFirstOpenPrompt();
}
