import { beforeEach, expect, test } from "vitest";
import { catalogue } from "../cycles/index.ts";
import { exampleJob } from "../program/job.ts";
import { draftOf, setBlank, setPrompt, setTool } from "./edits.ts";
import { begin, closeStep, edit, open, redo, undo, useEditor } from "./store.ts";

const [cycle] = catalogue;
if (!cycle) throw new Error("the catalogue is empty");
const [first = "", second = ""] = Object.keys(cycle.params).filter((q) => !cycle.params[q]?.choices);
const value = (q: string) => draftOf(useEditor.getState().job ?? exampleJob(cycle))[q];
const steps = () => useEditor.temporal.getState().pastStates.length;

beforeEach(() => begin(exampleJob(cycle), "work"));

test("typing in one field is one step of undo", () => {
  const before = value(first);
  setPrompt(first, "1");
  setPrompt(first, "12");
  setPrompt(first, "12.5");
  expect(steps()).toBe(1);
  undo();
  expect(value(first)).toBe(before);
  redo();
  expect(value(first)).toBe("12.5");
});

test("another field, or leaving the field, begins a new step", () => {
  setPrompt(first, "1");
  setPrompt(second, "2");
  setPrompt(first, "13");
  closeStep();
  setPrompt(first, "135");
  expect(steps()).toBe(4);
  undo();
  expect(value(first)).toBe("13");
});

test("undo reaches tool, blank and the choice of the program", () => {
  const tool = useEditor.getState().job?.tool;
  setTool(99);
  setBlank("outside", "80");
  open(null, null);
  undo();
  expect(useEditor.getState().work).toBe("work");
  undo();
  undo();
  expect(useEditor.getState().job?.tool).toBe(tool);
});

test("typing on after undo does not bring back what was undone", () => {
  setPrompt(first, "1");
  undo();
  setPrompt(first, "7");
  expect(useEditor.temporal.getState().futureStates).toEqual([]);
  undo();
  expect(value(first)).toBe(exampleJob(cycle).drafts[cycle.number]?.[first]);
});

test("a change that changes nothing is no step", () => {
  edit((job) => job);
  setPrompt(first, value(first) ?? "");
  expect(steps()).toBe(0);
});

test("the first work has nothing before it", () => {
  undo();
  expect(useEditor.getState().job).not.toBeNull();
});
