import { z } from "zod/mini";
import { setSchema, type TaskSet } from "../../../course/task-set.ts";
import type { Task } from "../../../course/task.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";
import { editRecord } from "../../document/edit-record.ts";

/** Most saved sets. */
const MOST = 60;
const NONE: readonly TaskSet[] = [];

/** Sets on this device, newest first: an instructor's own with their answers, and received ones. */
export const setRecord = record({
  key: "course-sets",
  version: 1,
  schema: z.object({ sets: z.array(setSchema) }),
  rows: { of: "sets", each: setSchema, most: MOST },
  from: ({ sets }): readonly TaskSet[] => sets,
  to: (sets) => ({ sets }),
  first: NONE,
  document: COURSE,
});
export const useSavedSets = setRecord.use;

const change = (to: readonly TaskSet[], place: string | null = null): void =>
  editRecord(setRecord, () => to.slice(0, MOST), place);

/** Saves a set in place of one with the same id, as one step of undo; steps at the same place are one. */
export function keepSet(set: TaskSet, place: string | null = null): void {
  const list = setRecord.now();
  const known = list.findIndex(({ id }) => id === set.id);
  change(known < 0 ? [set, ...list] : list.with(known, set), place);
}

/** Saves a received set. A new one takes nothing away, so that it is no step of undo. */
export function takeSet(set: TaskSet): void {
  const list = setRecord.now();
  if (list.some(({ id }) => id === set.id)) keepSet(set);
  else setRecord.put([set, ...list].slice(0, MOST));
}

/** Deletes a saved set. Works made from its tasks stay, and so does the record of an exam. */
export const removeSet = (id: string): void => change(setRecord.now().filter((set) => set.id !== id));

/** The saved set that a task belongs to, and the task. */
export function setOfTask(list: readonly TaskSet[], id: string): { readonly set: TaskSet; readonly task: Task } | null {
  for (const set of list) {
    const task = set.tasks.find((each) => each.id === id);
    if (task) return { set, task };
  }
  return null;
}

/** Sets of this device, then the missing ones of another. */
export const mergedSets = (mine: readonly TaskSet[], brought: readonly TaskSet[]): readonly TaskSet[] =>
  [...mine, ...brought.filter(({ id }) => !mine.some((set) => set.id === id))].slice(0, MOST);
