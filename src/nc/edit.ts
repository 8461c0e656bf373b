import { withChangedWords } from "./changed-words.ts";
import type { BlockIssue } from "./issue.ts";
import { parse } from "./parse.ts";
import { parameterValueText } from "./print-words.ts";
import { statementLines } from "./print.ts";
import type { Block, Program } from "./program.ts";
import { styleAt } from "./read-style.ts";
import type { Statement } from "./statement.ts";
import type { Style } from "./style.ts";

const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);

/** Number and skip mark in front of a block, exactly as written. */
const headOf = (raw: string) =>
  /^[ \t\u00a0\ufeff]*\/?[ \t]*(?:[Nn]?\d+(?![\d.,])[ \t\u00a0]*\/?)?[ \t\u00a0]*/.exec(raw)?.[0] ?? "";
const lineEndOf = (raw: string) => /(?:\r\n|\n|\r)$/.exec(raw)?.[0] ?? "";

/** Whether two statements are equal, in whatever order their properties were set. */
function saysTheSame(a: unknown, b: unknown): boolean {
  const sorted = (_: string, value: unknown) =>
    value !== null && typeof value === "object" && !Array.isArray(value)
      ? Object.fromEntries(Object.entries(value).toSorted(([x], [y]) => (x < y ? -1 : 1)))
      : value;
  return JSON.stringify(a, sorted) === JSON.stringify(b, sorted);
}

type CycleStatement = Extract<Statement, { kind: "cycle" }>;

/** The text with changed cycle values only: labels, columns and spacing stay. Null where more than values changed. */
function withValues(raw: string, before: CycleStatement, after: CycleStatement, style: Style): string | null {
  const shape = (s: CycleStatement) => ({ ...s, parameters: s.parameters.map((p) => [p.q, p.label]) });
  if (!same(shape(before), shape(after))) return null;
  let text = raw;
  for (const [i, p] of after.parameters.entries()) {
    if (same(p.value, before.parameters[i]?.value)) continue;
    const at = new RegExp(
      String.raw`((?:^|[\s])${p.q}[ \t]*=?[ \t]*)([^\s;~]*(?:(?<=[+-]|[=\s]F)[ \t]+[^\s;~]+)?)`,
      "i",
    ).exec(text);
    if (!at) return null;
    const written = parameterValueText(p.value, style);
    const front = (at[1] ?? "").includes("=") ? (at[1] ?? "") : `${(at[1] ?? "").trimEnd()}=`;
    // The blanks behind an empty value stay behind the new one.
    const gap = at[2] === "" ? front.slice(front.trimEnd().length) : "";
    text =
      text.slice(0, at.index) +
      front.slice(0, front.length - gap.length) +
      written +
      gap +
      text.slice(at.index + at[0].length);
  }
  return text;
}

/** The text of a block with another statement: number, skip mark, comment and line end stay. */
function rewritten(block: Block, statement: Statement, style: Style): string {
  const end = lineEndOf(block.raw);
  const body = block.raw.slice(0, block.raw.length - end.length);
  if (block.statement.kind === "cycle" && statement.kind === "cycle") {
    const patched = withValues(body, block.statement, statement, style);
    if (patched !== null) return patched + end;
  }
  const lines = statementLines(statement, style);
  const comment = block.comment !== undefined && statement.kind !== "comment" ? commentOf(body) : "";
  const head = headOf(body);
  const [before = "", ...more] = statementLines(block.statement, style);
  if (statement.kind === block.statement.kind && more.length === 0 && lines.length === 1) {
    const written = withChangedWords(body.slice(head.length, body.length - comment.length), before, lines[0] ?? "");
    // Only if it reads as the wanted statement: a word may stand for more than it shows.
    if (written !== null && saysTheSame(parse(written).blocks[0]?.statement, statement))
      return head + written + comment + end;
  }
  const gap = head !== "" && /\d$/.test(head) && lines[0] ? " " : "";
  return (
    head +
    gap +
    (lines[0] ?? "") +
    comment +
    lines
      .slice(1)
      .map((line) => style.newLine + line)
      .join("") +
    end
  );
}

/** The comment of a block's first line with the blanks before it. */
function commentOf(body: string): string {
  const [first = ""] = body.split(/\r\n|\n|\r/);
  let quoted = false;
  for (let i = 0; i < first.length; i += 1) {
    if (first[i] === '"') quoted = !quoted;
    else if (first[i] === ";" && (!quoted || !first.includes('"', i))) {
      const from = first.slice(0, i).trimEnd().length;
      return first.slice(from).replace(/(?<![ \t])[ \t]*~[ \t]*$/, "");
    }
  }
  return "";
}

/**
 * Replaces the statement of one block. Only its text changes, in the surrounding style; the same statement changes
 * nothing.
 */
export function withBlock(program: Program, index: number, statement: Statement): Program {
  const block = program.blocks[index];
  if (!block || same(block.statement, statement)) return program;
  const raw = rewritten(block, statement, styleAt(program, index));
  return { blocks: program.blocks.toSpliced(index, 1, ...parse(raw).blocks) };
}

/** Inserts a statement before the block at `index` (or at the end), numbered if its neighbours are. */
export function withInserted(program: Program, index: number, statement: Statement): Program {
  const style = styleAt(program, Math.min(index, program.blocks.length - 1));
  const numbered = program.blocks.some((b) => b.number !== null);
  const number = program.blocks[index]?.number ?? nextNumber(program.blocks.slice(0, index));
  const before = program.blocks[index - 1];
  const open = before !== undefined && lineEndOf(before.raw) === "";
  // Uses N numbers where neighbouring blocks do.
  const letter = [program.blocks[index], before].some((b) => b && /^[ \t]*(?:\/[ \t]*)?N\d/i.test(b.raw)) ? "N" : "";
  const text =
    (numbered && statement.kind !== "empty" ? `${letter}${number} ` : "") +
    statementLines(statement, style).join(style.newLine) +
    style.newLine;
  const blocks = open ? program.blocks.with(index - 1, { ...before, raw: before.raw + style.newLine }) : program.blocks;
  return renumbered({ blocks: blocks.toSpliced(index, 0, ...parse(text).blocks) }, index + 1);
}

/** Removes blocks and renumbers the following ones. */
export function withoutBlocks(program: Program, index: number, count = 1): Program {
  return renumbered({ blocks: program.blocks.toSpliced(index, count) }, index);
}

const nextNumber = (blocks: readonly Block[]) => (blocks.findLast((b) => b.number !== null)?.number ?? -1) + 1;

/** The block with another number, or its first one: written behind the skip mark, as `12 ` or `N12 `. */
function withNumber(b: Block, number: number, letter: string): Block {
  if (b.number === number) return b;
  const old = headOf(b.raw);
  const head =
    b.number === null
      ? old.replace(/\/[ \t]*$|(?<![ \t])[ \t]*$/, (mark) => `${mark.trimEnd()}${letter}${number} `)
      : old.replace(/\d+/, String(number));
  return {
    ...b,
    number,
    raw: head + b.raw.slice(old.length),
    ...(b.issues && { issues: b.issues.map((x) => shifted(x, head.length - old.length)) }),
  };
}

/** `N` where the numbers of a program are written with it. */
const letterOf = (blocks: readonly Block[]) =>
  blocks.some((b) => b.number !== null && /^[ \t]*(?:\/[ \t]*)?N\d/i.test(b.raw)) ? "N" : "";

const isBlank = ({ statement: { kind } }: Block) => kind === "empty";

/** The program numbered as the control does: from 0 in steps of 1, every block but blank lines. */
export function numberedFromZero({ blocks }: Program): Program {
  const letter = letterOf(blocks);
  let next = 0;
  return { blocks: blocks.map((b) => (isBlank(b) && b.number === null ? b : withNumber(b, next++, letter))) };
}

/**
 * Numbers the blocks without a number from `first` to `last`, if the program is numbered; those behind follow.
 */
export function withNumbers(program: Program, first: number, last: number): Program {
  if (program.blocks.every((b) => b.number === null)) return program;
  const blocks = [...program.blocks];
  const isMissing = (b: Block) => b.number === null && !isBlank(b);
  const start = blocks.findIndex((b, i) => i >= first && i <= last && isMissing(b));
  if (start < 0) return program;
  const letter = letterOf(blocks.slice(Math.max(0, start - 1), last + 2));
  let next = nextNumber(blocks.slice(0, start));
  for (let i = start; i <= last; i += 1) {
    const b = blocks[i];
    if (b && (b.number !== null || isMissing(b))) blocks[i] = withNumber(b, next++, letter);
  }
  return renumbered({ blocks }, last + 1);
}

/** Renumbers blocks from `index` up to the first correct number; only the digits change. */
export function renumbered(program: Program, index: number): Program {
  let next = nextNumber(program.blocks.slice(0, index));
  const blocks = [...program.blocks];
  for (let i = index; i < blocks.length; i += 1) {
    const b = blocks[i];
    if (!b || b.number === null) continue;
    if (b.number === next) break;
    blocks[i] = withNumber(b, next, "");
    next += 1;
  }
  return { blocks };
}

const shifted = <T extends BlockIssue>(x: T, by: number): T => ({
  ...x,
  offset: x.offset + by,
  ...(x.fix && { fix: { ...x.fix, offset: x.fix.offset + by } }),
});
