import { undoStep } from "../../document/history.ts";
import { cleanup, render, screen, waitFor } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { cuttingCycles } from "../../../cycles/index.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { goToField } from "../../place/place.ts";
import { useReading } from "../../document/reading.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../document/store.ts";
import { SetupPanel } from "./SetupPanel.tsx";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");

function Page() {
  const read = useReading();
  return read && <SetupPanel read={read} />;
}
const job = () => useEditor.getState().job ?? exampleJob(cycle);
const field = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });

beforeEach(async () => {
  changeSettings({ language: "en" });
  openFirstWork(exampleJob(cycle), "work");
  render(<Page />);
  await screen.findByRole("textbox", { name: "Outside diameter" });
});
afterEach(cleanup);

test("each field is one step of undo", async () => {
  const user = userEvent.setup();
  const { outside } = job().blank;
  await user.clear(field("Outside diameter"));
  await user.type(field("Outside diameter"), "82.5");
  expect(job().blank.outside).toBe("82.5");
  undoStep();
  expect(job().blank.outside).toBe(outside);
});

test("minus over a selected number begins a negative one, a sum is evaluated when the field is left", async () => {
  const user = userEvent.setup();
  field("Start Z").select();
  field("Start Z").focus();
  await user.keyboard("-3");
  expect(job().start.z).toBe("-3");
  await user.clear(field("Start X"));
  await user.type(field("Start X"), "70/2+5");
  await user.tab();
  expect(job().start.x).toBe("40");
});

test.each([
  ["ten", "This is not a number."],
  ["0", "The value must be more than 0."],
])("length %j says: %s", async (text, said) => {
  const user = userEvent.setup();
  await user.clear(field("Length"));
  if (text) await user.type(field("Length"), text);
  expect(field("Length").getAttribute("aria-invalid")).toBe("true");
  expect(screen.getByText(said)).toBeTruthy();
});

test("an empty field shows the proposal for the values, and can confirm it", async () => {
  const user = userEvent.setup();
  await user.clear(field("Length"));
  await waitFor(() => expect(Number(field("Length").placeholder)).toBeGreaterThan(40));
  const proposed = field("Length").placeholder;
  expect(field("Length").getAttribute("aria-invalid")).toBe("false");
  expect(job().blank.length).toBe("");
  await user.click(screen.getByRole("button", { name: `Length: confirm ${proposed}` }));
  expect([job().blank.length, field("Length").value]).toEqual([proposed, proposed]);
  undoStep();
  expect(job().blank.length).toBe("");
});

test("spindle, feed unit and tool are chosen by name", async () => {
  const user = userEvent.setup();
  await user.click(screen.getByRole("radio", { name: "Constant speed" }));
  expect(job().spindle.mode).toBe("constant");
  expect(field("Speed S").value).toBe(job().spindle.speed);
  await user.click(screen.getByRole("checkbox", { name: /^M136/ }));
  expect(job().perRevolution).toBe(false);
  await user.click(screen.getByRole("radio", { name: /^Tool 2 / }));
  expect(job().tool).toBe(2);
});

test("a finding focuses its field", async () => {
  goToField("setup", "start.z");
  await screen.findByRole("textbox", { name: "Start Z" });
  expect(document.activeElement).toBe(field("Start Z"));
});
