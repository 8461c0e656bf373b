import { StateEffect, StateField, type EditorState, type Text, type Transaction } from "@codemirror/state";
import { blockAt, readingOf, reread, type Change, type Reading } from "../../../nc/reread.ts";
import { NUMBER_PARAMETER } from "../../../nc/value.ts";

/** All changes of a transaction as one: from the first to the last changed character. */
function changeOf(tr: Transaction): Change | null {
  let [from, to, fromNew, toNew] = [Infinity, -1, Infinity, -1];
  tr.changes.iterChangedRanges((a, b, c, d) => {
    from = Math.min(from, a);
    to = Math.max(to, b);
    fromNew = Math.min(fromNew, c);
    toNew = Math.max(toNew, d);
  });
  return to < 0 ? null : { from, to, length: toNew - fromNew };
}

/** Characters of a long text that are read before it is shown, and per piece after that. */
const AT_FIRST = 100_000;
const AT_A_TIME = 400_000;

/** End of a piece of about that many characters, at a line end. */
const pieceEnd = (doc: Text, offset: number): number =>
  Math.min(doc.length, doc.lineAt(Math.min(doc.length, offset)).to + 1);

const endOf = (reading: Reading): number => reading.starts.at(-1) ?? 0;

/** Reads the next piece of a text. */
const readOn = StateEffect.define<null>();

/** The part of a change inside the text read so far; null if the change is behind it. */
function seen({ from, to, length }: Change, end: number, whole: boolean): Change | null {
  if (whole || to < end) return { from, to, length };
  return from >= end ? null : { from, to: end, length: 0 };
}

/**
 * The blocks of the text, re-read around each change so that they are current at every keystroke. A long text starts
 * with its first blocks; `readFurther` reads the others.
 */
export const readingField = StateField.define<Reading>({
  create: ({ doc }) => readingOf(doc.sliceString(0, pieceEnd(doc, AT_FIRST))),
  update(reading, tr) {
    const slice = (from: number, to: number) => tr.newDoc.sliceString(from, to);
    const change = tr.docChanged ? changeOf(tr) : null;
    const part = change && seen(change, endOf(reading), endOf(reading) === tr.startState.doc.length);
    const now = part ? reread(reading, part, slice) : reading;
    if (!tr.effects.some((effect) => effect.is(readOn))) return now;
    const end = endOf(now);
    return reread(now, { from: end, to: end, length: pieceEnd(tr.newDoc, end + AT_A_TIME) - end }, slice);
  },
});

/** True when every block of the text has been read. */
export const isRead = (state: EditorState): boolean => endOf(state.field(readingField)) === state.doc.length;

/** Transaction that reads the next piece of a long text. */
export const readFurther = { effects: readOn.of(null) } as const;

/** Index of the block at the cursor; -1 in an empty text. */
export const cursorBlock = (state: EditorState): number =>
  blockAt(state.field(readingField), state.selection.main.head);

/** Where a block begins and where its last line ends, without its line end. */
export function blockRange(state: EditorState, index: number): { readonly from: number; readonly to: number } | null {
  const { program, starts } = state.field(readingField);
  const block = program.blocks[index];
  const from = starts[index];
  if (!block || from === undefined) return null;
  return { from, to: from + block.raw.replace(/(?<![\r\n])[\r\n]+$/, "").length };
}

const PARAMETER_LINE = new RegExp(String.raw`^\s*(${NUMBER_PARAMETER})\s*[=+\-\d]`, "i");

/** The Q parameter on the line of an offset, inside a cycle definition; null on any other line. */
export function parameterAt(state: EditorState, offset: number): string | null {
  return PARAMETER_LINE.exec(state.doc.lineAt(offset).text)?.[1]?.toUpperCase() ?? null;
}

/** Offset of a Q parameter's line in a block; the start of the block if it has none. */
export function parameterOffset(
  state: EditorState,
  block: { readonly from: number; readonly to: number },
  parameter: string,
): number {
  const line = new RegExp(String.raw`(?:^|[\r\n])[^\S\r\n]*(${parameter})\s*[=+\-\d]`, "i").exec(
    state.sliceDoc(block.from, block.to),
  );
  return line ? block.from + line.index + line[0].search(/Q/i) : block.from;
}
