import { create } from "zustand";
import { time } from "../../base/clock.ts";
import { keepTable } from "../../base/device-table.ts";
import { noteChange, useSteps } from "../../document/steps.ts";
import { useEditor } from "../../document/store.ts";
import { mergedWorked, readWorked, writeWorked, type Worked, type WorkedTasks } from "./worked-list.ts";

/** What was worked in each task on this device, by its id. */
export const useWorked = create<{ readonly list: WorkedTasks }>(() => ({ list: {} }));

const put = (list: WorkedTasks): void => useWorked.setState({ list });

const NOTHING: Worked = { ms: 0, steps: 0 };
export const workedIn = (id: string): Worked => {
  const { list } = useWorked.getState();
  return (Object.hasOwn(list, id) && list[id]) || NOTHING;
};

function add(id: string, more: Partial<Worked>): void {
  const now = workedIn(id);
  useWorked.setState(({ list }) => ({ list: { ...list, [id]: { ms: now.ms + (more.ms ?? 0), steps: now.steps + (more.steps ?? 0) } } }));
}

/** The task that is open and in sight; null while there is none. */
function openTask(): string | null {
  const { job, program } = useEditor.getState();
  return document.visibilityState === "visible" ? (job ?? program)?.task?.id ?? null : null;
}

/** How often running time is written down, ms. */
const EVERY = 10_000;
const KEY = "turnwise/course-worked";
let runs = false;
let since: { readonly id: string; readonly at: number } | null = null;

/** Adds what has passed, and goes on with the task that is open now. */
export function countWork(): void {
  const now = time(), id = openTask();
  if (since && now > since.at) add(since.id, { ms: now - since.at });
  since = id === null ? null : { id, at: now };
}

/** Counts the time of open tasks from now on. Asked again it does nothing. */
export function startWorkingTime(): void {
  if (runs) return;
  runs = true;
  keepTable<WorkedTasks>({
    key: KEY,
    aside: `${KEY}/damaged`,
    store: useWorked,
    first: {},
    isSame: (one, other) => JSON.stringify(one) === JSON.stringify(other),
    write: writeWorked,
    read: readWorked,
    take: put,
    damaged: () => undefined,
    notKept: () => undefined,
  });
  countWork();
  useEditor.subscribe((is, was) => {
    if (is.work !== was.work) countWork();
  });
  useSteps.subscribe((is, was) => {
    const id = openTask();
    if (id !== null && is.past !== was.past && is.future.length === 0 && is.past.length > was.past.length) add(id, { steps: 1 });
  });
  document.addEventListener("visibilitychange", countWork);
  addEventListener("pagehide", countWork);
  setInterval(countWork, EVERY);
}

/** Takes what was worked on another device, as a step; of both the more counts. */
export function bringWorked(brought: WorkedTasks): void {
  const { list } = useWorked.getState(), next = mergedWorked(list, brought);
  put(next);
  noteChange(put, list, next);
}
