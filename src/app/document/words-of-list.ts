import type { HistoryTexts } from "../../i18n/en/history.ts";

/** Most changed values that are named with both values. */
const MOST_VALUES = 2;

/** Several changes in one line: all of a few, else the first and a count. */
export const joinedWords = (changes: readonly string[], t: HistoryTexts): string =>
  changes.length <= MOST_VALUES ? changes.join(", ") : t.more(changes[0] ?? "", changes.length - 1);

const shownText = (value: unknown, t: HistoryTexts): string =>
  typeof value === "number" || (typeof value === "string" && value !== "") ? String(value) : t.empty;

/** A name before and after. */
export const nameWords = (of: string, from: unknown, to: unknown, t: HistoryTexts): string =>
  t.value(of, shownText(from, t), shownText(to, t));

/** A value before and after: a number as the screen writes it, anything else as typed. */
export const valueWords = (of: string, from: unknown, to: unknown, t: HistoryTexts): string =>
  t.value(of, t.number(shownText(from, t)), t.number(shownText(to, t)));

/** Cells with a text that may look like a number. */
const NAMES: ReadonlySet<string> = new Set(["name", "NAME", "DOC"]);

type Cells = Readonly<Record<string, unknown>>;
const isText = (value: unknown) => value === undefined || typeof value === "string" || typeof value === "number";

/** Changes of cells that are texts or numbers; null where others changed as well. */
export function cellWords(
  before: Cells,
  after: Cells,
  t: HistoryTexts,
  nameOf: (cell: string) => string | null = (cell) => cell,
): readonly string[] | null {
  const changed = [...new Set([...Object.keys(before), ...Object.keys(after)])].filter(
    (cell) => before[cell] !== after[cell],
  );
  const named = changed.map((cell) => {
    const name = nameOf(cell);
    const canShow = name !== null && isText(before[cell]) && isText(after[cell]);
    const words = NAMES.has(cell) ? nameWords : valueWords;
    return canShow ? words(name, before[cell], after[cell], t) : null;
  });
  return named.every((each) => each !== null) ? named : null;
}

/** The words of a list. */
export interface ListWords<E> {
  readonly one: (entry: E, index: number) => string;
  readonly many: (count: number) => string;
  /** Name of the list, where entries were replaced. */
  readonly whole: string;
  readonly added: (of: string, count: number) => string;
  /** Changes of an entry; null where they are too large to name. */
  readonly cells?: (before: E, after: E) => readonly string[] | null;
}

/** The difference of two lists: entries added, deleted, moved or changed. */
export function listWords<E>(
  before: readonly E[],
  after: readonly E[],
  idOf: (entry: E) => unknown,
  w: ListWords<E>,
  t: HistoryTexts,
): string | null {
  const [was, is] = [new Map(before.map((e) => [idOf(e), e])), new Map(after.map((e) => [idOf(e), e]))];
  const added = after.filter((e) => !was.has(idOf(e)));
  const deleted = before.filter((e) => !is.has(idOf(e)));
  const changed = after.filter((e) => was.has(idOf(e)) && was.get(idOf(e)) !== e);
  const thing = (entries: readonly E[], of: readonly E[]): string => {
    const [only] = entries;
    return entries.length === 1 && only !== undefined ? w.one(only, of.indexOf(only)) : w.many(entries.length);
  };
  if (added.length > 0 && deleted.length > 0) return t.fieldChanged(w.whole);
  if (added.length > 0) return w.added(thing(added, after), added.length);
  if (deleted.length > 0) return t.deleted(thing(deleted, before), deleted.length);
  const [only] = changed;
  if (changed.length === 1 && only !== undefined) {
    const last = was.get(idOf(only));
    const name = thing(last === undefined ? changed : [last], before);
    const cells = last === undefined ? null : w.cells?.(last, only);
    return cells && cells.length > 0 && cells.length <= MOST_VALUES
      ? t.within(name, joinedWords(cells, t))
      : t.changed(name, 1);
  }
  if (changed.length > 1) return t.changed(w.many(changed.length), changed.length);
  const moved = after.filter((e, i) => idOf(e) !== idOf(before[i] as E));
  return moved.length > 0 ? t.moved(w.many(moved.length), moved.length) : null;
}
