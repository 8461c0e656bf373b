import { undoStep } from "../../document/history.ts";
import { cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { draftOf, setPrompt } from "../../document/edits.ts";
import { takePlace } from "../../document/setup-edits.ts";
import { toolTable } from "../../document/work-tools.ts";
import { openPrompt } from "../../place/place.ts";
import { useReading } from "../../document/reading.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../document/store.ts";
import { CycleDialog } from "./CycleDialog.tsx";

const cycle = catalogue.find((c) => c.thread && c.thread.diameters.length === 1);
if (!cycle?.thread) throw new Error("no cycle for a thread on one diameter");
const {
  pitch,
  depth,
  starts,
  diameters: [diameter = ""],
  position,
} = cycle.thread;

function Page() {
  const read = useReading();
  return read && <CycleDialog read={read} />;
}
const draft = () => draftOf(useEditor.getState().job ?? exampleJob(cycle));

beforeEach(() => {
  // The test browser does not scroll.
  Element.prototype.scrollIntoView = () => undefined;
  changeSettings({ language: "en" });
  openFirstWork(exampleJob(cycle), "work");
  openPrompt(pitch, "2");
  render(<Page />);
});
afterEach(cleanup);

const field = () => screen.findByRole("combobox", { name: "Thread" });

test("a name fills pitch, depth, diameter and one start, in one step of undo, and stays recognized", async () => {
  const user = userEvent.setup();
  const before = draft();
  await user.type(await field(), "m20x1,5");
  // Nothing changes before it is pressed.
  await screen.findByRole("group", { name: "Values for M20×1.5 6g" });
  expect(draft()).toEqual(before);
  await user.keyboard("{Enter}");
  await screen.findByText("This is M20×1.5 6g");
  const filled = { ...before, [pitch]: "1.5", [depth]: "0.896", [starts]: "1", [diameter]: "19.85" };
  expect(draft()).toEqual(filled);
  expect(draft()[position]).toBe(before[position]);
  expect(useEditor.getState().job?.blank.outside).toBe("19.85");
  setPrompt(depth, "0.8");
  await screen.findByText(/^Not M20×1.5 6g .* 0.8, correct 0.896/);
  await user.click(screen.getByRole("button", { name: "Correct" }));
  expect(draft()).toEqual(filled);
  undoStep();
  undoStep();
  undoStep();
  expect(draft()).toEqual(before);
});

test("the basic size is a choice, and an insert of another angle is named with a tool to add", async () => {
  const user = userEvent.setup();
  await user.type(await field(), "G½");
  await user.selectOptions(await screen.findByRole("combobox", { name: "Thread size" }), "Basic size");
  await user.click(screen.getByRole("button", { name: "Fill in" }));
  expect([draft()[diameter], draft()[depth]]).toEqual(["20.955", "1.162"]);
  expect(document.activeElement).toBe(await field());
  await user.click(await screen.findByRole("button", { name: "Add a thread tool with 55°" }));
  const called = useEditor.getState().job?.tool;
  expect(toolTable().tools.find(({ T }) => T === called)).toMatchObject({ TYPE: "THREAD", TO: 2, "P-ANGLE": 55 });
  takePlace("tool", "12");
  await user.click(await screen.findByRole("button", { name: `Use T${String(called)}` }));
  expect(useEditor.getState().job?.tool).toBe(called);
});

test("a name that no standard has gives a message", async () => {
  const user = userEvent.setup();
  await user.type(await field(), "X7");
  await screen.findByText(/^No thread of this name/);
});
