import { z } from "zod/mini";
import { amount } from "../../../program/files/bounded.ts";
import { time } from "../../base/clock.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";
import { historyOf, useSteps } from "../../document/steps.ts";
import { openDocument, useEditor, openContent } from "../../document/store.ts";

/** How long a task was open and visible, ms, and how many changes were made in it. */
export interface Worked {
  readonly ms: number;
  readonly steps: number;
}
type WorkedTasks = Readonly<Record<string, Worked>>;

const NONE: WorkedTasks = {};

const worked = z.object({ ms: amount, steps: z.int() });

/** Working time in each task on this device, by its id. */
export const workedRecord = record({
  key: "course-worked",
  version: 1,
  schema: z.object({ tasks: z.record(z.string().check(z.maxLength(100)), worked) }),
  rows: { of: "tasks", each: worked },
  from: ({ tasks }): WorkedTasks => tasks,
  to: (tasks) => ({ tasks }),
  first: NONE,
  document: COURSE,
});

const NOTHING: Worked = { ms: 0, steps: 0 };
const workedOf = (list: WorkedTasks, id: string): Worked => (Object.hasOwn(list, id) && list[id]) || NOTHING;
export const workedIn = (id: string): Worked => workedOf(workedRecord.now(), id);

function add(id: string, more: Partial<Worked>): void {
  const now = workedIn(id);
  workedRecord.put({
    ...workedRecord.now(),
    [id]: { ms: now.ms + (more.ms ?? 0), steps: now.steps + (more.steps ?? 0) },
  });
}

/** The open task while the page is visible; else null. */
function openTask(): string | null {
  return document.visibilityState === "visible" ? (openContent()?.task?.id ?? null) : null;
}

/** Interval at which running time is saved, ms. */
const EVERY = 10_000;
let since: { readonly id: string; readonly at: number } | null = null;

/** Adds the elapsed time, and restarts the count for the open task. */
export function countWork(): void {
  const now = time(),
    id = openTask();
  if (since && now > since.at) add(since.id, { ms: now - since.at });
  since = id === null ? null : { id, at: now };
}

/** Starts counting the time of open tasks. Called once. */
export function startWorkingTime(): void {
  countWork();
  useEditor.subscribe((is, was) => {
    if (is.work !== was.work) countWork();
  });
  useSteps.subscribe(({ newest }, was) => {
    const id = openTask();
    if (id === null || newest === null || newest === was.newest || newest.document !== openDocument()) return;
    // A step that goes on is one change.
    if (historyOf(newest.document).past.length > historyOf(newest.document, was).past.length) add(id, { steps: 1 });
  });
  document.addEventListener("visibilitychange", countWork);
  addEventListener("pagehide", countWork);
  setInterval(countWork, EVERY);
}

/** Merges working times. The same work may be in both, so the larger one counts. */
export function mergedWorked(mine: WorkedTasks, brought: WorkedTasks): WorkedTasks {
  const all = { ...mine };
  for (const [id, { ms, steps }] of Object.entries(brought)) {
    const here = workedOf(mine, id);
    all[id] = { ms: Math.max(here.ms, ms), steps: Math.max(here.steps, steps) };
  }
  return all;
}
