import { create } from "zustand";
import type { Task } from "../../../course/task.ts";
import { keepTable } from "../../base/device-table.ts";
import { noteChange } from "../../document/steps.ts";
import { MOST_TAUGHT, readTaughtList, writeTaught } from "./taught-list.ts";

/** The tasks that came from outside and are kept on this device, the newest first. */
export interface Taught {
  readonly list: readonly Task[];
  readonly trouble: "none" | "damaged" | "notKept";
}

export const useTaught = create<Taught>(() => ({ list: [], trouble: "none" }));

const put = (list: readonly Task[]): void => useTaught.setState({ list });

/** Of an id, so that a number still fits behind it. */
const LONGEST_STEM = 52;

/** Where the tasks are kept. */
export const TAUGHT_KEY = "turnwise/course-tasks";
let keeps = false;

/** Reads the kept tasks and keeps each change from now on, in all tabs. Asked again it does nothing. */
export function startTaught(): void {
  if (keeps) return;
  keeps = true;
  keepTable<readonly Task[]>({
    key: TAUGHT_KEY,
    aside: `${TAUGHT_KEY}/damaged`,
    store: useTaught,
    first: [],
    isSame: (one, other) => writeTaught(one) === writeTaught(other),
    write: writeTaught,
    read: readTaughtList,
    take: put,
    damaged: () => useTaught.setState({ trouble: "damaged" }),
    notKept: () => useTaught.setState({ trouble: "notKept" }),
  });
}

function change(to: readonly Task[]): void {
  const { list } = useTaught.getState();
  put(to);
  noteChange(put, list, to);
}

/** Keeps a task; an older one of its id gives way. One step, which undo takes back. */
export function keepTask(task: Task): void {
  const { list } = useTaught.getState();
  if (list.some((each) => JSON.stringify(each) === JSON.stringify(task))) return;
  change([task, ...list.filter(({ id }) => id !== task.id)].slice(0, MOST_TAUGHT));
}

/** A second task like a kept one, beside it: with an id of its own, and named as a copy in each of its languages. */
export function copyTask(task: Task, copyOf: (title: string) => string): void {
  const { list } = useTaught.getState();
  const stem = task.id.slice(0, LONGEST_STEM);
  let id = `${stem}-2`;
  for (let n = 3; list.some((each) => each.id === id); n++) id = `${stem}-${n}`;
  const words = Object.fromEntries(
    Object.entries(task.words).map(([language, told]) => [language, told && { ...told, title: copyOf(told.title) }]),
  );
  const index = list.findIndex((each) => each.id === task.id);
  change([...list.slice(0, index + 1), { ...task, id, words }, ...list.slice(index + 1)].slice(0, MOST_TAUGHT));
}

/** Lets a kept task go. What was made of it stays. */
export const removeTask = (id: string): void => change(useTaught.getState().list.filter((task) => task.id !== id));

/** Takes the tasks of another device that this one does not have, as one step. */
export function bringTasks(brought: readonly Task[]): void {
  const { list } = useTaught.getState(), fresh = brought.filter(({ id }) => !list.some((task) => task.id === id));
  if (fresh.length > 0) change([...list, ...fresh].slice(0, MOST_TAUGHT));
}
