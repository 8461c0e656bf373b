import {
  codeFolding,
  foldAll,
  foldEffect,
  foldGutter,
  foldService,
  foldedRanges,
  unfoldAll,
  unfoldEffect,
} from "@codemirror/language";
import type { EditorState, Extension, StateEffect } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import { blockAt } from "../../../nc/reread.ts";
import { blockRange, cursorBlock, readingField } from "./reading-field.ts";

/** What folding hides of a cycle: everything behind its first line. Null for any other block. */
function parametersAt(state: EditorState, index: number): { readonly from: number; readonly to: number } | null {
  const block = state.field(readingField).program.blocks[index];
  const range = block?.statement.kind === "cycle" && block.lines > 1 ? blockRange(state, index) : null;
  if (!range) return null;
  const { to } = state.doc.lineAt(range.from);
  return to < range.to ? { from: to, to: range.to } : null;
}

/** Name of the summary of a folded list; the phrases of the editor translate it. */
export const FOLDED_PHRASE = "$ parameters";
/** Values that the summary shows. */
const SHOWN_VALUES = 3;
const VALUE = /Q\d+\s*=\s*[^\s;~]+/gi;

/** How many values a folded list has, and the first of them. */
function summaryOf(state: EditorState, { from, to }: { readonly from: number; readonly to: number }): string {
  const values = state.sliceDoc(from, to).match(VALUE) ?? [];
  return `${state.phrase(FOLDED_PHRASE, values.length)}  ${values.slice(0, SHOWN_VALUES).join(" ")} …`;
}

/** Parameter lists of cycles fold into the line of the cycle. */
export const cycleFolding: Extension = [
  foldService.of((state, from) => {
    const reading = state.field(readingField);
    const index = blockAt(reading, from);
    return reading.starts[index] === from ? parametersAt(state, index) : null;
  }),
  codeFolding({
    preparePlaceholder: summaryOf,
    placeholderDOM(_, onclick, summary: string) {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "nc-folded";
      button.tabIndex = -1;
      button.textContent = summary;
      button.onclick = onclick;
      return button;
    },
  }),
  foldGutter({ openText: "▾", closedText: "▸" }),
];

const isFolded = (state: EditorState, { from, to }: { readonly from: number; readonly to: number }): boolean => {
  let found = false;
  foldedRanges(state).between(from, to, (a, b) => {
    found ||= a === from && b === to;
  });
  return found;
};

/** Folds or unfolds the list of the cycle at the cursor. */
export function toggleFold(view: EditorView): void {
  const range = parametersAt(view.state, cursorBlock(view.state));
  if (!range) return;
  const isOpen = !isFolded(view.state, range);
  view.dispatch({
    effects: (isOpen ? foldEffect : unfoldEffect).of(range),
    // A cursor inside the list would unfold it.
    ...(isOpen && view.state.selection.main.head > range.from && { selection: { anchor: range.from } }),
  });
}

/** Folds all lists, or unfolds them if none is open. */
export function toggleAllFolds(view: EditorView): void {
  const { blocks } = view.state.field(readingField).program;
  const isOpen = blocks.some((_, index) => {
    const range = parametersAt(view.state, index);
    return range !== null && !isFolded(view.state, range);
  });
  if (!isOpen) return void unfoldAll(view);
  const range = parametersAt(view.state, cursorBlock(view.state));
  if (range && view.state.selection.main.head > range.from) view.dispatch({ selection: { anchor: range.from } });
  foldAll(view);
}

/** Unfolds what hides a place. */
export function unfolding(state: EditorState, from: number, to: number): readonly StateEffect<unknown>[] {
  const effects: StateEffect<unknown>[] = [];
  foldedRanges(state).between(from, to, (a, b) => void effects.push(unfoldEffect.of({ from: a, to: b })));
  return effects;
}
