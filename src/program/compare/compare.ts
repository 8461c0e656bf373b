import type { Block, Program } from "../../nc/program.ts";
import { aligned, type Pair } from "./align.ts";
import { slid } from "./slide.ts";
import { bareText, isSaid, meaningOf, wordChanges, type Meaning, type WordChange } from "./meaning.ts";

/**
 * Outcome of a block. "note": only its comment, its name or a label of a cycle differs; "form": only its spelling. A
 * changed block number is no difference.
 */
export type DifferenceKind = "changed" | "added" | "removed" | "moved" | "note" | "form";

/** One difference of two programs, with the block index in each; null where it is missing. */
export interface BlockDifference {
  readonly kind: DifferenceKind;
  readonly a: number | null;
  readonly b: number | null;
  /** Changed words, also of a moved block. */
  readonly words: readonly WordChange[];
}

/** Comparison of two programs, block by block. */
export interface ProgramComparison {
  /** In the order of the second program; removed blocks keep their place. */
  readonly differences: readonly BlockDifference[];
  /** Partner of each block of the first program in the second, -1 for none. */
  readonly partners: Int32Array;
}

/** Blocks with an effect, and their meaning. */
interface SaidBlocks {
  readonly at: readonly number[];
  readonly meanings: readonly Meaning[];
  /** How likely an operation starts at each: behind a structure item, or with a tool call. */
  readonly starts: readonly number[];
}

function saidIn({ blocks }: Program): SaidBlocks {
  const at = blocks.flatMap((block, i) => (isSaid(block) ? [i] : []));
  const kindOf = (i: number) => blocks[i]?.statement.kind;
  return {
    at,
    meanings: at.map((i) => meaningOf(blocks[i] as Block)),
    starts: at.map((i) => (kindOf(i - 1) === "structure" ? 2 : kindOf(i) === "toolCall" ? 1 : 0)),
  };
}

type Naming = (meaning: Meaning) => string;

/** Pairs members of two ranges with equal names. */
function pairUp(
  a: readonly number[],
  b: readonly number[],
  [inA, inB]: readonly [SaidBlocks, SaidBlocks],
  naming: Naming,
): readonly Pair[] {
  const numbers = new Map<string, number>();
  const numbered = (list: readonly number[], { meanings }: SaidBlocks) =>
    Int32Array.from(list, (i) => {
      const name = naming(meanings[i] as Meaning);
      const known = numbers.get(name) ?? numbers.size;
      numbers.set(name, known);
      return known;
    });
  const [inOrderA, inOrderB] = [numbered(a, inA), numbered(b, inB)];
  const swapped = (list: readonly Pair[]): readonly Pair[] => list.map(([i, j]) => [j, i]);
  const removed = slid(aligned(inOrderA, inOrderB), inOrderA, b.length, (i) => inA.starts[a[i] ?? -1] ?? 0);
  const added = slid(swapped(removed), inOrderB, a.length, (j) => inB.starts[b[j] ?? -1] ?? 0);
  return swapped(added).map(([i, j]) => [a[i] ?? 0, b[j] ?? 0]);
}

/** Each range of both lists between two pairs. */
function between(
  pairs: readonly Pair[],
  n: number,
  m: number,
): readonly (readonly [readonly number[], readonly number[]])[] {
  const range = (from: number, to: number) => Array.from({ length: to - from }, (_, i) => from + i);
  let [a, b] = [0, 0];
  return [...pairs, [n, m] as const].map(([i, j]) => {
    const gap = [range(a, i), range(b, j)] as const;
    [a, b] = [i + 1, j + 1];
    return gap;
  });
}

const PASSES: readonly Naming[] = [({ key }) => key, ({ like }) => like, ({ kind }) => kind];

/** Pairs in common order: first equal meaning, then similar blocks, then blocks of one kind. */
function inOrder(both: readonly [SaidBlocks, SaidBlocks]): readonly Pair[] {
  const [{ at: a }, { at: b }] = both;
  return PASSES.reduce<readonly Pair[]>((pairs, naming) => {
    const more = between(pairs, a.length, b.length).flatMap(([one, other]) =>
      one.length > 0 && other.length > 0 ? pairUp(one, other, both, naming) : [],
    );
    return more.length === 0 ? pairs : [...pairs, ...more].sort(([i], [j]) => i - j);
  }, []);
}

/** Share of unchanged words that identifies a moved block. */
const KEPT_WORDS = 0.5;

const keepsMost = (a: Meaning, b: Meaning): boolean => {
  const all = new Set([...a.words.keys(), ...b.words.keys()]).size;
  return wordChanges(a, b).length <= all * (1 - KEPT_WORDS);
};

/** Pairs of moved blocks: equal word by word, or a cycle with most of its values. */
function movedPairs(pairs: readonly Pair[], [a, b]: readonly [SaidBlocks, SaidBlocks]): readonly Pair[] {
  const [takenA, takenB] = [new Set(pairs.map(([i]) => i)), new Set(pairs.map(([, j]) => j))];
  const moved: Pair[] = [];
  const take = (naming: (meaning: Meaning) => string | null, fits: (one: Meaning, other: Meaning) => boolean) => {
    const free = new Map<string, number[]>();
    a.meanings.forEach((meaning, i) => {
      const name = takenA.has(i) ? null : naming(meaning);
      if (name !== null) free.set(name, [...(free.get(name) ?? []), i]);
    });
    b.meanings.forEach((meaning, j) => {
      const name = takenB.has(j) ? null : naming(meaning);
      const list = name === null ? undefined : free.get(name);
      const place = list?.findIndex((i) => fits(a.meanings[i] as Meaning, meaning)) ?? -1;
      const [i] = place < 0 ? [] : (list?.splice(place, 1) ?? []);
      if (i === undefined) return;
      takenA.add(i);
      takenB.add(j);
      moved.push([i, j]);
    });
  };
  take(
    ({ key }) => key,
    () => true,
  );
  take(({ kind, like }) => (kind.startsWith("cycle ") ? like : null), keepsMost);
  return moved;
}

const spaced = (text: string): string => text.replace(/\s+/g, " ").trim();

/** Comment, name and labels of a block, without effect on the control. */
function noteOf({ statement: s, comment, raw }: Block): string {
  const parts = [comment ?? ""];
  if (s.kind === "cycle")
    parts.push(s.name, ...s.parameters.toSorted((a, b) => (a.q < b.q ? -1 : 1)).map(({ label }) => label ?? ""));
  if (s.kind === "begin" || s.kind === "end") parts.push(s.name);
  if (s.kind === "cycleLine" && s.line === 0) parts.push(s.text);
  if (s.kind === "comment" || s.kind === "structure") parts.push(s.text);
  return spaced(parts.join("\n")) + (s.kind === "unknown" ? (/;.*/.exec(raw)?.[0] ?? "") : "");
}

/** Difference in text of two blocks with the same meaning; null where only their numbers differ. */
function inWriting(a: Block, b: Block): "note" | "form" | null {
  if (a.raw === b.raw) return null;
  if (noteOf(a) !== noteOf(b)) return "note";
  return bareText(a).replace(/\r\n?/g, "\n") === bareText(b).replace(/\r\n?/g, "\n") ? null : "form";
}

/** Comments, structure items and blank lines between two pairs: pairs of equal text, and those missing on one side. */
function notesBetween(a: Program, b: Program, [fromA, toA]: Pair, [fromB, toB]: Pair): readonly BlockDifference[] {
  const notes = ({ blocks }: Program, from: number, to: number) =>
    Array.from({ length: Math.max(0, to - from) }, (_, i) => from + i).filter((i) => {
      const kind = blocks[i]?.statement.kind;
      return kind === "comment" || kind === "structure";
    });
  const [ofA, ofB] = [notes(a, fromA, toA), notes(b, fromB, toB)];
  const words = ({ blocks }: Program, i: number) => noteOf(blocks[i] as Block);
  const left = new Map<string, number>();
  for (const i of ofA) left.set(words(a, i), (left.get(words(a, i)) ?? 0) + 1);
  const added = ofB.filter((j) => {
    const count = left.get(words(b, j)) ?? 0;
    if (count > 0) left.set(words(b, j), count - 1);
    return count === 0;
  });
  const removed = ofA.filter((i) => {
    const count = left.get(words(a, i)) ?? 0;
    if (count > 0) left.set(words(a, i), count - 1);
    return count > 0;
  });
  return Array.from({ length: Math.max(added.length, removed.length) }, (_, i) => ({
    kind: "note" as const,
    a: removed[i] ?? null,
    b: added[i] ?? null,
    words: [],
  }));
}

function compareInOrder(a: Program, b: Program): ProgramComparison {
  const both = [saidIn(a), saidIn(b)] as const;
  const [saidA, saidB] = both;
  const pairs = inOrder(both);
  const moved = movedPairs(pairs, both);
  const partners = new Int32Array(a.blocks.length).fill(-1);
  for (const [i, j] of [...pairs, ...moved]) partners[saidA.at[i] ?? 0] = saidB.at[j] ?? 0;
  const [movedA, movedB] = [new Set(moved.map(([i]) => i)), new Map(moved.map(([i, j]) => [j, i]))];
  const differences: BlockDifference[] = [];
  const differ = (i: number, j: number, isMoved: boolean) => {
    const [one, other] = [saidA.at[i] ?? 0, saidB.at[j] ?? 0];
    const words = wordChanges(saidA.meanings[i] as Meaning, saidB.meanings[j] as Meaning);
    const kind = isMoved
      ? "moved"
      : words.length > 0
        ? "changed"
        : inWriting(a.blocks[one] as Block, b.blocks[other] as Block);
    if (kind) differences.push({ kind, a: one, b: other, words });
  };
  let [nextA, nextB] = [0, 0];
  for (const [i, j] of [...pairs, [saidA.at.length, saidB.at.length] as const]) {
    const [endA, endB] = [saidA.at[i] ?? a.blocks.length, saidB.at[j] ?? b.blocks.length];
    const startA = nextA === 0 ? 0 : (saidA.at[nextA - 1] ?? 0) + 1;
    const startB = nextB === 0 ? 0 : (saidB.at[nextB - 1] ?? 0) + 1;
    for (const note of notesBetween(a, b, [startA, endA], [startB, endB])) differences.push(note);
    for (; nextA < i; nextA += 1)
      if (!movedA.has(nextA)) differences.push({ kind: "removed", a: saidA.at[nextA] ?? 0, b: null, words: [] });
    for (; nextB < j; nextB += 1) {
      const from = movedB.get(nextB);
      if (from === undefined) differences.push({ kind: "added", a: null, b: saidB.at[nextB] ?? 0, words: [] });
      else differ(from, nextB, true);
    }
    if (i < saidA.at.length) differ(i, j, false);
    [nextA, nextB] = [i + 1, j + 1];
  }
  return { differences, partners };
}

const INVERSE: Readonly<Record<DifferenceKind, DifferenceKind>> = {
  changed: "changed",
  added: "removed",
  removed: "added",
  moved: "moved",
  note: "note",
  form: "form",
};

/** The same differences seen from the other program. */
function inverted({ differences, partners }: ProgramComparison, blocks: number): ProgramComparison {
  const back = new Int32Array(blocks).fill(-1);
  partners.forEach((b, a) => {
    if (b >= 0) back[b] = a;
  });
  return {
    partners: back,
    differences: differences.map(({ kind, a, b, words }) => ({
      kind: INVERSE[kind],
      a: b,
      b: a,
      words: words.map(({ name, from, to }) => ({ name, from: to, to: from })),
    })),
  };
}

/** True where the first program sorts first by its text, so that both directions pair the same blocks. */
function comesFirst(a: Program, b: Program): boolean {
  for (let i = 0; i < Math.min(a.blocks.length, b.blocks.length); i += 1) {
    const [one, other] = [a.blocks[i]?.raw ?? "", b.blocks[i]?.raw ?? ""];
    if (one !== other) return one < other;
  }
  return a.blocks.length <= b.blocks.length;
}

/**
 * Compares two programs by the meaning of their blocks: block numbers, blanks, case, word order, number format and the
 * language of names and labels do not count. Swapped programs give the inverse.
 */
export function comparePrograms(a: Program, b: Program): ProgramComparison {
  return comesFirst(a, b) ? compareInOrder(a, b) : inverted(compareInOrder(b, a), a.blocks.length);
}
