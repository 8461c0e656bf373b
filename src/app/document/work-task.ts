import type { TaskWork } from "../../program/job/job.ts";
import { edit, changeProgram, useEditor, type Editor } from "./store.ts";

/** The task that the open work is; undefined of any other work. */
export const taskOfWork = ({ job, program }: Editor): TaskWork | undefined => (job ?? program)?.task;

/**
 * Changes what the open work knows of its task, as one step of undo; changes at the same place in a row are one step
 * together.
 */
export function changeTask(change: (task: TaskWork) => TaskWork, place: string | null = null): void {
  const { program } = useEditor.getState();
  const changed = <W extends { readonly task?: TaskWork }>(work: W): W =>
    work.task ? { ...work, task: change(work.task) } : work;
  if (program) changeProgram(changed, place);
  else edit(changed, place);
}

/** The answer to one question as it is typed. */
export const setTold = (question: number, text: string): void =>
  changeTask((task) => {
    const told = [...(task.told ?? [])];
    while (told.length < question) told.push("");
    told[question] = text;
    return { ...task, told };
  }, `told ${question}`);
