import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob, type Job } from "../../program/job/job.ts";
import type { FoundWorks } from "./device.ts";

/** Storage of a test, in place of the browser's. */
export const device = {
  works: new Map<string, { savedAt: number; job: unknown }>(),
  refuses: null as "full" | "refused" | null,
  /** Delays every write until it settles. */
  slow: null as Promise<void> | null,
  setAside: 0,
  newer: 0,
  /** Calls that wait for an answer, and most of them at once. */
  waiting: 0,
  atOnce: 0,
  taken: new Set<string>(),
};

export const findWorks = (): Promise<FoundWorks> =>
  Promise.resolve({
    works: [...device.works]
      .map(([work, { savedAt, job }]) => {
        const { name, cycle } = job as Job;
        return { work, savedAt, name, cycle, size: 7 };
      })
      .sort((a, b) => b.savedAt - a.savedAt),
    setAside: device.setAside,
    newer: device.newer,
    unread: [],
    available: device.refuses !== "refused",
  });

export async function keepWork(work: string, job: Job, savedAt = device.works.size): Promise<string> {
  await (device.slow ?? asked());
  if (!device.refuses) device.works.set(work, { savedAt, job });
  return device.refuses ?? "kept";
}

export const readWork = (work: string): Promise<unknown> => Promise.resolve(device.works.get(work) ?? null);
export const lookUpWork = (work: string): Promise<unknown> => Promise.resolve(device.works.get(work) ?? "none");
export const isTaken = (work: string): Promise<boolean> => Promise.resolve(device.works.has(work));
const summaryOf = (work: string, { savedAt, job }: { savedAt: number; job: Job }): unknown => ({
  work,
  savedAt,
  name: job.name,
  cycle: job.cycle,
  size: 7,
});
export async function forgetWork(work: string): Promise<boolean> {
  await asked();
  if (!device.refuses) device.works.delete(work);
  return !device.refuses;
}

/** Answers later, and notes how many wait for an answer. */
async function asked(): Promise<void> {
  device.waiting += 1;
  device.atOnce = Math.max(device.atOnce, device.waiting);
  await Promise.resolve();
  device.waiting -= 1;
}

/** The locks of the browser, with the works that other tabs hold. */
export const locks = {
  request: (
    name: string,
    { steal = false }: { readonly steal?: boolean },
    callback: (lock: object | null) => unknown,
  ) => Promise.resolve(callback(device.taken.has(name) && !steal ? null : { name })),
};

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
/** A work of the tests. */
export const someJob = exampleJob(cycle);

/** Resets the storage before a test. */
export function emptyDevice(): void {
  device.works.clear();
  device.taken.clear();
  Object.assign(device, { refuses: null, slow: null, setAside: 0, newer: 0, atOnce: 0 });
  sessionStorage.clear();
  localStorage.clear();
  Object.defineProperty(navigator, "locks", { value: locks, configurable: true });
}
export { summaryOf };
