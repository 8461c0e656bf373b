import { create, type StoreApi, type UseBoundStore } from "zustand";
import { z } from "zod/mini";
import { sieved, type UnreadRow } from "../../program/files/bounded.ts";
import { setAside } from "./set-aside.ts";
import { jsonOf, storedText } from "./storage.ts";
import { notice } from "./notices.ts";
import { isSameData } from "./same.ts";
import { TYPING } from "./waits.ts";

/**
 * A stored value. `trouble`: the stored data could not be read and were set aside, or the device refuses changes, also
 * because a newer edition wrote them.
 */
export interface Recorded<T> {
  readonly list: T;
  readonly trouble: "none" | "damaged" | "notKept";
}

/** Declares a stored value. `K`: its data as stored, apart from their version. */
export interface Declaration<T, K> {
  /** Key in the browser's storage, after `turnwise/`. Unreadable data are moved to `key/damaged`. */
  readonly key: string;
  readonly version: number;
  /** Schema of this version and of all earlier ones that can be read. */
  readonly schema: z.ZodMiniType<K>;
  /**
   * Its list, whose rows are read one by one: one that does not pass, or is beyond the first `most`, is set aside, and
   * the others are used.
   */
  readonly rows?: { readonly of: string; readonly each: z.ZodMiniType<unknown>; readonly most?: number };
  /** Upgrades a value from the version of this number to the next. */
  readonly upgrades?: Readonly<Record<number, (value: T) => T>>;
  readonly from: (kept: K) => T;
  readonly to: (value: T) => object;
  /** Initial value. It is not stored, so that a later edition can start with a better one. */
  readonly first: T;
  readonly isSame?: (one: T, other: T) => boolean;
  /** The document whose history has its changes; by default the record is a document of its own. */
  readonly document?: string;
  /**
   * Set if changes are steps of undo that survive a reload. Called with the owner of the steps when another tab
   * replaces the value.
   */
  readonly undo?: (of: object) => void;
  /** Reports damaged data, or a device that refuses changes. */
  readonly say?: (trouble: "damaged" | "notKept") => void;
}

/** A value that is stored on the device and shared by all tabs. */
export interface KeptRecord<T> {
  readonly key: string;
  /** The document whose history has its changes. */
  readonly document: string;
  readonly first: T;
  readonly use: UseBoundStore<StoreApi<Recorded<T>>>;
  now(): T;
  /** Sets the value; also the owner of its steps of undo. */
  put(value: T): void;
  /** Sets a value from the device or another tab: earlier changes cannot be undone here. */
  replace(value: T): void;
  isSame(one: T, other: T): boolean;
  /** Data for storage and backup. */
  write(value: T): object;
  /** A value from untrusted data, without the rows that do not pass; null if they are damaged or of a newer version. */
  read(raw: unknown): T | null;
  /** The rows that do not pass. */
  unread(raw: unknown): readonly UnreadRow[];
  /** Whether untrusted data are of a newer version. */
  isNewer(raw: unknown): boolean;
}

/** A record of any type. */
interface AnyRecord {
  readonly key: string;
  readonly document: string;
  now(): unknown;
  put(value: unknown): void;
}
const undone: AnyRecord[] = [];

/** The records whose steps of undo survive a reload. */
export const undoneRecords = (): readonly AnyRecord[] => undone;

const versioned = z.object({ version: z.int() });

/** Declares a stored value: loads it, stores each change a moment later, and takes over changes of other tabs. */
export function record<T, K>(declared: Declaration<T, K>): KeptRecord<T> {
  const { key, version, schema, rows, upgrades = {}, from, to, first, isSame = isSameData, undo, say } = declared;
  const { document = key } = declared;
  const use = create<Recorded<T>>(() => ({ list: first, trouble: "none" }));
  const now = () => use.getState().list;
  const put = (list: T) => {
    if (list !== now()) use.setState({ list });
  };
  const replace = (value: T) => {
    put(value);
    undo?.(put);
  };
  const write = (value: T) => ({ version, ...to(value) });
  const sieve = (raw: unknown) => (rows ? sieved(raw, rows.of, rows.each, rows.most) : { raw, unread: [] });
  const isNewer = (raw: unknown) => (versioned.safeParse(raw).data?.version ?? 0) > version;
  const unread = (raw: unknown) => (isNewer(raw) ? [] : sieve(raw).unread);
  const read = (raw: unknown): T | null => {
    const head = versioned.safeParse(raw),
      kept = schema.safeParse(sieve(raw).raw);
    if (!head.success || !kept.success) return null;
    let value = from(kept.data);
    for (let { version: of } = head.data; of !== version; of++) {
      const upgrade = upgrades[of];
      if (!upgrade) return null;
      value = upgrade(value);
    }
    return value;
  };
  const made: KeptRecord<T> = { key, document, first, use, now, put, replace, isSame, write, read, unread, isNewer };
  if (undo) undone.push(made);
  keep(made, (trouble) => {
    use.setState({ trouble });
    say?.(trouble);
  });
  return made;
}

/** Stores a record on the device and follows other tabs. */
function keep<T>(
  { key, first, use, now, replace, isSame, write, read, unread, isNewer }: KeptRecord<T>,
  say: (trouble: "damaged" | "notKept") => void,
): void {
  const text = storedText(key);
  /** A newer edition wrote it: it is left alone. */
  let isLocked = false;
  const takeOver = (kept: string | null) => {
    const raw = jsonOf(kept);
    isLocked = isNewer(raw);
    if (isLocked) return notice("newerData");
    const value = kept === null ? first : read(raw);
    if (value === null) {
      say("damaged");
      if (setAside(key, [{ name: key, raw: raw ?? kept }])) text.set(null);
      return;
    }
    if (!isSame(value, now())) replace(value);
    const rows = unread(raw);
    if (rows.length === 0) return;
    notice("rowsAside");
    if (setAside(key, rows)) text.set(JSON.stringify(write(value)));
  };
  const found = text.get();
  if (found === undefined) return;
  takeOver(found);
  let timer: ReturnType<typeof setTimeout> | undefined;
  let written = now();
  const writeNow = () => {
    clearTimeout(timer);
    timer = undefined;
    const value = now();
    if (value === written) return;
    written = value;
    if (isLocked) return say("notKept");
    if (!text.set(isSame(value, first) ? null : JSON.stringify(write(value)))) say("notKept");
  };
  use.subscribe(() => {
    timer ??= setTimeout(writeNow, TYPING.keep);
  });
  text.follow((kept) => {
    takeOver(kept);
    written = now();
  });
  addEventListener("pagehide", writeNow);
  document.addEventListener("visibilitychange", writeNow);
}
