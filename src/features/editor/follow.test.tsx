import { EditorView } from "@codemirror/view";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { openPrompt, usePlace } from "../../app/place/place.ts";
import { undoStep } from "../../app/document/history.ts";
import { forgetAllSteps } from "../../app/document/steps.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { trackOf } from "../../view/playback.ts";
import { simulate } from "../../sim/simulate.ts";
import { forgetOutcome, takeOutcome, takePlanned, type Planned } from "../../app/calculation/outcome.ts";
import { playback } from "../../app/calculation/playback.ts";
import { filesOf } from "../../app/document/work.ts";
import { followProgram } from "./follow.ts";
import { closeSession, openBlock, openSession, sessionText, sessionView } from "../../app/fields/blocks/session.ts";

const BEFORE = "0 BEGIN PGM A MM\n1 TOOL CALL 1\n",
  AFTER = "\n2 M30\n3 END PGM A MM\n";
const WRITTEN =
  "CYCL DEF 811 SHOULDER, LONGITDNL. ~\nQ215=+0 ;MACHINING OPERATION ~\nQ460=+2.3 ;SAFETY CLEARANCE ~\nQ493=+41.7";
let stop = () => undefined as void;

beforeEach(() => {
  vi.useFakeTimers();
  // jsdom has no layout, but scrolling the text needs the rectangles of a range.
  Range.prototype.getClientRects ??= () => [] as unknown as DOMRectList;
  openFirstWork({ name: "A.H", text: BEFORE + AFTER, encoding: "utf-8" }, "w");
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
  forgetAllSteps();
  vi.useRealTimers();
  openPrompt(null, "");
});

/** A key at the cursor, and the pause after which panels update. */
function key(letter: string): void {
  const view = sessionView();
  const { head = 0 } = view?.state.selection.main ?? {};
  view?.dispatch({
    changes: { from: head, insert: letter },
    selection: { anchor: head + letter.length },
    userEvent: "input.type",
  });
  vi.advanceTimersByTime(200);
}

test("a cycle definition is typed undisturbed while its prompts open next to it, and has its number", () => {
  const view = sessionView();
  view?.dispatch({ selection: { anchor: BEFORE.length } });
  for (const letter of WRITTEN) key(letter);
  expect(sessionText()).toBe(`${BEFORE}2 ${WRITTEN}\n3 M30\n4 END PGM A MM\n`);
  expect(usePlace.getState().prompt).toBe("Q493");
});

/** What is typed after the first tool call, and the text with it. */
test.each([
  ["L X+1", "2 L X+1\n3 M30\n4 END PGM A MM\n"],
  ["; note", "2 ; note\n3 M30\n4 END PGM A MM\n"],
  ["9 L X+1", "9 L X+1\n2 M30\n3 END PGM A MM\n"],
  ["  ", "  \n2 M30\n3 END PGM A MM\n"],
])("typing %j numbers the block and those behind it, in one step of undo", (typed, after) => {
  const view = sessionView();
  view?.dispatch({ selection: { anchor: BEFORE.length } });
  for (const letter of typed) key(letter);
  expect(sessionText()).toBe(BEFORE + after);
  undoStep();
  expect(sessionText()).toBe(BEFORE + AFTER);
});

test("a parameter typed behind a cycle may join its list, and is numbered when its line is left", () => {
  const cycle = "2 CYCL DEF 811 A ~\nQ460=+2\n";
  const view = sessionView();
  view?.dispatch({ changes: { from: BEFORE.length, insert: cycle }, userEvent: "input.dialog" });
  view?.dispatch({ selection: { anchor: BEFORE.length + cycle.length } });
  for (const letter of "Q5") key(letter);
  expect(sessionText()).toContain("\nQ5\n");
  key("\n");
  expect(sessionText()).toContain("\n3 Q5\n");
});

test("a block that was not typed keeps its missing number", () => {
  const view = sessionView();
  view?.dispatch({ changes: { from: BEFORE.length, insert: "M8\n" }, userEvent: "input.dialog" });
  view?.dispatch({ selection: { anchor: 2 } });
  key("x");
  expect(sessionText()).toContain("\nM8\n");
});

test("a prompt opened in the dialog scrolls the text", () => {
  const view = sessionView();
  view?.dispatch({ selection: { anchor: BEFORE.length } });
  for (const letter of WRITTEN) key(letter);
  openBlock(2);
  openPrompt("Q460", "");
  const line = view?.state.doc.lineAt(view.state.selection.main.head).text;
  expect(line).toMatch(/^Q460/);
});

const TURNED = [
  "BEGIN PGM A MM",
  "BLK FORM CYLINDER Z D60 L80 DIST+0",
  "FUNCTION MODE TURN",
  "TOOL CALL 1",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:150",
  "M136",
  "L X+80 Z+10 R0 FMAX M303",
  "; turned by hand",
  "L X+58.3 FMAX",
  "L Z-21.7 F0.2",
  "L X+80 FMAX",
  "M30",
  "END PGM A MM",
];

/** Replaces the empty program by the program of blocks. */
function turned() {
  const view = sessionView(),
    text = TURNED.join("\n");
  view?.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
  vi.advanceTimersByTime(2000);
  const { program } = useEditor.getState();
  if (!view || !program || program.text !== text) throw new Error("the text was not handed over");
  const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  const planned: Planned = { version: 1, text, files: filesOf(program), run: made, simulation: null };
  return { view, made, planned };
}

/** Runs that program, and records each mark and each scroll target, as blocks. */
function played() {
  const { view, made, planned } = turned();
  forgetOutcome();
  takePlanned(planned);
  playback.dispatch({ do: "load", track: trackOf(made.steps) });
  const scrolled = vi.spyOn(EditorView, "scrollIntoView");
  return {
    view,
    steps: made.steps.length,
    /** The marked block, and the scroll target since the last query. */
    now: () => {
      const line = view.dom.querySelector(".nc-running")?.textContent ?? null;
      const places = scrolled.mock.calls.map(
        ([at]) => view.state.doc.lineAt(typeof at === "number" ? at : at.from).text,
      );
      scrolled.mockClear();
      return [line, ...places];
    },
  };
}

test("the text scrolls to the running block on seek, step and play, not on a new run or on its own selection", () => {
  const { view, steps, now } = played();
  view.dispatch({ selection: { anchor: 3 } });
  const focus = document.activeElement;
  now();
  playback.dispatch({ do: "last" });
  expect(now()).toEqual(["L X+80 FMAX", "L X+80 FMAX"]);
  playback.dispatch({ do: "back" });
  expect(now()).toEqual(["L X+80 FMAX", "L X+80 FMAX"]);
  playback.dispatch({ do: "back" });
  expect(now()).toEqual(["L Z-21.7 F0.2", "L Z-21.7 F0.2"]);
  playback.dispatch({ do: "play" });
  expect(now()).toEqual(["L Z-21.7 F0.2", "L Z-21.7 F0.2"]);
  playback.dispatch({ do: "pause" });
  now();
  playback.dispatch({ do: "load", track: trackOf([...Array.from({ length: steps + 1 }, () => ({ seconds: 1 }))]) });
  expect(now().slice(1)).toEqual([]);
  playback.dispatch({ do: "first" });
  expect(now()).toEqual([null, "L X+58.3 FMAX"]);
  expect([view.state.selection.main.head, document.activeElement]).toEqual([3, focus]);
  // A block selected in the text itself is visible already.
  openBlock(9);
  vi.advanceTimersByTime(2000);
  expect(now()[0]).toBe("L Z-21.7 F0.2");
});

test("a block selected before the first run is shown once the run is ready", () => {
  forgetOutcome();
  const { view, made, planned } = turned();
  view.dispatch({ selection: { anchor: view.state.doc.line(10).from }, userEvent: "select.pointer" });
  vi.advanceTimersByTime(2000);
  playback.dispatch({ do: "load", track: trackOf([]) });
  takeOutcome({ ...planned, simulation: simulate(made) });
  expect(view.state.doc.line(10).text).toBe("L Z-21.7 F0.2");
  expect(made.stepBlocks[playback.get().position.step]).toBe(9);
});
