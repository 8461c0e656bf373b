import { EditorState, type Transaction } from "@codemirror/state";
import { afterEach, expect, test, vi } from "vitest";
import { whileTyping } from "../../base/typing.ts";
import { createTextView, type TextUpdate, type TextView } from "./text-view.ts";

const TEXT = "0 BEGIN PGM AWKWARD MM\n1 L Z+17.3 FMAX\n2 END PGM AWKWARD MM\n";

let shown: TextView | null = null;
afterEach(() => {
  shown?.destroy();
  shown = null;
  vi.useRealTimers();
});

function opened() {
  const told: TextUpdate[] = [],
    begin = EditorState.create({ doc: TEXT }),
    view = createTextView(begin, (change) => told.push(change));
  let state = begin;
  const put = (insert: string) => {
    const tr: Transaction = state.update({ changes: { from: 30, insert } });
    state = tr.state;
    view.edit(tr);
  };
  shown = view;
  return { view, told, put, now: () => state.doc.toString() };
}

test("a dialog's change while typing is reported at once, and is in the editor after the next frame", () => {
  const { view, told, put, now } = opened(),
    editor = view.get();
  whileTyping(() => put("1"));
  whileTyping(() => put("9"));
  expect(told.map(({ state }) => state.doc.length)).toEqual([TEXT.length + 1, TEXT.length + 2]);
  expect(editor.state.doc.toString()).toBe(TEXT);
  dispatchEvent(new MouseEvent("pointerdown"));
  expect(editor.state.doc.toString()).toBe(now());
  expect(told).toHaveLength(2);
});

test("getting the editor updates it to the newest text", () => {
  const { view, put, now } = opened();
  whileTyping(() => put("4"));
  expect(view.get().state.doc.toString()).toBe(now());
  put("2");
  expect(view.get().state.doc.toString()).toBe(now());
});

test("an editor that is behind cannot damage the text by its own changes", () => {
  const { view, told, put, now } = opened(),
    editor = view.get();
  whileTyping(() => put("7"));
  editor.dispatch({ selection: { anchor: 3 } });
  expect(editor.state.doc.toString()).toBe(now());
  editor.dispatch({ changes: { from: 0, to: 1, insert: "5" } });
  expect(told.at(-1)?.state.doc.toString()).toBe(`5${now().slice(1)}`);
});

test("another text replaces one that the editor does not have yet", () => {
  const { view, put } = opened(),
    other = EditorState.create({ doc: "7 M30\n" });
  whileTyping(() => put("3"));
  view.put(other);
  expect(view.get().state.doc.toString()).toBe("7 M30\n");
  dispatchEvent(new MouseEvent("pointerdown"));
  expect(view.get().state.doc.toString()).toBe("7 M30\n");
});
