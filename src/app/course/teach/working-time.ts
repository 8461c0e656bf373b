import { create } from "zustand";
import { z } from "zod/mini";
import { time } from "../../clock.ts";
import { keepTable } from "../../saving/device-table.ts";
import { useSteps } from "../../steps.ts";
import { useEditor } from "../../store.ts";

/** How long a task was open and visible, ms, and how many changes were made in it. */
export interface Worked {
  readonly ms: number;
  readonly steps: number;
}
export type WorkedTasks = Readonly<Record<string, Worked>>;

/** What was worked in each task on this device, by its id. */
export const useWorked = create<{ readonly list: WorkedTasks }>(() => ({ list: {} }));

const shape = z.object({
  version: z.literal(1),
  tasks: z.record(z.string().check(z.maxLength(100)), z.object({ ms: z.number(), steps: z.int() })),
});

export function readWorked(text: string): WorkedTasks | null {
  try {
    const read = shape.safeParse(JSON.parse(text));
    return read.success ? read.data.tasks : null;
  } catch {
    return null;
  }
}

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
    write: (list) => (Object.keys(list).length === 0 ? null : JSON.stringify({ version: 1, tasks: list })),
    read: readWorked,
    take: (list) => useWorked.setState({ list }),
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
