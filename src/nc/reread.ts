import { detachedText } from "./detached-text.ts";
import { parse } from "./parse.ts";
import type { Block, Program } from "./program.ts";

/** An incrementally read program: its blocks, and where each starts in the text. */
export interface Reading {
  readonly program: Program;
  /** Offset of each block, and of the end of the text: one more than there are blocks. */
  readonly starts: readonly number[];
}

/** A text change: characters `from` to `to` of the old text became `length` characters. */
export interface Change {
  readonly from: number;
  readonly to: number;
  readonly length: number;
}

/** The splitter looks at most this many written blocks ahead of a boundary. */
const LOOKS_AHEAD = 4;
/** Blocks after a change that are reread at first; doubled until old and new boundaries meet. */
const REREAD_BEHIND = 16;

/** Adds the starts of the blocks behind those that have one, the first of them at `offset`, and the end. */
function addStarts(starts: number[], blocks: readonly Block[], offset: number): void {
  let at = offset;
  for (let i = starts.length; i < blocks.length; i += 1) {
    starts.push(at);
    at += blocks[i]?.raw.length ?? 0;
  }
  starts.push(at);
}

export function readingOf(text: string): Reading {
  const program = parse(text);
  const starts: number[] = [];
  addStarts(starts, program.blocks, 0);
  return { program, starts };
}

/** Index of the block at an offset; the last block at the end of the text, -1 in an empty text. */
export function blockAt({ starts }: Pick<Reading, "starts">, offset: number): number {
  let [low, high] = [0, starts.length - 2];
  if (high < 0) return -1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((starts[middle] ?? 0) <= offset) low = middle;
    else high = middle - 1;
  }
  return low;
}

const written = (b: Block | undefined) => b !== undefined && b.statement.kind !== "empty";

/** Where rereading must start so that everything that looks ahead to `index` is read too. */
function beginning(blocks: readonly Block[], index: number): number {
  let at = Math.max(0, index);
  for (let seen = 0; at > 0 && seen < LOOKS_AHEAD;) {
    at -= 1;
    if (written(blocks[at])) seen += 1;
  }
  return at;
}

/**
 * The reading after a change, equal to reading the whole text again. Only blocks near the change are read; all others
 * stay the same objects. `slice`: returns a stretch of the new text.
 */
export function reread(old: Reading, change: Change, slice: (from: number, to: number) => string): Reading {
  const { blocks } = old.program;
  const by = change.length - (change.to - change.from);
  const whole = (old.starts.at(-1) ?? 0) + by;
  const first = beginning(blocks, blockAt(old, change.from));
  const from = blocks.length === 0 ? 0 : (old.starts[first] ?? 0);
  const touched = blockAt(old, change.to);
  for (let behind = REREAD_BEHIND; ; behind *= 2) {
    const last = touched < 0 ? blocks.length : Math.min(blocks.length, touched + behind);
    const to = last >= blocks.length ? whole : (old.starts[last] ?? 0) + by;
    const fresh = parse(slice(from, to)).blocks;
    if (to >= whole) return spliced(old, first, blocks.length, fresh);
    const met = sharedBoundary(old, fresh, from, { ...change, by, last });
    if (met) return spliced(old, first, met.old, fresh.slice(0, met.fresh));
  }
}

/** The first boundary behind the change that old and new blocks share, far enough from where the slice was cut off. */
function sharedBoundary(
  old: Reading,
  fresh: readonly Block[],
  from: number,
  { to, by, last }: { readonly to: number; readonly by: number; readonly last: number },
): { readonly old: number; readonly fresh: number } | null {
  let safe = fresh.length;
  for (let seen = 0; safe > 0 && seen < LOOKS_AHEAD;) {
    safe -= 1;
    if (written(fresh[safe])) seen += 1;
  }
  let o = blockAt(old, to) + 1;
  let offset = from;
  for (let f = 0; f < safe; f += 1) {
    while (o < last && (old.starts[o] ?? 0) + by < offset) o += 1;
    if (o < last && (old.starts[o] ?? 0) + by === offset && f > 0) return { old: o, fresh: f };
    offset += fresh[f]?.raw.length ?? 0;
  }
  return null;
}

/** The change between two texts: everything between their common beginning and common end, in whole blocks. */
function changeBetween({ program: { blocks }, starts }: Reading, text: string): Change {
  const whole = starts.at(-1) ?? 0,
    by = text.length - whole,
    most = Math.min(whole, text.length);
  let [first, last] = [0, blocks.length];
  while (first < blocks.length && text.startsWith(blocks[first]?.raw ?? "", starts[first])) first += 1;
  const from = Math.min(starts[first] ?? 0, most);
  while (
    last > first &&
    (starts[last - 1] ?? 0) + by >= from &&
    text.startsWith(blocks[last - 1]?.raw ?? "", (starts[last - 1] ?? 0) + by)
  )
    last -= 1;
  const to = starts[last] ?? 0;
  return { from, to, length: to + by - from };
}

/** Reads successive states of a text: only the changed blocks and those near them. */
export function incrementalParser(): (text: string) => Program {
  let last: Reading | null = null;
  return (text) => {
    last = last
      ? reread(last, changeBetween(last, text), (from, to) => detachedText(text.slice(from, to)))
      : readingOf(text);
    return last.program;
  };
}

function spliced(old: Reading, first: number, end: number, fresh: readonly Block[]): Reading {
  const blocks = old.program.blocks.slice(0, first).concat(fresh, old.program.blocks.slice(end));
  const starts = old.starts.slice(0, first);
  addStarts(starts, blocks, old.starts[first] ?? 0);
  return { program: { blocks }, starts };
}
