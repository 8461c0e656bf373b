import { createStore, del, entries, get, set } from "idb-keyval";
import { readSave, SAVE_VERSION, type SaveFile } from "./save-file.ts";
import type { Work } from "../work.ts";

/** One saved work with its key. */
export interface Kept {
  readonly work: string;
  readonly file: SaveFile;
}

/** Everything found on the device. */
export interface Found {
  /** Newest first. */
  readonly works: readonly Kept[];
  /** How many damaged saves were set aside while reading. */
  readonly setAside: number;
  /** False when the browser keeps nothing (private window, storage refused). */
  readonly available: boolean;
}

/** Works beyond this number, oldest first, make room. */
const MOST = 100;

type Stores = { readonly works: ReturnType<typeof createStore>; readonly aside: ReturnType<typeof createStore> };
let stores: Stores | null = null;
const open = (): Stores => (stores ??= { works: createStore("turnwise-works", "works"), aside: createStore("turnwise-damaged", "damaged") });

/** A device that does not answer must not keep the page from opening, ms. */
const PATIENCE = 4000;

const none: Found = { works: [], setAside: 0, available: false };

/** Reads all saved works, or says that the device keeps none. Always answers. */
export const findWorks = (): Promise<Found> =>
  Promise.race([readWorks(), new Promise<Found>((answer) => setTimeout(() => answer(none), PATIENCE))]);

/** Reads all saved works. What cannot be read is moved to a place of its own and stays there. */
async function readWorks(): Promise<Found> {
  try {
    const { works, aside } = open();
    const good: Kept[] = [];
    let setAside = 0;
    for (const [key, raw] of await entries<string, unknown>(works)) {
      const file = readSave(raw);
      if (file) good.push({ work: String(key), file });
      else {
        await set(`${Date.now()} ${String(key)}`, raw, aside);
        await del(key, works);
        setAside++;
      }
    }
    good.sort((a, b) => b.file.savedAt - a.file.savedAt);
    await Promise.all(good.slice(MOST).map(({ work }) => del(work, works)));
    return { works: good.slice(0, MOST), setAside, available: true };
  } catch {
    return none;
  }
}

/** One saved work; null when there is none, or none that can be read. */
export async function readWork(work: string): Promise<SaveFile | null> {
  try {
    return readSave(await get(work, open().works));
  } catch {
    return null;
  }
}

/** Keeps a work; false when the browser refuses. */
export async function keepWork(work: string, job: Work): Promise<boolean> {
  try {
    const file: SaveFile = { version: SAVE_VERSION, savedAt: Date.now(), job };
    await set(work, file, open().works);
    return true;
  } catch {
    return false;
  }
}

/** Takes one work out of the list. */
export async function forgetWork(work: string): Promise<void> {
  try {
    await del(work, open().works);
  } catch {
    return;
  }
}
