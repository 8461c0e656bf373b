import { create, type StoreApi, type UseBoundStore } from "zustand";
import { z } from "zod/mini";
import { jsonOf, keptText } from "./kept.ts";
import { isSameData } from "./same.ts";

/**
 * A value that is kept. `trouble`: what was kept could not be read and was set aside, or the device does not take what
 * is changed.
 */
export interface Recorded<T> {
  readonly list: T;
  readonly trouble: "none" | "damaged" | "notKept";
}

/** What is said once of something that the device keeps. `K`: its data as they are kept, beside their version. */
export interface Declaration<T, K> {
  /**
   * Where the storage of the browser has it, behind `turnwise/`. What cannot be read is set aside under `key/damaged`.
   */
  readonly key: string;
  readonly version: number;
  /** Data of this version and of all before that can be read. */
  readonly schema: z.ZodMiniType<K>;
  /** What makes a value of an older version, by its number, one of the next. */
  readonly upgrades?: Readonly<Record<number, (value: T) => T>>;
  readonly from: (kept: K) => T;
  readonly to: (value: T) => object;
  /**
   * What there is where nothing is kept. It is not kept itself, so that another edition can begin with a better one.
   */
  readonly first: T;
  readonly isSame?: (one: T, other: T) => boolean;
  /**
   * Changes are steps of undo that outlast a reload. It is called with what they are steps of when another tab replaces
   * the value.
   */
  readonly undo?: (of: object) => void;
  /** Says that what was kept is damaged, or that the device does not take what is changed. */
  readonly say?: (trouble: "damaged" | "notKept") => void;
}

/** Something that the device keeps and that all tabs share. */
export interface KeptRecord<T> {
  readonly key: string;
  readonly first: T;
  readonly use: UseBoundStore<StoreApi<Recorded<T>>>;
  now(): T;
  /** Puts a value in place; what its steps of undo are steps of. */
  put(value: T): void;
  /** Puts a value in place that comes from the device or from another tab: nothing before it can be undone here. */
  replace(value: T): void;
  isSame(one: T, other: T): boolean;
  /** Data as they are kept and archived. */
  write(value: T): object;
  /** A value from data that anybody may have written; null where they are damaged or of a newer version. */
  read(raw: unknown): T | null;
}

/** A record of whatever kind, by its key. */
interface AnyRecord {
  readonly key: string;
  now(): unknown;
  put(value: unknown): void;
}
const undone: AnyRecord[] = [];

/** The records whose steps of undo outlast a reload. */
export const undoneRecords = (): readonly AnyRecord[] => undone;

/** Rest before writing, ms. */
const REST = 80;

const versioned = z.object({ version: z.int() });

/**
 * Declares something that the device keeps. From then on it is what the device has, each change is kept a moment after
 * it was made, and what another tab changes is taken over.
 */
export function record<T, K>(declared: Declaration<T, K>): KeptRecord<T> {
  const { key, version, schema, upgrades = {}, from, to, first, isSame = isSameData, undo, say } = declared;
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
  const read = (raw: unknown): T | null => {
    const head = versioned.safeParse(raw),
      kept = schema.safeParse(raw);
    if (!head.success || !kept.success) return null;
    let value = from(kept.data);
    for (let { version: of } = head.data; of !== version; of++) {
      const upgrade = upgrades[of];
      if (!upgrade) return null;
      value = upgrade(value);
    }
    return value;
  };
  const made: KeptRecord<T> = { key, first, use, now, put, replace, isSame, write, read };
  if (undo) undone.push(made);
  keep(made, (trouble) => {
    use.setState({ trouble });
    say?.(trouble);
  });
  return made;
}

/** Keeps a record on the device and follows other tabs. */
function keep<T>(
  { key, first, use, now, replace, isSame, write, read }: KeptRecord<T>,
  say: (trouble: "damaged" | "notKept") => void,
): void {
  const text = keptText(key),
    aside = keptText(`${key}/damaged`);
  const takeOver = (kept: string | null) => {
    const value = kept === null ? first : read(jsonOf(kept));
    if (value !== null) {
      if (!isSame(value, now())) replace(value);
      return;
    }
    say("damaged");
    if (aside.set(kept)) text.set(null);
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
    if (!text.set(isSame(value, first) ? null : JSON.stringify(write(value)))) say("notKept");
  };
  use.subscribe(() => {
    timer ??= setTimeout(writeNow, REST);
  });
  text.follow((kept) => {
    takeOver(kept);
    written = now();
  });
  addEventListener("pagehide", writeNow);
  document.addEventListener("visibilitychange", writeNow);
}
