import type { BlockIssue } from "./issue.ts";
import type { Block, Program } from "./program.ts";

/** The text before a block's number: blanks, a skip mark, the letter N. */
const NUMBER = /^([ \t\u00a0\ufeff]*(?:\/[ \t]*)?[Nn]?)\d+/;
const SKIP = /^([ \t\u00a0\ufeff]*)\/[ \t]*/;
const LINE_END = /(?:\r\n|\n|\r)$/;

const lineEndOf = (raw: string): string => LINE_END.exec(raw)?.[0] ?? "";
const shiftedBy = ({ issues }: Block, by: number): Pick<Block, "issues"> =>
  issues
    ? {
        issues: issues.map((found) => ({
          ...found,
          offset: found.offset + by,
          ...(found.fix && { fix: { ...found.fix, offset: found.fix.offset + by } }),
        })) as readonly BlockIssue[],
      }
    : {};

/** A block with another number; a block without a number stays without. */
export function withNumber(block: Block, number: number): Block {
  if (block.number === null || block.number === number) return block;
  const raw = block.raw.replace(NUMBER, `$1${number}`);
  return { ...block, number, raw, ...shiftedBy(block, raw.length - block.raw.length) };
}

/** A block with or without a skip mark; everything else stays unchanged. */
export function withSkip(block: Block, skip: boolean): Block {
  const { skip: was = false, ...unmarked } = block;
  if (was === skip) return block;
  const raw = skip
    ? block.raw.replace(/^[ \t\u00a0\ufeff]*/, "$&/")
    : SKIP.test(block.raw)
      ? block.raw.replace(SKIP, "$1")
      : block.raw.replace("/", "");
  return { ...unmarked, ...(skip && { skip }), raw, ...shiftedBy(block, raw.length - block.raw.length) };
}

/** The block number increment of the file. */
function stepOf(blocks: readonly Block[]): number {
  const counts = new Map<number, number>();
  let before: number | null = null;
  for (const { number } of blocks) {
    if (number === null) continue;
    if (before !== null && number > before) counts.set(number - before, (counts.get(number - before) ?? 0) + 1);
    before = number;
  }
  return [...counts].toSorted(([, a], [, b]) => b - a)[0]?.[0] ?? 1;
}

const numbersOf = (blocks: readonly Block[]): readonly number[] =>
  blocks.flatMap(({ number }) => (number === null ? [] : [number]));

/** Assigns these numbers to the numbered blocks in order. */
function renumberedBy(blocks: readonly Block[], numbers: readonly number[]): readonly Block[] {
  let next = 0;
  return blocks.map((block) => {
    if (block.number === null) return block;
    const made = withNumber(block, numbers[next] ?? block.number);
    next += 1;
    return made;
  });
}

/**
 * The program with other blocks. Unchanged blocks at either end stay as they are; the rest take the old numbers in
 * order. With more or fewer blocks the numbering continues in the increment of the file, also for the blocks after
 * them. A last line without a line end stays the only one.
 */
export function withBlocks(program: Program, wanted: readonly Block[]): Program {
  const old = program.blocks;
  let front = 0;
  while (front < old.length && front < wanted.length && old[front] === wanted[front]) front += 1;
  let behind = 0;
  while (
    behind < Math.min(old.length, wanted.length) - front &&
    old[old.length - 1 - behind] === wanted[wanted.length - 1 - behind]
  )
    behind += 1;
  const ends = [
    old.slice(0, front),
    wanted.slice(front, wanted.length - behind),
    old.slice(old.length - behind),
  ] as const;
  const was = numbersOf(old.slice(front, old.length - behind));
  const many = numbersOf(ends[1]).length;
  const middle = (numbers: readonly number[]) => renumberedBy(ends[1], numbers);
  if (many === was.length) return { blocks: withLineEnds([...ends[0], ...middle(was), ...ends[2]], old) };
  const step = stepOf(old);
  const next = was.at(-1) ?? numbersOf(ends[0]).at(-1) ?? (numbersOf(ends[2])[0] ?? 0) - step;
  const numbers = Array.from({ length: many }, (_, i) => was[i] ?? next + (i + 1 - was.length) * step);
  const shift = (many - was.length) * step;
  const back = ends[2].map((block) =>
    block.number === null ? block : withNumber(block, Math.max(0, block.number + shift)),
  );
  return { blocks: withLineEnds([...ends[0], ...middle(numbers), ...back], old) };
}

/** Every block but the last ends its line; the last one does when it did before. */
function withLineEnds(blocks: readonly Block[], old: readonly Block[]): readonly Block[] {
  const end = old.map(({ raw }) => lineEndOf(raw)).find((each) => each !== "") ?? "\n";
  const isOpen = lineEndOf(old.at(-1)?.raw ?? "") === "";
  return blocks.map((block, i) => {
    const own = lineEndOf(block.raw);
    if (i < blocks.length - 1) return own === "" ? { ...block, raw: block.raw + end } : block;
    return isOpen && own !== "" ? { ...block, raw: block.raw.slice(0, -own.length) } : block;
  });
}
