import { create } from "zustand";
import { z } from "zod/mini";
import { taskSchema, type Task } from "../../../course/task.ts";
import { keepTable } from "../../saving/device-table.ts";
import { noteChange } from "../../steps.ts";

/** The tasks that came from outside and are kept on this device, the newest first. */
export interface Taught {
  readonly list: readonly Task[];
  readonly trouble: "none" | "damaged" | "notKept";
}

export const useTaught = create<Taught>(() => ({ list: [], trouble: "none" }));

const put = (list: readonly Task[]): void => useTaught.setState({ list });

/** Most tasks that are kept. */
const MOST = 200;
const kept = z.object({ version: z.literal(1), tasks: z.array(taskSchema).check(z.maxLength(MOST)) });

/** The text that is kept; null where there is none. */
export const writeTaught = (tasks: readonly Task[]): string | null => (tasks.length === 0 ? null : JSON.stringify({ version: 1, tasks }));

/** Kept tasks; null where they are damaged. Never throws. */
export function readTaughtList(text: string): readonly Task[] | null {
  try {
    const read = kept.safeParse(JSON.parse(text));
    return read.success ? read.data.tasks : null;
  } catch {
    return null;
  }
}

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
  change([task, ...list.filter(({ id }) => id !== task.id)].slice(0, MOST));
}

/** Lets a kept task go. What was made of it stays. */
export const removeTask = (id: string): void => change(useTaught.getState().list.filter((task) => task.id !== id));
