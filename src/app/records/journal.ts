import { z } from "zod/mini";
import { moment } from "../../program/files/bounded.ts";
import { time } from "../base/clock.ts";
import { jsonOf, storedKeys, storedText, type StoredText } from "../base/storage.ts";
import { fileOf, isProgram, withText, type Work } from "../document/work.ts";
import { differenceOf, withDifference, type Difference, type Json } from "./difference.ts";
import { readSave, SAVE_VERSION, type SaveFile } from "./save-file.ts";

/*
 * What was typed and is not in the database yet. The database takes some hundred milliseconds, longer than a page that
 * closes or dies has; the key-value storage takes a small text within the task of the key. So each key writes the
 * difference from the last state that the database has, however large the work is. The next page applies it.
 */

/** A state of a work that the database has, or is being given. */
export type Stored = Pick<SaveFile, "savedAt" | "job">;

/** Unchanged characters at the start and the end of a text, and the new text between. */
export type JournalText = readonly [start: number, end: number, text: string];

/** Longest entry that is written with each key, characters; a longer one is written when the page closes. */
const LONGEST_PER_KEY = 200_000;

/** One entry. A link leads from the state of a date (null: from nothing) to the next one. */
const entryShape = z.object({
  /** When the last change was made. */
  at: moment,
  version: z.int(),
  links: z.array(z.object({ from: z.nullable(moment), by: z.unknown() })).check(z.maxLength(2)),
  /** What a text editor has beyond that. */
  typed: z.optional(z.object({ file: z.string(), text: z.tuple([z.int(), z.int(), z.string()]) })),
});
export type JournalEntry = z.output<typeof entryShape>;

interface Kept {
  readonly now: Work;
  readonly base: Stored | undefined;
  readonly writing: Stored | undefined;
  readonly links: JournalEntry["links"];
  readonly typed: { readonly file: string; readonly text: JournalText } | null;
}

const PREFIX = "journal/";
const onDevice = (work: string): StoredText => storedText(PREFIX + work);
/** Of large entries; it survives a reload only, but has a space of its own. */
const inTab = (work: string): StoredText => storedText(PREFIX + work, "tab");

const kept = new Map<string, Kept>();
/** Works whose newest entry is not written. */
const unwritten = new Set<string>();

const entryOf = ({ links, typed }: Kept): string =>
  JSON.stringify({ at: time(), version: SAVE_VERSION, links, ...(typed && { typed }) });

/** False if the entry is too large to be written with each key. */
function write(work: string, entry: Kept): boolean {
  kept.set(work, entry);
  if (entry.base?.job === entry.now && !entry.writing && !entry.typed) {
    kept.set(work, { ...entry, links: [] });
    remove(work);
    return true;
  }
  const text = entryOf(entry);
  if (text.length <= LONGEST_PER_KEY && onDevice(work).set(text)) {
    unwritten.delete(work);
    return true;
  }
  unwritten.add(work);
  // Without a state to start from, at least what is typed while the first one is written.
  const last = entryOf({ ...entry, links: entry.links.slice(1) });
  if (entry.links.length > 1 && last.length <= LONGEST_PER_KEY) onDevice(work).set(last);
  return text.length <= LONGEST_PER_KEY;
}

function remove(work: string): void {
  unwritten.delete(work);
  onDevice(work).set(null);
  inTab(work).set(null);
}

const between = (from: Work, to: Work): Difference => differenceOf(from as unknown as Json, to as unknown as Json);

/**
 * Notes the newest state of a work, the last one that the database has, and the one it is being given. False if it is
 * too large to be written with each key.
 */
export function noteState(work: string, now: Work, base: Stored | undefined, writing?: Stored): boolean {
  const before = kept.get(work);
  // The first link stays the same while a state is being written.
  const isSameFirst = writing !== undefined && before?.writing === writing && before.base === base;
  const first = { from: base?.savedAt ?? null, by: differenceFrom(base, writing?.job ?? now) };
  const links = writing
    ? [
        isSameFirst && before.links[0] ? before.links[0] : first,
        { from: writing.savedAt, by: between(writing.job, now) },
      ]
    : [first];
  return write(work, { now, base, writing, links, typed: null });
}

const differenceFrom = (base: Stored | undefined, to: Work): Difference =>
  base ? between(base.job, to) : { to: to as unknown as Json };

/** Notes what a text editor has beyond the state of the work; null: nothing. */
export function noteTyped(work: string, file: string, text: JournalText | null): void {
  const entry = kept.get(work);
  if (!entry || (!entry.typed && !text)) return;
  const links = entry.links.length > 0 || !entry.base ? entry.links : [{ from: entry.base.savedAt, by: 0 }];
  write(work, { ...entry, links, typed: text && { file, text } });
}

/** The same after a write: the state that it stored is the one that changes start from. */
export function noteStored(work: string, now: Work, base: Stored): void {
  const typed = kept.get(work)?.now === now ? (kept.get(work)?.typed ?? null) : null;
  noteState(work, now, base);
  if (typed) noteTyped(work, typed.file, typed.text);
}

/** Leaves the entry of a work to the tab that has taken it. */
export function leaveJournal(work: string): void {
  kept.delete(work);
  unwritten.delete(work);
}

/** Drops the entry of a work: it is deleted, or its state is elsewhere. */
export function forgetJournal(work: string): void {
  kept.delete(work);
  remove(work);
}

/** Writes what is too large to be written with each key; returns the works for which there is no space. */
export function writeLarge(): readonly string[] {
  for (const work of [...unwritten]) {
    const entry = kept.get(work);
    if (!entry || inTab(work).set(entryOf(entry)) || onDevice(work).set(entryOf(entry))) unwritten.delete(work);
  }
  return [...unwritten];
}

/** Works with an entry: of this page, of one that died, or of another tab. */
export const journalWorks = (): readonly string[] => [
  ...new Set([...storedKeys(PREFIX), ...storedKeys(PREFIX, "tab")].map((key) => key.slice(PREFIX.length))),
];

/** The newest entry of a work on this device; null if there is none that can be read. */
export function readJournal(work: string): JournalEntry | null {
  const all = [onDevice(work), inTab(work)].flatMap((text) => entryShape.safeParse(jsonOf(text.get())).data ?? []);
  return all.toSorted((a, b) => b.at - a.at)[0] ?? null;
}

function withTyped(work: Work, { file, text }: NonNullable<JournalEntry["typed"]>): Work {
  const before = isProgram(work) ? fileOf(work, file) : undefined;
  return isProgram(work) && before ? withText(work, file, withDifference(before.text, { text }) as string) : work;
}

/**
 * The state that an entry leads to from the one in the database (null: none). Null if that is the newer one, or another
 * than the entry starts from.
 */
export function stateAfter({ at, version, links, typed }: JournalEntry, stored: Stored | null): Work | null {
  // A difference that an older edition wrote is one between states of its own form.
  const isOurs = version === SAVE_VERSION;
  const own = links.findIndex(({ from }) => isOurs && from !== null && from === stored?.savedAt);
  const whole = links.findIndex(({ from }) => from === null && (!stored || stored.savedAt < at));
  const first = own < 0 ? whole : own;
  if (first < 0) return null;
  try {
    const start = (own < 0 ? null : stored?.job) as unknown as Json;
    const end = links.slice(first).reduce((state, { by }) => withDifference(state, by as Difference), start);
    const read = readSave({ version, savedAt: at, job: end });
    return read && (typed ? withTyped(read.job, typed) : read.job);
  } catch {
    return null;
  }
}
