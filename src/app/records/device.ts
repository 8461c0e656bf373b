import { z } from "zod/mini";
import { time } from "../base/clock.ts";
import { amount, moment, whole } from "../../program/files/bounded.ts";
import { fileNameOf } from "../base/file-name.ts";
import { database, isSilent } from "../base/database.ts";
import { isProgram, textsOf, type Work } from "../document/work.ts";
import { isNewer, nameIn, readSave, SAVE_VERSION, type SaveFile } from "./save-file.ts";

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

/** A save that this edition cannot read. It stays as it is until the operator deletes it. */
export interface UnreadSave {
  readonly store: "works" | "damaged";
  readonly key: string;
  /** As far as it can be found in the data. */
  readonly name: string;
  /** Written by a newer edition, which can read it. */
  readonly isNewer: boolean;
}

/** Everything found on the device. Only the operator deletes any of it. */
export interface FoundWorks {
  /** Newest first. */
  readonly works: readonly WorkSummary[];
  /** How many damaged saves were set aside while reading. */
  readonly setAside: number;
  /** Saves of a newer edition, which this one cannot read and leaves untouched. */
  readonly newer: number;
  /** Saves that cannot be read: damaged ones, also of earlier times, and those of a newer edition. */
  readonly unread: readonly UnreadSave[];
  /** False when the browser keeps nothing (private window, storage refused, no answer). */
  readonly available: boolean;
}

/** Result of writing: kept, no space left, refused, no answer, or a save of a newer edition is in its place. */
export type KeepState = "kept" | "full" | "refused" | "silent" | "newer";

/** Works, damaged saves, and a summary of each work, so that a long list need not read all texts. */
const [works, aside, heads] = [database("works"), database("damaged"), database("heads")];

/** Works whose save this page has read or written: nothing newer is in their place. */
const own = new Set<string>();

/** Moves saves that were set aside, and that this edition can read, back to the works; returns the others. */
async function bringBack(): Promise<UnreadSave[]> {
  const unread: UnreadSave[] = [];
  for (const key of await aside.keys()) {
    const raw = await aside.get(key);
    const plain = String(key).replace(/^\d+ /, "");
    if (!readSave(raw)) {
      unread.push({ store: "damaged", key: String(key), name: nameIn(raw) ?? plain, isNewer: false });
      continue;
    }
    const free = (await works.get(plain)) === undefined;
    await works.set(free ? plain : String(key), raw);
    await aside.del(key);
  }
  return unread;
}

const sizeOf = (job: Work): number =>
  isProgram(job)
    ? textsOf(job).reduce((sum, { name, text }) => sum + name.length + text.length, 0)
    : JSON.stringify(job).length;

/** What a work is called in a list: a file of another program may hold one without a name. */
export const nameOfWork = (job: Work): string =>
  job.name.trim() === "" ? fileNameOf(isProgram(job) ? job.text : "") : job.name;

type Head = Omit<WorkSummary, "work">;
const headOf = ({ savedAt, job }: Pick<SaveFile, "savedAt" | "job">): Head => ({
  savedAt,
  name: nameOfWork(job),
  cycle: isProgram(job) ? null : job.cycle,
  size: sizeOf(job),
  ...(job.task && { task: job.task.id }),
});
/** The list entry of a work. */
export const summaryOf = (work: string, file: Pick<SaveFile, "savedAt" | "job">): WorkSummary => ({
  work,
  ...headOf(file),
});
const name = z.string().check(z.maxLength(500));
const headShape = z.object({ savedAt: moment, name, cycle: z.nullable(whole), size: amount, task: z.optional(name) });

/** Summaries by work; a work without one is read in full. */
async function knownHeads(): Promise<ReadonlyMap<string, Head>> {
  try {
    const all = await heads.entries();
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
  const unread: UnreadSave[] = [];
  let [setAside, newer, available] = [0, 0, true];
  try {
    unread.push(...(await bringBack()));
    const known = await knownHeads();
    for (const key of await works.keys()) {
      const work = String(key);
      // A key of another type names no work: the row is set aside, and comes back under a name of its own.
      const isNamed = typeof key === "string";
      const head = isNamed ? known.get(work) : undefined;
      if (head) {
        found.push({ work, ...head });
        continue;
      }
      const raw = await works.get(key);
      const file = readSave(raw);
      if (file && isNamed) {
        found.push({ work, ...headOf(file) });
        fresh.push([work, headOf(file)]);
      } else if (isNewer(raw)) {
        newer += 1;
        unread.push({ store: "works", key: work, name: nameIn(raw) ?? work, isNewer: true });
      } else if (raw !== undefined) {
        const name = `${time()} ${work}`;
        await aside.set(name, raw);
        await works.del(key);
        setAside += 1;
        unread.push({ store: "damaged", key: name, name: nameIn(raw) ?? work, isNewer: false });
      }
    }
    // Without a summary the work is read in full the next time.
    if (fresh.length > 0) await heads.setMany(fresh).catch(() => undefined);
  } catch {
    available = false;
  }
  return { works: found.sort((a, b) => b.savedAt - a.savedAt), setAside, newer, unread, available };
}

/** What the device has under the name of a work: it, nothing, something unreadable, or no answer. */
export type FoundWork = SaveFile | "none" | "unreadable" | "newer" | "noAnswer";

export async function lookUpWork(work: string): Promise<FoundWork> {
  try {
    const raw = await works.get(work);
    own.delete(work);
    if (raw === undefined) return "none";
    const file = readSave(raw);
    if (file) own.add(work);
    // The next listing reads this work in full and sets it aside.
    else await noteHead(work, null);
    return file ?? (isNewer(raw) ? "newer" : "unreadable");
  } catch {
    return "noAnswer";
  }
}

/** One saved work; null when there is none, or none that can be read. */
export async function readWork(work: string): Promise<SaveFile | null> {
  const found = await lookUpWork(work);
  return typeof found === "string" ? null : found;
}

/** Whether the device has anything under a name, also what this edition cannot read. */
export async function isTaken(work: string): Promise<boolean> {
  return (await lookUpWork(work)) !== "none";
}

/** A save that cannot be read, as it is stored; undefined if it is gone. */
export const readUnread = ({ store, key }: UnreadSave): Promise<unknown> =>
  (store === "works" ? works : aside).get(key).catch(() => undefined);

/** Deletes a save that cannot be read, at the operator's request only. */
export const forgetUnread = ({ store, key }: UnreadSave): Promise<void> =>
  (store === "works" ? works : aside).del(key).catch(() => undefined);

const isFull = (error: unknown) => error instanceof Error && error.name === "QuotaExceededError";

/** Saves a work, dated now or at another time. Never over a save of a newer edition. */
export async function keepWork(work: string, job: Work, savedAt = time()): Promise<KeepState> {
  try {
    const file: SaveFile = { version: SAVE_VERSION, savedAt, job };
    if (!own.has(work) && isNewer(await works.get(work))) return "newer";
    await works.set(work, file);
    own.add(work);
    await noteHead(work, headOf(file));
    return "kept";
  } catch (error) {
    if (isSilent()) return "silent";
    return isFull(error) ? "full" : "refused";
  }
}

/** Deletes a work, at the operator's request only; false if the device did not. */
export async function forgetWork(work: string): Promise<boolean> {
  try {
    await works.del(work);
    own.delete(work);
    await noteHead(work, null);
    return true;
  } catch {
    return false;
  }
}
