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
import { closeStep, forget, redo, undo, useSteps } from "../document/steps.ts";
import { editOwn, ownRecord, useOwn } from "../document/own-store.ts";
import { pendingEdits, openFirstWork, changeProgram, open, useEditor } from "../document/store.ts";
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
  forget();
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
  forget();
  // Reading a work may change the order of its fields.
  const entries = Object.entries(JSON.parse(JSON.stringify(content)) as object).reverse();
  openFirstWork(Object.fromEntries(entries) as unknown as Work, work);
  const { program } = useEditor.getState();
  if (program) openSession(program, work);
  else takeKeptSteps();
}
const lengths = () => [useSteps.getState().past.length, useSteps.getState().future.length];

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
  undo();
  undo();
  undo();
  undo();
  expect(value()).toBe(first);
  expect(useEditor.getState().job).toEqual(job);
  redo();
  expect(value()).toBe("-41.37");
  reload();
  undo();
  expect(value()).toBe(first);
  redo();
  redo();
  expect([value(), value(other)]).toEqual(["-41.37", "7.25"]);
  typed("3", other);
  expect(lengths()[1]).toBe(0);
});

const toolCell = () => useTools.getState().list.find(({ id }) => id === "r2")?.cells.RS;

test("steps of the tool table and of own cycles are restored in order between those of the work", () => {
  openFirstWork(job, "w");
  const [first, radius] = [value(), toolCell()];
  typed("-41.37");
  setCell("r2", "RS", "0.7");
  editOwn((list) => [...list, { id: "c1", number: "1711", name: "SAW", parameters: [] }]);
  typed("7.25", other);
  reload();
  expect(lengths()).toEqual([4, 0]);
  undo();
  undo();
  expect([toolCell(), useOwn.getState().list, value()]).toEqual(["0.7", [], "-41.37"]);
  reload();
  undo();
  expect([toolCell(), value()]).toEqual([radius, "-41.37"]);
  undo();
  expect(value()).toBe(first);
  for (let i = 0; i < 4; i++) redo();
  expect([toolCell(), useOwn.getState().list.length, value(other)]).toEqual(["0.7", 1, "7.25"]);
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
  forget();
  openFirstWork(now, "w");
  sessionStorage.setItem("turnwise/steps", note);
  takeKeptSteps();
  expect(lengths()).toEqual([2, 0]);
  undo();
  undo();
  expect(value()).toBe(first);
});

test("changes of the tools are restored without an open work", () => {
  openFirstWork(null, null);
  const radius = toolCell();
  setCell("r2", "RS", "0.9");
  dispatchEvent(new Event("pagehide"));
  forget();
  takeKeptSteps();
  undo();
  expect(toolCell()).toBe(radius);
});

test("a work opened before is no part of the history", () => {
  openFirstWork({ ...job, name: "BEFORE" }, "v");
  typed("1.5");
  open(job, "w");
  typed("-41.37");
  reload();
  expect(lengths()).toEqual([1, 0]);
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

test.each(["", "{", "3", '{"work":"w"}', '{"work":"w","print":1,"past":3}'])(
  "a damaged history %j is ignored",
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
  undo();
  expect(sessionText()).toContain("Z-4.75");
  undo();
  expect(useEditor.getState().program?.skipMarked).toBeUndefined();
  undo();
  expect(sessionText()).toBe(TEXT);
  expect(lengths()).toEqual([0, 3]);
  redo();
  expect(sessionText()).toContain("Z-4.75");
  reload();
  undo();
  expect(sessionText()).toBe(TEXT);
  redo();
  redo();
  expect(useEditor.getState().program?.skipMarked).toBe(true);
  expect(sessionView()).not.toBeNull();
});
