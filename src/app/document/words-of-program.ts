import type { HistoryTexts } from "../../i18n/en/history.ts";
import { blockNumbers, type Block, type Program } from "../../nc/program.ts";
import { comparePrograms, type BlockDifference } from "../../program/compare/compare.ts";
import { joinedWords, valueWords } from "./words-of-list.ts";

/** Text of a block without its number: inserting a block renumbers all that follow. */
const unnumbered = ({ raw, number }: Block): string =>
  number === null ? raw : raw.replace(/^(\s*(?:\/\s*)?)\d+/, "$1");
const isSame = (a: Block | undefined, b: Block | undefined): boolean =>
  a === b || (a !== undefined && b !== undefined && unnumbered(a) === unnumbered(b));

/** Number of equal blocks at the start and at the end of two programs. */
function equalEnds({ blocks: a }: Program, { blocks: b }: Program): readonly [start: number, end: number] {
  const most = Math.min(a.length, b.length);
  let [start, end] = [0, 0];
  while (start < most && isSame(a[start], b[start])) start += 1;
  while (end < most - start && isSame(a[a.length - 1 - end], b[b.length - 1 - end])) end += 1;
  return [start, end];
}

/** Most blocks of a side that are compared one by one: 300,000 take seconds. */
const MOST_COMPARED = 10_000;

/** The blocks of one side of a difference, by their index in the program. */
interface Side {
  readonly program: Program;
  readonly at: readonly number[];
}

/** The numbers of blocks. */
function numberWords({ program, at }: Side, t: HistoryTexts): string {
  const numbers = blockNumbers(program);
  const [first = 0, last = first] = [at[0], at.at(-1)];
  if (at.length === 1) return t.block(numbers[first] ?? 0);
  return last - first === at.length - 1 ? t.blocks(numbers[first] ?? 0, numbers[last] ?? 0) : t.blockCount(at.length);
}

/** The cycle that blocks define, if it is one; else their numbers; and how many things that names. */
function blockWords(side: Side, t: HistoryTexts): readonly [words: string, count: number] {
  const cycles = side.at.flatMap((i) => {
    const s = side.program.blocks[i]?.statement;
    return s?.kind === "cycle" || s?.kind === "cycleLine" ? [s.cycle] : [];
  });
  return new Set(cycles).size === 1 ? [t.cycle(String(cycles[0])), 1] : [numberWords(side, t), side.at.length];
}

/** The side of all differences; null where one of them lacks it. */
function sideOf(differences: readonly BlockDifference[], side: "a" | "b", program: Program): Side | null {
  const at = differences.map((each) => each[side]);
  return at.every((i) => i !== null) ? { program, at: at.toSorted((i, j) => i - j) } : null;
}

const namesValues = ({ kind, words }: BlockDifference): boolean =>
  kind === "changed" && words.every(({ name }) => name !== "/");

/** The difference of two programs; null where there is none. */
export function programWords(before: Program, after: Program, t: HistoryTexts): string | null {
  const [start, end] = equalEnds(before, after);
  const middle = ({ blocks }: Program): Program => ({ blocks: blocks.slice(start, blocks.length - end) });
  const all = (program: Program): Side => ({
    program,
    at: program.blocks.slice(start, program.blocks.length - end).map((_, i) => start + i),
  });
  const [was, is] = [all(before), all(after)];
  if (Math.max(was.at.length, is.at.length) > MOST_COMPARED) {
    if (was.at.length === 0) return t.inserted(numberWords(is, t), is.at.length);
    if (is.at.length === 0) return t.deleted(numberWords(was, t), was.at.length);
    return t.changed(numberWords(is, t), is.at.length);
  }
  const differences = comparePrograms(middle(before), middle(after)).differences.map((each) => ({
    ...each,
    a: each.a === null ? null : each.a + start,
    b: each.b === null ? null : each.b + start,
  }));
  const [a, b] = [sideOf(differences, "a", before), sideOf(differences, "b", after)];
  const [only] = differences;
  if (!only) {
    // Blank lines have no meaning.
    if (before.blocks.length !== after.blocks.length) return t.fieldChanged(t.fields.text);
    return before.blocks.some(({ raw }, i) => raw !== after.blocks[i]?.raw) ? t.fieldChanged(t.fields.numbers) : null;
  }
  const every = (side: "a" | "b") => differences.every((each) => each[side] === null);
  if (every("a") && b) return t.inserted(...blockWords(b, t));
  if (every("b") && a) return t.deleted(...blockWords(a, t));
  if (b && differences.every(({ kind }) => kind === "moved")) return t.moved(...blockWords(b, t));
  if (differences.length === 1 && b && namesValues(only)) {
    const values = only.words.map(({ name, from, to }) => valueWords(name, from, to, t));
    return t.within(numberWords(b, t), joinedWords(values, t));
  }
  const changed = sideOf(
    differences.filter((each) => each.b !== null),
    "b",
    after,
  );
  return changed ? t.changed(numberWords(changed, t), changed.at.length) : t.fieldChanged(t.fields.text);
}
