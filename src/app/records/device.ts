import { z } from "zod/mini";
import { time } from "../base/clock.ts";
import { database } from "../base/database.ts";
import { isProgram, textsOf, type Work } from "../document/work.ts";
import { isNewer, readSave, SAVE_VERSION, type SaveFile } from "./save-file.ts";

/** Summary of a saved work for lists; the work itself stays on the device until it is opened. */
export interface WorkSummary {
  readonly work: string;
  /** Milliseconds since 1970. */
  readonly savedAt: number;
  readonly name: string;
  /** Null for a whole program. */
  readonly cycle: number | null;
  /** Approximate size on the device, bytes. */
  readonly size: number;
  /** Id of its task; absent for other works. */
  readonly task?: string | undefined;
}

/** Everything found on the device. Only the operator deletes any of it. */
export interface FoundWorks {
  /** Newest first. */
  readonly works: readonly WorkSummary[];
  /** How many damaged saves were set aside while reading. */
  readonly setAside: number;
  /** Saves of a newer edition, which this one cannot read and leaves untouched. */
  readonly newer: number;
  /** False when the browser keeps nothing (private window, storage refused). */
  readonly available: boolean;
}

/** Result of writing: kept, no space left, or refused. */
export type KeepState = "kept" | "full" | "refused";

/** Works, damaged saves, and a summary of each work, so that a long list need not read all texts. */
const [works, aside, heads] = [database("works"), database("damaged"), database("heads")];

/** Timeout of the storage, ms, so that the page opens even if it does not answer. */
const PATIENCE = 4000;

/** Rejects if the storage does not answer in time. */
function inTime<T>(answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error("no answer from the device")), PATIENCE);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/** Moves saves that were set aside, and that this edition can read, back to the works. */
async function bringBack(): Promise<void> {
  for (const key of await inTime(aside.keys())) {
    const raw = await inTime(aside.get(key));
    if (!readSave(raw)) continue;
    const own = String(key).replace(/^\d+ /, "");
    const free = (await inTime(works.get(own))) === undefined;
    await works.set(free ? own : String(key), raw);
    await aside.del(key);
  }
}

const sizeOf = (job: Work): number =>
  isProgram(job)
    ? textsOf(job).reduce((sum, { name, text }) => sum + name.length + text.length, 0)
    : JSON.stringify(job).length;

type Head = Omit<WorkSummary, "work">;
const headOf = ({ savedAt, job }: SaveFile): Head => ({
  savedAt,
  name: job.name,
  cycle: isProgram(job) ? null : job.cycle,
  size: sizeOf(job),
  ...(job.task && { task: job.task.id }),
});
const headShape = z.object({
  savedAt: z.number(),
  name: z.string(),
  cycle: z.nullable(z.number()),
  size: z.number(),
  task: z.optional(z.string()),
});

/** Summaries by work; a work without one is read in full. */
async function knownHeads(): Promise<ReadonlyMap<string, Head>> {
  try {
    const all = await inTime(heads.entries());
    return new Map(
      all.flatMap(([work, raw]) => {
        const read = headShape.safeParse(raw);
        return read.success ? [[String(work), read.data] as const] : [];
      }),
    );
  } catch {
    return new Map();
  }
}

/** Stores the summary of a work; null if the work is to be read in full. Nothing is lost without a summary. */
async function noteHead(work: string, head: Head | null): Promise<void> {
  try {
    await (head ? heads.set(work, head) : heads.del(work));
  } catch {
    return;
  }
}

/**
 * Lists the saved works. Those without a summary are read one after the other, so that only one is in memory. Damaged
 * ones are moved to their own store and stay there. Always answers.
 */
export async function findWorks(): Promise<FoundWorks> {
  const found: WorkSummary[] = [];
  const fresh: [string, Head][] = [];
  let [setAside, newer, available] = [0, 0, true];
  try {
    await bringBack();
    const known = await knownHeads();
    for (const key of await inTime(works.keys())) {
      const work = String(key);
      const head = known.get(work);
      if (head) {
        found.push({ work, ...head });
        continue;
      }
      const raw = await inTime(works.get(key));
      const file = readSave(raw);
      if (file) {
        found.push({ work, ...headOf(file) });
        fresh.push([work, headOf(file)]);
      } else if (isNewer(raw)) newer += 1;
      else if (raw !== undefined) {
        await aside.set(`${time()} ${String(key)}`, raw);
        await works.del(key);
        setAside += 1;
      }
    }
    // Without a summary the work is read in full the next time.
    if (fresh.length > 0) await heads.setMany(fresh).catch(() => undefined);
  } catch {
    available = false;
  }
  return { works: found.sort((a, b) => b.savedAt - a.savedAt), setAside, newer, available };
}

/** One saved work; null when there is none, or none that can be read. */
export async function readWork(work: string): Promise<SaveFile | null> {
  try {
    const raw = await inTime(works.get(work));
    const file = readSave(raw);
    // The next listing reads this work in full and sets it aside.
    if (!file && raw !== undefined) await noteHead(work, null);
    return file;
  } catch {
    return null;
  }
}

const isFull = (error: unknown) => error instanceof Error && error.name === "QuotaExceededError";

/** Saves a work, dated now or at another time. */
export async function keepWork(work: string, job: Work, savedAt = time()): Promise<KeepState> {
  try {
    const file: SaveFile = { version: SAVE_VERSION, savedAt, job };
    await works.set(work, file);
    await noteHead(work, headOf(file));
    return "kept";
  } catch (error) {
    return isFull(error) ? "full" : "refused";
  }
}

/** Deletes a work, at the operator's request only. */
export async function forgetWork(work: string): Promise<void> {
  try {
    await works.del(work);
    await noteHead(work, null);
  } catch {
    return;
  }
}
