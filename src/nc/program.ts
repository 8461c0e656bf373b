import { perObject } from "./per-object.ts";
import type { BlockIssue, NcIssue } from "./issue.ts";
import type { Statement } from "./statement.ts";

/** One block with its exact text. Blocks store no positions, so replacing one leaves all others unchanged. */
export interface Block {
  /** Exactly as read: all lines with their line ends. */
  readonly raw: string;
  /** Number of text lines, at least 1. */
  readonly lines: number;
  /** As printed, null without one. */
  readonly number: number | null;
  /** Marked with `/`: optional on the control; absent, as comment and issues are, where there is none. */
  readonly skip?: true;
  readonly statement: Statement;
  /** Comment behind the statement, without `;`. */
  readonly comment?: string;
  readonly issues?: readonly BlockIssue[];
}

/** A program, as text and as statements. */
export interface Program {
  readonly blocks: readonly Block[];
}

/** The text, byte for byte as it was read, edited blocks aside. */
export const print = (program: Program): string => program.blocks.map((b) => b.raw).join("");

/** Line (from 1) on which each block starts. */
export const startLines = perObject((program: Program): readonly number[] => {
  let line = 1;
  return program.blocks.map((b) => {
    const start = line;
    line += b.lines;
    return start;
  });
});

/**
 * Number of each block: as printed, or counted on from the previous one. Comments and blank lines count only when
 * numbered.
 */
export const blockNumbers = perObject((program: Program): readonly number[] => {
  let next = 0;
  return program.blocks.map((b) => {
    const silent = b.statement.kind === "empty" || b.statement.kind === "comment";
    const own = b.number ?? (silent ? Math.max(0, next - 1) : next);
    if (b.number !== null || !silent) next = own + 1;
    return own;
  });
});

/** Lines and columns (both from 0) of ascending offsets inside a block, in one pass. */
function places(raw: string, offsets: readonly number[]): { line: number; column: number }[] {
  let [line, start, i] = [0, 0, 0];
  return offsets.map((offset) => {
    for (; i < offset; i += 1) {
      const c = raw.charCodeAt(i);
      if (c === 10 || (c === 13 && raw.charCodeAt(i + 1) !== 10)) {
        line += 1;
        start = i + 1;
      }
    }
    return { line, column: offset - start };
  });
}

/** A block of DIN/ISO: the frame (`%NAME G71`), or a G function that Klartext does not know. */
const ISO = /^\s*(?:%\S+\s+G7[01](?!\d)|(?:N\d+\s*)?G\d{1,3}(?!\d))/i;
const inIso = ({ raw, statement }: Block): boolean => statement.kind === "unknown" && ISO.test(raw);

/** A list over several lines without ` ~` between them. */
export const hasListWithoutTilde = ({ issues = [] }: Block): boolean =>
  issues.some((i) => i.code === "listWithoutTilde");

const NO_ISSUES: readonly BlockIssue[] = [];

/** All findings of the reader in text order, including those between blocks. */
export const issuesOf = (program: Program): NcIssue[] => [...eachIssue(program)];

/** The same one by one: a long program may have too many for memory. */
export function* eachIssue({ blocks }: Program): Generator<NcIssue> {
  const said = ({ statement: { kind } }: Block) => kind !== "empty" && kind !== "comment";
  const missing = (which: "BEGIN PGM" | "END PGM", place: { line: number; offset: number }): NcIssue => ({
    code: "frameMissing",
    severity: "warning",
    column: 1,
    length: 0,
    ...place,
    data: { which },
  });
  const isIso = !blocks.some((b) => b.statement.kind === "begin") && blocks.some(inIso);
  if (isIso) yield { code: "isoProgram", severity: "error", line: 1, column: 1, offset: 0, length: 0, data: {} };
  else if (blocks.find(said)?.statement.kind !== "begin") yield missing("BEGIN PGM", { line: 1, offset: 0 });
  const numbered = blocks.some((b) => b.number !== null);
  let [offset, line] = [0, 1];
  let expected: number | null = null;
  let step = 1;
  // One fix writes ` ~` into every list, so they are one finding, at the first.
  let untied = blocks.filter(hasListWithoutTilde).length;
  for (const b of blocks) {
    const at = { line, column: 1, offset, length: 0, severity: "info" as const };
    const { kind } = b.statement;
    if (b.number !== null) {
      const by: number = expected === null ? 1 : b.number - expected + 1;
      // Numbering in tens is reported once, where it begins.
      if (expected !== null && by !== 1 && !(by > 1 && by === step))
        yield { code: "blockNumber", ...at, data: { found: b.number, expected } };
      step = by;
      expected = b.number + 1;
    } else if (numbered && kind !== "empty" && kind !== "comment" && kind !== "unknown") {
      yield { code: "blockNumberMissing", ...at, data: { expected: expected ?? 0 } };
    }
    const { issues = NO_ISSUES } = b;
    const rising = issues.length > 1 ? issues.toSorted((a, c) => a.offset - c.offset) : issues;
    const at0 =
      rising.length > 0
        ? places(
            b.raw,
            rising.map((i) => i.offset),
          )
        : [];
    for (const [k, i] of rising.entries()) {
      if (i.code === "listWithoutTilde" && untied === 0) continue;
      const fix = i.fix && { ...i.fix, offset: i.fix.offset + offset };
      const place = { offset: i.offset + offset, line: line + (at0[k]?.line ?? 0), column: (at0[k]?.column ?? 0) + 1 };
      if (i.code !== "listWithoutTilde") yield { ...i, ...place, ...(fix && { fix }) } as NcIssue;
      else {
        yield { ...i, ...place, data: { places: untied } };
        untied = 0;
      }
    }
    offset += b.raw.length;
    line += b.lines;
  }
  if (!isIso && blocks.findLast(said)?.statement.kind !== "end")
    yield missing("END PGM", { line: Math.max(1, line - 1), offset });
}
