import { undoStep } from "../../document/history.ts";
import { cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { draftOf } from "../../document/edits.ts";
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
  changeSettings({ language: "en" });
  openFirstWork(exampleJob(cycle), "work");
  openPrompt(pitch, "2");
  render(<Page />);
});
afterEach(cleanup);

test("a size by its name fills pitch, depth, diameter and one start, in one step of undo", async () => {
  const user = userEvent.setup();
  const before = draft();
  await user.type(await screen.findByRole("searchbox", { name: "Nominal size" }), "m20x1,5{Enter}");
  await screen.findByText(/M20×1.5: pitch/);
  expect(draft()).toEqual({ ...before, [pitch]: "1.5", [depth]: "0.92", [starts]: "1", [diameter]: "20" });
  expect(draft()[position]).toBe(before[position]);
  undoStep();
  expect(draft()).toEqual(before);
});

test("a tap sets the size, and a name that no standard has gives a message", async () => {
  const user = userEvent.setup();
  const field = await screen.findByRole("searchbox", { name: "Nominal size" });
  await user.type(field, "G½");
  await user.click(await screen.findByRole("button", { name: /^G1\/2/ }));
  expect(draft()[diameter]).toBe("20.955");
  expect(document.activeElement).toBe(field);
  await screen.findByText(/point angle of 55°/);
  await user.type(field, "W7");
  await screen.findByText(/^No thread of this name/);
});
