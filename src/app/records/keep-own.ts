import { z } from "zod/mini";
import type { OwnList } from "../../program/edits/own-library.ts";
import { keepTable } from "../base/device-table.ts";
import { notice } from "../base/notices.ts";
import { takeOwn, useOwn } from "../document/own-store.ts";

/*
 * The own cycles are kept on the device as soon as there is one. All tabs share them: what one tab changes the others take over.
 */
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

/** Reads the own cycles of this device and keeps each change from now on. */
export const startOwn = (): () => void =>
  keepTable<OwnList>({
    key: "turnwise/own-cycles",
    aside: "turnwise/own-cycles/damaged",
    store: useOwn,
    first: [],
    isSame: (one, other) => writeKeptOwn(one) === writeKeptOwn(other),
    write: writeKeptOwn,
    read: readKeptOwn,
    take: takeOwn,
    damaged: () => notice("ownDamaged"),
    notKept: () => notice("ownNotKept"),
  });
