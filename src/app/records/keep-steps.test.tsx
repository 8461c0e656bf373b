import { afterEach, beforeEach, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { draftOf, setContour, setPrompt, setRapid } from "../document/edits.ts";
import {
  closeSession,
  dispatchEdit,
  flushText,
  openBlock,
  openSession,
  sessionText,
  sessionView,
  useSession,
} from "../fields/blocks/session.ts";
import { undoStep, redoStep } from "../document/history.ts";
import { closeStep, forgetAllSteps, historyOf, redo, undo } from "../document/steps.ts";
import { editOwn, ownRecord, useOwn } from "../document/own-store.ts";
import { pendingEdits, openDocument, openFirstWork, changeProgram, open, useEditor } from "../document/store.ts";
import { setCell } from "../../features/tools/tool-edits.ts";
import { toolRecord, useTools } from "../document/tool-store.ts";
import type { Work } from "../document/work.ts";
import { startKeepingSteps, takeKeptSteps } from "./keep-steps.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const job = exampleJob(cycle);
const [q = "", other = ""] = Object.keys(cycle.params);
const TEXT = "0 BEGIN PGM A MM\n1 L X+41.3 Z-3.25 FMAX\n2 M30\n3 END PGM A MM\n";
let stop = () => undefined as void;

beforeEach(() => {
  sessionStorage.clear();
  toolRecord.replace(shippedList);
  ownRecord.replace([]);
  pendingEdits.add(flushText);
  stop = startKeepingSteps();
});
afterEach(() => {
  stop();
  pendingEdits.delete(flushText);
  closeSession();
  forgetAllSteps();
});

const typed = (text: string, at = q) => {
  closeStep();
  for (let i = 1; i <= text.length; i++) setPrompt(at, text.slice(0, i));
};
const value = (at = q) => draftOf(useEditor.getState().job ?? job)[at];
/** Reloads the page: an equal work from the device, and nothing in memory. */
function reload(work = "w", elsewhere: Work | null = null): void {
  dispatchEvent(new Event("pagehide"));
  const content = elsewhere ?? useEditor.getState().job ?? useEditor.getState().program;
  closeSession();
  forgetAllSteps();
  // Reading a work may change the order of its fields.
  const entries = Object.entries(JSON.parse(JSON.stringify(content)) as object).reverse();
  openFirstWork(Object.fromEntries(entries) as unknown as Work, work);
  const { program } = useEditor.getState();
  if (program) openSession(program, work);
  else takeKeptSteps();
}
const lengths = (of = openDocument()) => [historyOf(of).past.length, historyOf(of).future.length];

test("after a reload a typed number is undone in one step and redone, also after another reload", () => {
  openFirstWork(job, "w");
  const first = value();
  typed("-41.37");
  typed("7.25", other);
  closeStep();
  setRapid("8125");
  closeStep();
  setContour([]);
  reload();
  expect(lengths()[0]).toBeGreaterThan(2);
  undoStep();
  undoStep();
  undoStep();
  undoStep();
  expect(value()).toBe(first);
  expect(useEditor.getState().job).toEqual(job);
  redoStep();
  expect(value()).toBe("-41.37");
  reload();
  undoStep();
  expect(value()).toBe(first);
  redoStep();
  redoStep();
  expect([value(), value(other)]).toEqual(["-41.37", "7.25"]);
  typed("3", other);
  expect(lengths()[1]).toBe(0);
});

const toolCell = () => useTools.getState().list.find(({ id }) => id === "r2")?.cells.RS;

test("the tool table, the own cycles and each work keep histories of their own", () => {
  openFirstWork({ ...job, name: "BEFORE" }, "v");
  const [first, radius] = [value(), toolCell()];
  typed("1.5");
  open(job, "w");
  typed("-41.37");
  setCell("r2", "RS", "0.7");
  editOwn((list) => [...list, { id: "c1", number: "1711", name: "SAW", parameters: [] }]);
  typed("7.25", other);
  reload();
  expect([lengths(), lengths("tools"), lengths("own-cycles")]).toEqual([
    [2, 0],
    [1, 0],
    [1, 0],
  ]);
  undo("tools");
  expect([toolCell(), useOwn.getState().list.length, value(other)]).toEqual([radius, 1, "7.25"]);
  reload();
  redo("tools");
  undo("own-cycles");
  undoStep();
  undoStep();
  expect([toolCell(), useOwn.getState().list, value()]).toEqual(["0.7", [], first]);
  open({ ...job, name: "BEFORE", drafts: { ...job.drafts, [job.cycle]: { ...draftOf(job), [q]: "1.5" } } }, "v");
  expect(lengths()).toEqual([1, 0]);
  undoStep();
  expect(value()).toBe(first);
});

test("steps of a table that changed meanwhile are not restored, those of the work are", () => {
  openFirstWork(job, "w");
  const first = value();
  typed("-41.37");
  setCell("r2", "RS", "0.7");
  typed("7.25", other);
  dispatchEvent(new Event("pagehide"));
  const note = sessionStorage.getItem("turnwise/steps") ?? "";
  toolRecord.replace([]);
  const now = useEditor.getState().job;
  forgetAllSteps();
  openFirstWork(now, "w");
  sessionStorage.setItem("turnwise/steps", note);
  takeKeptSteps();
  expect([lengths(), lengths("tools")]).toEqual([
    [2, 0],
    [0, 0],
  ]);
  undoStep();
  undoStep();
  expect(value()).toBe(first);
});

test("changes of the tools are restored without an open work", () => {
  openFirstWork(null, null);
  const radius = toolCell();
  setCell("r2", "RS", "0.9");
  dispatchEvent(new Event("pagehide"));
  forgetAllSteps();
  takeKeptSteps();
  undo("tools");
  expect(toolCell()).toBe(radius);
});

test("a work that changed meanwhile, or another one, has no history", () => {
  openFirstWork(job, "w");
  typed("-41.37");
  reload("w", { ...job, rapid: "9125" });
  expect(lengths()).toEqual([0, 0]);
  openFirstWork(job, "w");
  typed("-41.37");
  reload("copy");
  expect(lengths()).toEqual([0, 0]);
});

const OLD = '{"work":"w","print":"7 a b","tables":{},"past":[{"near":0,"far":0}],"future":[],"texts":[]}';
test.each(["", "{", "3", OLD, '{"histories":[null,{}]}', '{"histories":[{"document":"work w","print":1,"past":3}]}'])(
  "a damaged history %j, or one of an earlier version, is ignored",
  (note) => {
    openFirstWork(job, "w");
    sessionStorage.setItem("turnwise/steps", note);
    takeKeptSteps();
    expect(lengths()).toEqual([0, 0]);
  },
);

test("a program's text, its files and the cursor are restored with their history", () => {
  openFirstWork({ name: "A.h", text: TEXT, encoding: "utf-8" }, "w");
  openSession(useEditor.getState().program!, "w");
  const at = TEXT.indexOf("-3.25");
  dispatchEdit({ changes: { from: at, to: at + 5, insert: "-4.75" } }, null);
  changeProgram((program) => ({ ...program, skipMarked: true }));
  dispatchEdit({ changes: { from: at, to: at + 5, insert: "-5.5" } }, null);
  openBlock(2);
  reload();
  expect(useSession.getState().index).toBe(2);
  expect(sessionText()).toContain("Z-5.5");
  undoStep();
  expect(sessionText()).toContain("Z-4.75");
  undoStep();
  expect(useEditor.getState().program?.skipMarked).toBeUndefined();
  undoStep();
  expect(sessionText()).toBe(TEXT);
  expect(lengths()).toEqual([0, 3]);
  redoStep();
  expect(sessionText()).toContain("Z-4.75");
  reload();
  undoStep();
  expect(sessionText()).toBe(TEXT);
  redoStep();
  redoStep();
  expect(useEditor.getState().program?.skipMarked).toBe(true);
  expect(sessionView()).not.toBeNull();
});
