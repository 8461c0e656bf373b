import { klartext } from "./blocks/klartext.ts";
import { detachedText } from "./detached-text.ts";
import type { Block, Program } from "./program.ts";
import type { BlockIssue } from "./issue.ts";
import { LONGEST_LINE } from "./longest-line.ts";
import type { BlockLine } from "./read-cycle.ts";
import { readLine } from "./read-line.ts";
import { splitBlocks, splitLines, type Lines, type Slice } from "./split.ts";
import type { Statement } from "./statement.ts";

/** Where the comment of a line starts: the first `;` outside quotes, or -1. */
function commentAt(text: string): number {
  const first = text.indexOf(";");
  if (first < 0 || !text.includes('"')) return first;
  let quoted = false;
  for (let i = 0; i < text.length; i += 1) {
    const c = text.charCodeAt(i);
    if (c === 34) quoted = !quoted;
    else if (c === 59 && !quoted) return i;
  }
  // A quote that is never closed is no quote.
  return quoted ? first : -1;
}

const unmarked = (text: string, marked: boolean) => {
  const trimmed = text.trimEnd();
  return marked && trimmed.endsWith("~") ? trimmed.slice(0, -1) : text;
};

function blockLine(text: string, from: number, to: number, offset: number): BlockLine {
  const line = text.slice(from, to);
  const marked = line.trimEnd().endsWith("~");
  const comment = commentAt(line);
  if (comment < 0) return { text: unmarked(line, marked), offset, comment: null };
  return { text: line.slice(0, comment), offset, comment: unmarked(line.slice(comment + 1), marked).trimEnd() };
}

const NONE: readonly BlockIssue[] = [];

/** A block without the fields that most blocks lack: a long program has many. */
function blockOf(
  raw: string,
  { first, last, number, skip }: Slice,
  statement: Statement,
  comment: string | null = null,
  issues: readonly BlockIssue[] = NONE,
): Block {
  const block = { raw, lines: last - first + 1, number, statement };
  if (!skip && comment === null && issues.length === 0) return block;
  return {
    ...block,
    ...(skip && { skip }),
    ...(comment !== null && { comment }),
    ...(issues.length > 0 && { issues }),
  };
}

/**
 * Cached blocks, by text and by whether an announced line is missing: each key press rereads a program with one changed
 * line. They are read from a detached copy of their text, so that they keep no other text in memory.
 */
const known = [new Map<string, Block>(), new Map<string, Block>()] as const;
const MOST_KNOWN = 500;

/** A block with a line that is longer than lines are is kept as text, with an issue at each such line; null for others. */
function tooLong({ starts, ends }: Lines, s: Slice, raw: string): Block | null {
  const issues: BlockIssue[] = [];
  for (let i = s.first; i <= s.last; i += 1) {
    const [from, to] = [starts[i] ?? 0, ends[i] ?? 0];
    if (to - from > LONGEST_LINE)
      issues.push({
        code: "lineTooLong",
        severity: "error",
        offset: from - s.from,
        length: LONGEST_LINE,
        data: { most: LONGEST_LINE },
      });
  }
  if (issues.length === 0) return null;
  const statement = { kind: "unknown", text: raw.slice(s.body - s.from).trim() } as const;
  return blockOf(raw, s, statement, null, issues);
}

function readBlock(text: string, lines: Lines, s: Slice): Block {
  const raw = text.slice(s.from, s.to);
  const kept = raw.length > LONGEST_LINE ? tooLong(lines, s, raw) : null;
  if (kept) return kept;
  const line = s.first === s.last && !s.open ? readLine(text, s.body) : null;
  if (line) return blockOf(raw, s, line);
  const before = known[s.open ? 1 : 0];
  let read = before.get(raw);
  if (!read) {
    const own = detachedText(raw);
    read = readWords(own, splitLines(own), {
      ...s,
      from: 0,
      to: own.length,
      first: 0,
      last: s.last - s.first,
      body: s.body - s.from,
    });
    if (before.size >= MOST_KNOWN) before.clear();
    before.set(own, read);
  }
  return read;
}

/** The end of the first list line without its ` ~`, as an offset in the block; null where none is missing. */
function tildeMissing(text: string, { starts, ends }: Lines, { first, last }: Slice): number | null {
  let open: number | null = null;
  for (let i = first; i <= last; i += 1) {
    const line = text.slice(starts[i], ends[i]).trimEnd();
    if (line === "") continue;
    if (open !== null) return open;
    if (!line.endsWith("~")) open = (starts[i] ?? 0) + line.length;
  }
  return null;
}

function readWords(text: string, all: Lines, s: Slice): Block {
  const { starts, ends } = all;
  const lines: BlockLine[] = [];
  for (let i = s.first; i <= s.last; i += 1) {
    const from = i === s.first ? s.body : (starts[i] ?? 0);
    lines.push(blockLine(text, from, ends[i] ?? from, from - s.from));
  }
  const read = klartext.read(lines);
  const untied = s.first < s.last ? tildeMissing(text, all, s) : null;
  const issues: readonly BlockIssue[] = [
    ...read.issues,
    ...(untied === null
      ? []
      : [{ code: "listWithoutTilde", severity: "warning", offset: untied, length: 0, data: { places: 1 } } as const]),
    ...(s.open
      ? [
          {
            code: "continuationOpen",
            severity: "warning",
            offset: (ends[s.last] ?? s.from) - s.from,
            length: 0,
            data: {},
          } as const,
        ]
      : []),
  ];
  const comment =
    read.statement.kind === "comment" || read.statement.kind === "cycle" ? null : (lines[0]?.comment ?? null);
  return blockOf(text, s, read.statement, comment, issues);
}

/** Reads any text. Never throws; text that is not understood is kept and reported. `print` returns the same text. */
export function parse(text: string): Program {
  const lines = splitLines(text);
  return { blocks: Array.from(splitBlocks(text, lines), (s) => readBlock(text, lines, s)) };
}
