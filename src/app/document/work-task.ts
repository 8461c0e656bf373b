import type { TaskWork } from "../../program/job/job.ts";
import { change, openContent, type Editor } from "./store.ts";

/** The exercise of the open work; undefined if it is none. */
export const taskOfWork = (editor: Editor): TaskWork | undefined => openContent(editor)?.task;

/** Changes the exercise of the open work as one step of undo; successive changes at the same place are one step. */
export const changeTask = (edit: (task: TaskWork) => TaskWork, place: string | null = null): void =>
  change((work) => (work.task ? { ...work, task: edit(work.task) } : work), place);

/** Sets the typed answer to one question. */
export const setPrediction = (question: number, text: string): void =>
  changeTask((task) => {
    const told = [...(task.told ?? [])];
    while (told.length < question) told.push("");
    told[question] = text;
    return { ...task, told };
  }, `told ${question}`);
