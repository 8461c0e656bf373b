import { beforeEach, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { cellOf } from "../../program/tools/tool-entry.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { draftOf, setPrompt } from "./edits.ts";
import { documentInView, redoStep, undoStep } from "./history.ts";
import { setPlace } from "./setup-edits.ts";
import { asOneStep, closeStep, historyOf } from "./steps.ts";
import { openDocument, openFirstWork, changeJob, open, useEditor } from "./store.ts";
import { setCell } from "../../features/tools/tool-edits.ts";
import { shownPage, showTools, uncover, usePlace } from "../place/place.ts";
import { toolRecord, useTools } from "./tool-store.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const [first = "", second = ""] = Object.keys(cycle.params).filter((q) => !cycle.params[q]?.choices);
const value = (q: string) => draftOf(useEditor.getState().job ?? exampleJob(cycle))[q];
const steps = () => historyOf(openDocument()).past.length;

beforeEach(() => openFirstWork(exampleJob(cycle), "work"));

test("typing in one field is one step of undo", () => {
  const before = value(first);
  setPrompt(first, "1");
  setPrompt(first, "12");
  setPrompt(first, "12.5");
  expect(steps()).toBe(1);
  undoStep();
  expect(value(first)).toBe(before);
  redoStep();
  expect(value(first)).toBe("12.5");
});

test("another field, or leaving the field, begins a new step", () => {
  setPrompt(first, "1");
  setPrompt(second, "2");
  setPrompt(first, "13");
  closeStep();
  setPrompt(first, "135");
  expect(steps()).toBe(4);
  undoStep();
  expect(value(first)).toBe("13");
});

test("undo reaches tool and blank, and ends at the beginning of the work", () => {
  const tool = useEditor.getState().job?.tool;
  open(exampleJob(cycle), "before");
  openFirstWork(exampleJob(cycle), "work");
  setPlace("tool", "99");
  setPlace("blank.outside", "80");
  for (let i = 0; i < 4; i++) undoStep();
  expect(useEditor.getState()).toMatchObject({ work: "work", job: { tool } });
});

test("typing on after undo does not bring back what was undone", () => {
  setPrompt(first, "1");
  undoStep();
  setPrompt(first, "7");
  expect(historyOf(openDocument()).future).toEqual([]);
  undoStep();
  expect(value(first)).toBe(exampleJob(cycle).drafts[cycle.number]?.[first]);
});

const seenPage = () => shownPage(usePlace.getState()).page;

test("undo takes back changes of the document in view, and opens the changed row", () => {
  const cell = () => cellOf(useTools.getState().list[1] ?? shippedList[0]!, "RS");
  const [value0, cell0] = [value(first), cell()];
  setPrompt(first, "1");
  setCell("r2", "RS", "0.7");
  closeStep();
  setPrompt(first, "12");
  undoStep();
  undoStep();
  undoStep();
  expect([value(first), cell(), seenPage()]).toEqual([value0, "0.7", "work"]);
  showTools("r5");
  undoStep();
  expect([value(first), cell(), seenPage(), usePlace.getState().tools.row]).toEqual([value0, cell0, "tools", "r2"]);
  redoStep();
  uncover();
  redoStep();
  redoStep();
  expect([value(first), cell()]).toEqual(["12", "0.7"]);
});

test("the history of a work goes on when it is opened again, unless it changed meanwhile", () => {
  setPrompt(first, "1");
  const changed = useEditor.getState().job;
  open(exampleJob(cycle), "other");
  expect(documentInView()).toBe("work other");
  undoStep();
  undoStep("work work");
  open(JSON.parse(JSON.stringify(changed)) as typeof changed, "work");
  expect([steps(), value(first)]).toEqual([1, "1"]);
  open(null, null);
  open(exampleJob(cycle), "work");
  expect(steps()).toBe(0);
});

test("a table that is replaced from outside loses its steps, and no others", () => {
  setPrompt(first, "1");
  setCell("r2", "RS", "0.7");
  toolRecord.replace(shippedList);
  expect(steps()).toBe(1);
  undoStep();
  expect(value(first)).toBe(exampleJob(cycle).drafts[cycle.number]?.[first]);
});

test("a change that changes nothing is no step", () => {
  changeJob((job) => job);
  setPrompt(first, value(first) ?? "");
  expect(steps()).toBe(0);
});

test("a digit typed and erased is no step, and the next key joins no earlier step", () => {
  const before = value(second) ?? "";
  setPrompt(first, "17.3");
  setPrompt(second, `${before}4`);
  setPrompt(second, before);
  expect(steps()).toBe(1);
  setPrompt(second, "8.25");
  expect(steps()).toBe(2);
  undoStep();
  expect([value(first), value(second)]).toEqual(["17.3", before]);
});

test("replacing a state with an equal one is no step, and keeps the redo steps", () => {
  setPrompt(first, "17.3");
  undoStep();
  changeJob((job) => ({ ...job, contour: job.contour.map((row) => ({ ...row })) }));
  expect(steps()).toBe(0);
  redoStep();
  expect(value(first)).toBe("17.3");
});

test("the changes of one button are one step, without anything typed before", () => {
  const [value0, outside0] = [value(first), useEditor.getState().job?.blank.outside];
  setPrompt(first, "17.3");
  asOneStep(() => setPrompt(first, "17.3"));
  asOneStep(() => {
    setPrompt(first, "17.35");
    setPlace("blank.outside", "83.1");
  });
  expect(steps()).toBe(2);
  undoStep();
  expect([value(first), useEditor.getState().job?.blank.outside]).toEqual(["17.3", outside0]);
  redoStep();
  expect([value(first), useEditor.getState().job?.blank.outside]).toEqual(["17.35", "83.1"]);
  undoStep();
  undoStep();
  expect(value(first)).toBe(value0);
});

test("the first work has nothing before it", () => {
  undoStep();
  expect(useEditor.getState().job).not.toBeNull();
});
