import type { TaskWork } from "../../program/job/job.ts";
import { edit, changeProgram, useEditor, type Editor } from "./store.ts";

/** The exercise of the open work; undefined if it is none. */
export const taskOfWork = ({ job, program }: Editor): TaskWork | undefined => (job ?? program)?.task;

/** Changes the exercise of the open work as one step of undo; successive changes at the same place are one step. */
export function changeTask(change: (task: TaskWork) => TaskWork, place: string | null = null): void {
  const { program } = useEditor.getState();
  const changed = <W extends { readonly task?: TaskWork }>(work: W): W =>
    work.task ? { ...work, task: change(work.task) } : work;
  if (program) changeProgram(changed, place);
  else edit(changed, place);
}

/** Sets the typed answer to one question. */
export const setPrediction = (question: number, text: string): void =>
  changeTask((task) => {
    const told = [...(task.told ?? [])];
    while (told.length < question) told.push("");
    told[question] = text;
    return { ...task, told };
  }, `told ${question}`);
