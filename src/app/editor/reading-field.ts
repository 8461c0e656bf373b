import { StateField, type EditorState, type Transaction } from "@codemirror/state";
import { blockAt, readingOf, reread, type Change, type Reading } from "../../nc/reread.ts";
import { NUMBER_PARAMETER } from "../../nc/value.ts";

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

/** The blocks of the text, read again near each change, so that they are right at every keystroke. */
export const readingField = StateField.define<Reading>({
  create: (state) => readingOf(state.doc.toString()),
  update(reading, tr) {
    if (!tr.docChanged) return reading;
    const change = changeOf(tr);
    return change ? reread(reading, change, (from, to) => tr.newDoc.sliceString(from, to)) : reading;
  },
});

/** Index of the block in which the cursor stands; -1 in an empty text. */
export const cursorBlock = (state: EditorState): number => blockAt(state.field(readingField), state.selection.main.head);

/** Where a block begins and where its last line ends, without its line end. */
export function blockRange(state: EditorState, index: number): { readonly from: number; readonly to: number } | null {
  const { program, starts } = state.field(readingField);
  const block = program.blocks[index];
  const from = starts[index];
  if (!block || from === undefined) return null;
  return { from, to: from + block.raw.replace(/[\r\n]+$/, "").length };
}

const PARAMETER_LINE = new RegExp(String.raw`^\s*(${NUMBER_PARAMETER})\s*[=+\-\d]`, "i");

/** The Q parameter on the line of an offset, inside a cycle definition; null on any other line. */
export function parameterAt(state: EditorState, offset: number): string | null {
  return PARAMETER_LINE.exec(state.doc.lineAt(offset).text)?.[1]?.toUpperCase() ?? null;
}
