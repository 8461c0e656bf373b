import { EditorState } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { expect, it } from "vitest";
import { LONGEST_LINE } from "../../../nc/longest-line.ts";
import { longLines } from "./long-lines.ts";

const long = (letter: string) => `${letter.repeat(LONGEST_LINE)}!`;
const hidden = (state: EditorState) => {
  const found: string[] = [];
  for (const set of state.facet(EditorView.decorations))
    if (typeof set !== "function")
      set.between(0, state.doc.length, (from, to) => void found.push(state.sliceDoc(from, to)));
  return found;
};
const stateOf = (doc: string) => EditorState.create({ doc, extensions: [longLines] });
const restOf = (letter: string) => `${letter.repeat(LONGEST_LINE - 200)}!`;

it("hides the rest of each line that is too long, and of no other", () => {
  const text = ["short", long("a"), "x".repeat(LONGEST_LINE), "", long("b")].join("\n");
  expect(hidden(stateOf(text))).toEqual([restOf("a"), restOf("b")]);
});

it("hides after a change what a fresh text hides", () => {
  const before = stateOf(["short", long("a"), "short", long("b"), "end"].join("\n"));
  const { length } = before.doc;
  for (const changes of [
    { from: 2, insert: `x\n${long("c")}` },
    { from: 6 + 300, insert: "\n" },
    { from: 6 + 100, to: 6 + 102 },
    { from: 5, to: 6 },
    { from: length, insert: `\n${long("d")}` },
    { from: 0, to: length },
  ]) {
    const after = before.update({ changes }).state;
    expect(hidden(after)).toEqual(hidden(stateOf(after.doc.toString())));
  }
});
