import { z } from "zod/mini";
import { taskSchema, type Task } from "../../../course/task.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";
import { editRecord } from "../../document/edit-record.ts";

/** Most saved tasks. */
const MOST = 200;
const NONE: readonly Task[] = [];

/** Imported tasks saved on this device, newest first. */
export const taskRecord = record({
  key: "course-tasks",
  version: 1,
  schema: z.object({ tasks: z.array(taskSchema) }),
  rows: { of: "tasks", each: taskSchema, most: MOST },
  from: ({ tasks }): readonly Task[] => tasks,
  to: (tasks) => ({ tasks }),
  first: NONE,
  document: COURSE,
});
export const useSavedTasks = taskRecord.use;

/** Longest id that leaves room for a number. */
const LONGEST_STEM = 52;

const change = (to: readonly Task[]): void => editRecord(taskRecord, () => to.slice(0, MOST));

/** Saves a task in place of one with the same id, as one step of undo. */
export function keepTask(task: Task): void {
  const list = taskRecord.now();
  if (list.some((each) => JSON.stringify(each) === JSON.stringify(task))) return;
  change([task, ...list.filter(({ id }) => id !== task.id)]);
}

/** Duplicates a saved task below it with a new id; the title says that it is a copy, in each language. */
export function copyTask(task: Task, copyOf: (title: string) => string): void {
  const list = taskRecord.now();
  const stem = task.id.slice(0, LONGEST_STEM);
  let id = `${stem}-2`;
  for (let n = 3; list.some((each) => each.id === id); n++) id = `${stem}-${n}`;
  const words = Object.fromEntries(
    Object.entries(task.words).map(([language, told]) => [language, told && { ...told, title: copyOf(told.title) }]),
  );
  const index = list.findIndex((each) => each.id === task.id);
  change([...list.slice(0, index + 1), { ...task, id, words }, ...list.slice(index + 1)]);
}

/** Deletes a saved task. Works made from it stay. */
export const removeTask = (id: string): void => change(taskRecord.now().filter((task) => task.id !== id));

/** Tasks of this device, then the missing ones of another. */
export const mergedTasks = (mine: readonly Task[], brought: readonly Task[]): readonly Task[] =>
  [...mine, ...brought.filter(({ id }) => !mine.some((task) => task.id === id))].slice(0, MOST);
