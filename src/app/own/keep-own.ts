import { z } from "zod/mini";
import type { OwnList } from "../../program/own-library.ts";
import { notice } from "../saving/keep.ts";
import { takeOwn, useOwn } from "./own-store.ts";

/*
 * The own cycles are kept on the device as soon as there is one. All tabs share them: what one tab changes the others take over.
 */
const KEY = "turnwise/own-cycles";
const ASIDE = "turnwise/own-cycles/damaged";
const VERSION = 1;

const text = z.string().check(z.maxLength(500));
const parameter = z.object({
  id: text,
  q: text,
  prompt: text,
  kind: z.enum(["length", "angle", "feed", "choice", "number"]),
  min: text,
  max: text,
  first: text,
  choices: text,
});
const file = z.object({
  version: z.literal(VERSION),
  cycles: z.array(z.object({ id: text, number: text, name: text, parameters: z.array(parameter) })),
});

const isUnique = (all: readonly { readonly id: string }[]): boolean => new Set(all.map(({ id }) => id)).size === all.length;

/** The text that is kept; null where there is nothing to keep. */
export const writeKeptOwn =
  (list: OwnList): string | null => (list.length === 0 ? null : JSON.stringify({ version: VERSION, cycles: list }));

/** A kept list, or null when it is damaged. Never throws. */
export function readKeptOwn(kept: string): OwnList | null {
  try {
    const read = file.safeParse(JSON.parse(kept));
    if (!read.success) return null;
    const { cycles } = read.data;
    return isUnique(cycles) && cycles.every(({ parameters }) => isUnique(parameters)) ? cycles : null;
  } catch {
    return null;
  }
}

/** Takes over what the device holds. What cannot be read is set aside. */
function take(kept: string | null): void {
  const list = kept === null ? [] : readKeptOwn(kept);
  if (list) {
    if (writeKeptOwn(list) !== writeKeptOwn(useOwn.getState().list)) takeOwn(list);
    return;
  }
  notice("ownDamaged");
  try {
    localStorage.setItem(ASIDE, kept ?? "");
    localStorage.removeItem(KEY);
  } catch {
    return;
  }
}

/** Rest before writing, ms. */
const REST = 80;

/** Reads the own cycles of this device and keeps each change from now on. */
export function startOwn(): () => void {
  try {
    take(localStorage.getItem(KEY));
  } catch {
    return () => undefined;
  }
  let timer: ReturnType<typeof setTimeout> | undefined;
  let written = useOwn.getState().list;
  const write = () => {
    clearTimeout(timer);
    timer = undefined;
    const { list } = useOwn.getState();
    if (list === written) return;
    written = list;
    try {
      const kept = writeKeptOwn(list);
      if (kept === null) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, kept);
    } catch {
      notice("ownNotKept");
    }
  };
  const fromOtherTab = (event: StorageEvent) => {
    if (event.storageArea !== localStorage || (event.key !== KEY && event.key !== null)) return;
    take(event.newValue);
    written = useOwn.getState().list;
  };
  const stop = useOwn.subscribe(() => {
    timer ??= setTimeout(write, REST);
  });
  addEventListener("storage", fromOtherTab);
  addEventListener("pagehide", write);
  document.addEventListener("visibilitychange", write);
  return () => {
    write();
    stop();
    removeEventListener("storage", fromOtherTab);
    removeEventListener("pagehide", write);
    document.removeEventListener("visibilitychange", write);
  };
}
