import { beforeEach, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { setPrompt } from "./edits.ts";
import { shownPage, showGuide, showSheet, showTools, showWhich, usePlace } from "../place/place.ts";
import { redoStep, undoStep } from "./history.ts";
import { openFirstWork } from "./store.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const [q = "", other = ""] = Object.keys(cycle.params).filter((name) => !cycle.params[name]?.choices);

beforeEach(() => openFirstWork(exampleJob(cycle), "work"));

test.each([
  ["undo", undoStep],
  ["redo", redoStep],
] as const)("%s shows the work that it changes, whatever stood over it", (way, go) => {
  setPrompt(q, "1");
  if (way === "redo") undoStep();
  showTools();
  showGuide("guide", String(cycle.number), other);
  showWhich();
  go();
  expect([shownPage(usePlace.getState()).page, usePlace.getState().over]).toEqual(["work", null]);
});

test("the page of the parameter itself stays: the change is seen there", () => {
  setPrompt(q, "1");
  showGuide("guide", String(cycle.number), q);
  undoStep();
  expect(shownPage(usePlace.getState())).toEqual({ page: "guide", path: ["guide", String(cycle.number), q] });
});

test("the setup sheet stays: it shows the work", () => {
  setPrompt(q, "1");
  showSheet();
  undoStep();
  expect(shownPage(usePlace.getState()).page).toBe("sheet");
});

test("with nothing to undo the page stays", () => {
  openFirstWork(exampleJob(cycle), "other");
  showGuide("guide", String(cycle.number), q);
  redoStep();
  expect(shownPage(usePlace.getState()).page).toBe("guide");
});
