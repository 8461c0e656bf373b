import { ncLanguageOf } from "../../../i18n/languages.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { Job } from "../../../program/job/job.ts";
import { startOfTask, toolsOfTask } from "../../../course/start-of.ts";
import type { Task } from "../../../course/task.ts";
import { draftOf } from "../../../app/document/edits.ts";
import { toFirstPrompt, usePlace } from "../../../app/place/place.ts";
import { openWork, refreshWorks, startWork, useKeeping } from "../../../app/records/keep.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { isProgram, type Work } from "../../../app/document/work.ts";
import { unfoldNext } from "./task-view.ts";

/** A task foretells before anything runs, and a fault is to be found by reading first. */
const isVeiled = ({ predict = [] }: Task): boolean => predict.length > 0;

/** The work that a task begins with. `fromOutside`: it does not ship with the page, and goes along with the work. */
export function workOfTask(task: Task, fromOutside = false): Work {
  const start = startOfTask(task);
  const brought = {
    tools: toolsOfTask(task),
    ...(task.material !== undefined && { material: task.material }),
    task: { id: task.id, ...(isVeiled(task) && { veiled: true }), ...(fromOutside && { file: task }) },
  };
  const { language, output } = useSettings.getState();
  if (start.kind === "job") return { ...start.job, ncLanguage: ncLanguageOf(language), output, ...brought };
  return { name: start.name, text: start.text, encoding: "utf-8", ...brought };
}

/** The newest kept work of a task; undefined where it was never begun on this device, or nothing of it is left. */
export const keptOfTask = (id: string): string | undefined =>
  useKeeping.getState().works.find(({ task }) => task === id)?.work;

/** The first prompt that nothing is given for; where all of it is given, the first of all. */
function firstToAnswer(job: Job): string | null {
  const asked = Object.keys(cycleByNumber(job.cycle)?.params ?? {}),
    draft = draftOf(job);
  return asked.find((q) => !draft[q]) ?? asked[0] ?? null;
}

/** Begins a task anew, as a work of its own. */
export function beginTaskAnew(task: Task, fromOutside = false): void {
  unfoldNext();
  const work = workOfTask(task, fromOutside);
  startWork(work);
  if (isProgram(work)) return;
  const prompt = firstToAnswer(work);
  usePlace.setState({ section: "prompts", prompt, before: draftOf(work)[prompt ?? ""] ?? "", field: null });
}

/** Goes on with what was made of a task on this device, or begins it. */
export async function beginTask(task: Task, fromOutside = false): Promise<void> {
  await refreshWorks();
  unfoldNext();
  toFirstPrompt();
  const kept = keptOfTask(task.id);
  if (kept === undefined || !(await openWork(kept))) beginTaskAnew(task, fromOutside);
}
