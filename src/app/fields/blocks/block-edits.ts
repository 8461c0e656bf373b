import { renumbered, withInserted, withoutBlocks } from "../../../nc/edit.ts";
import { parse } from "../../../nc/parse.ts";
import type { Block, Program } from "../../../nc/program.ts";
import type { Statement } from "../../../nc/statement.ts";

/** A text replacement; offsets are in the old text. */
export interface TextChange {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

const lineEndOf = (raw: string) => /(?:\r\n|\n|\r)$/.exec(raw)?.[0] ?? "";
const withoutEnd = (raw: string) => raw.slice(0, raw.length - lineEndOf(raw).length);
/** Replaces the number of a block that has one. */
const numbered = (raw: string, number: number | null) =>
  number === null ? raw : raw.replace(/^([^\S\r\n]*(?:\/[^\S\r\n]*)?)\d+/, `$1${number}`);

/** The smallest replacement between two texts; null if they are equal. */
function difference(before: string, after: string, offset: number): TextChange | null {
  if (before === after) return null;
  const most = Math.min(before.length, after.length);
  let front = 0;
  while (front < most && before[front] === after[front]) front += 1;
  let back = 0;
  while (back < most - front && before[before.length - 1 - back] === after[after.length - 1 - back]) back += 1;
  return { from: offset + front, to: offset + before.length - back, insert: after.slice(front, after.length - back) };
}

/** Text replacements that turn one program into another; equal blocks stay untouched. */
export function changesBetween(before: Program, after: Program): readonly TextChange[] {
  const [a, b] = [before.blocks, after.blocks];
  let front = 0;
  let offset = 0;
  for (; front < a.length && front < b.length && a[front] === b[front]; front += 1) offset += a[front]?.raw.length ?? 0;
  const by = b.length - a.length;
  const raw = (blocks: readonly Block[], from: number, to: number) =>
    blocks
      .slice(from, to)
      .map((each) => each.raw)
      .join("");
  const changes: TextChange[] = [];
  const put = (old: string, fresh: string) => {
    const change = difference(old, fresh, offset);
    if (change) changes.push(change);
    offset += old.length;
  };
  put(raw(a, front, front + Math.max(0, -by)), raw(b, front, front + Math.max(0, by)));
  for (let i = front + Math.max(0, -by); i < a.length; i += 1) put(a[i]?.raw ?? "", b[i + by]?.raw ?? "");
  return changes;
}

/** Inserts a block after another one, in the style of its surroundings. */
export const inserted = (program: Program, index: number, statement: Statement): Program =>
  withInserted(program, index, statement);

export const removed = (program: Program, index: number): Program => withoutBlocks(program, index);

/** Duplicates a block, character by character. */
export function duplicated(program: Program, index: number): Program {
  const block = program.blocks[index];
  if (!block) return program;
  const newLine = lineEndOf(block.raw) || lineEndOf(program.blocks[index - 1]?.raw ?? "") || "\n";
  const first = { ...block, raw: withoutEnd(block.raw) + newLine };
  const second = {
    ...block,
    number: block.number === null ? null : block.number + 1,
    raw: numbered(block.raw, block.number === null ? null : block.number + 1),
  };
  return renumbered({ blocks: program.blocks.toSpliced(index, 1, first, second) }, index + 2);
}

/** Swaps a block with the next one; the block numbers stay in place. */
export function exchanged(program: Program, index: number): Program {
  const [a, b] = [program.blocks[index], program.blocks[index + 1]];
  if (!a || !b) return program;
  const both = a.number !== null && b.number !== null;
  const upper = withoutEnd(both ? numbered(b.raw, a.number) : b.raw) + (lineEndOf(a.raw) || lineEndOf(b.raw));
  const lower = withoutEnd(both ? numbered(a.raw, b.number) : a.raw) + lineEndOf(b.raw);
  return { blocks: program.blocks.toSpliced(index, 2, ...parse(upper).blocks, ...parse(lower).blocks) };
}
