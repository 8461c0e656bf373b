import { time } from "../clock.ts";
import { createStore, del, get, keys, set } from "idb-keyval";
import { isProgram, type Work } from "../work.ts";
import { isNewer, readSave, SAVE_VERSION, type SaveFile } from "./save-file.ts";

/** What a list shows of a saved work; the work itself stays on the device until it is opened. */
export interface Kept {
  readonly work: string;
  /** Milliseconds since 1970. */
  readonly savedAt: number;
  readonly name: string;
  /** Null for a whole program. */
  readonly cycle: number | null;
}

/** Everything found on the device. Nothing of it is ever deleted but by the operator. */
export interface Found {
  /** Newest first. */
  readonly works: readonly Kept[];
  /** How many damaged saves were set aside while reading. */
  readonly setAside: number;
  /** How many saves of a newer edition stay where they are: this one can not read them. */
  readonly newer: number;
  /** False when the browser keeps nothing (private window, storage refused). */
  readonly available: boolean;
}

/** What became of writing: kept, no room left, or refused. */
export type KeepState = "kept" | "full" | "refused";

type Stores = { readonly works: ReturnType<typeof createStore>; readonly aside: ReturnType<typeof createStore> };
let stores: Stores | null = null;
const open =
  (): Stores => (stores ??= { works: createStore("turnwise-works", "works"), aside: createStore("turnwise-damaged", "damaged") });

/** A device that does not answer must not keep the page from opening, ms. */
const PATIENCE = 4000;

/** An answer of the device, or a failure when none comes. */
function inTime<T>(answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error("no answer from the device")), PATIENCE);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/** Saves that were set aside and can be read by this edition come back to the others. */
async function bringBack(): Promise<void> {
  const { works, aside } = open();
  for (const key of await inTime(keys<string>(aside))) {
    const raw = await inTime(get<unknown>(key, aside));
    if (!readSave(raw)) continue;
    const own = String(key).replace(/^\d+ /, "");
    const free = (await inTime(get(own, works))) === undefined;
    await set(free ? own : String(key), raw, works);
    await del(key, aside);
  }
}

const headOf = (work: string, { savedAt, job }: SaveFile): Kept => ({
  work,
  savedAt,
  name: job.name,
  cycle: isProgram(job) ? null : job.cycle,
});

/**
 * Reads what there is of saved works, one after the other, so that never more than one is in memory. What is damaged is moved
 * to a place of its own and stays there. Always answers.
 */
export async function findWorks(): Promise<Found> {
  const heads: Kept[] = [];
  let [setAside, newer, available] = [0, 0, true];
  try {
    const { works, aside } = open();
    await bringBack();
    for (const key of await inTime(keys<string>(works))) {
      const raw = await inTime(get<unknown>(key, works));
      const file = readSave(raw);
      if (file) heads.push(headOf(String(key), file));
      else if (isNewer(raw)) newer += 1;
      else if (raw !== undefined) {
        await set(`${time()} ${String(key)}`, raw, aside);
        await del(key, works);
        setAside += 1;
      }
    }
  } catch {
    available = false;
  }
  return { works: heads.sort((a, b) => b.savedAt - a.savedAt), setAside, newer, available };
}

/** One saved work; null when there is none, or none that can be read. */
export async function readWork(work: string): Promise<SaveFile | null> {
  try {
    return readSave(await inTime(get(work, open().works)));
  } catch {
    return null;
  }
}

const isFull = (error: unknown) => error instanceof Error && error.name === "QuotaExceededError";

/** Keeps a work. */
export async function keepWork(work: string, job: Work): Promise<KeepState> {
  try {
    const file: SaveFile = { version: SAVE_VERSION, savedAt: time(), job };
    await set(work, file, open().works);
    return "kept";
  } catch (error) {
    return isFull(error) ? "full" : "refused";
  }
}

/** Takes one work out of the list, for the operator asked for it. */
export async function forgetWork(work: string): Promise<void> {
  try {
    await del(work, open().works);
  } catch {
    return;
  }
}
