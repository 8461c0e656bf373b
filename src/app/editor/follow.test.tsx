import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { usePlace } from "../place.ts";
import { forget } from "../steps.ts";
import { begin, useEditor } from "../store.ts";
import { followProgram } from "./follow.ts";
import { closeSession, openBlock, openSession, sessionText, sessionView } from "./session.ts";

const BEFORE = "0 BEGIN PGM A MM\n1 TOOL CALL 1\n", AFTER = "\n2 M30\n3 END PGM A MM\n";
const WRITTEN = "CYCL DEF 811 SHOULDER, LONGITDNL. ~\nQ215=+0 ;MACHINING OPERATION ~\nQ460=+2.3 ;SAFETY CLEARANCE ~\nQ493=+41.7";
let stop = () => undefined as void;

beforeEach(() => {
  vi.useFakeTimers();
  // What is placed nowhere is asked for its place when the text scrolls.
  Range.prototype.getClientRects ??= () => [] as unknown as DOMRectList;
  begin({ name: "A.H", text: BEFORE + AFTER, encoding: "utf-8" }, "w");
  const { program } = useEditor.getState();
  const view = program && openSession(program, "w");
  if (!view) throw new Error("no program is open");
  document.body.append(view.dom);
  view.focus();
  stop = followProgram();
});
afterEach(() => {
  stop();
  closeSession();
  forget();
  vi.useRealTimers();
  usePlace.setState({ prompt: null });
});

/** A key at the cursor, and the rest after which panels follow. */
function key(letter: string): void {
  const view = sessionView();
  const { head = 0 } = view?.state.selection.main ?? {};
  view?.dispatch({ changes: { from: head, insert: letter }, selection: { anchor: head + letter.length }, userEvent: "input.type" });
  vi.advanceTimersByTime(200);
}

test("a cycle definition is written by hand as it is typed, though its prompts open beside it", () => {
  const view = sessionView();
  view?.dispatch({ selection: { anchor: BEFORE.length } });
  for (const letter of WRITTEN) key(letter);
  expect(sessionText()).toBe(BEFORE + WRITTEN + AFTER);
  expect(usePlace.getState().prompt).toBe("Q493");
});

test("a prompt that is opened in the dialog takes the text along", () => {
  const view = sessionView();
  view?.dispatch({ selection: { anchor: BEFORE.length } });
  for (const letter of WRITTEN) key(letter);
  openBlock(2);
  usePlace.setState({ prompt: "Q460", before: "", field: null });
  const line = view?.state.doc.lineAt(view.state.selection.main.head).text;
  expect(line).toMatch(/^Q460/);
});
