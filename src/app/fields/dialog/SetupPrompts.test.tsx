import { cleanup, render, screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import { exampleJob, newRow, UNSET } from "../../../program/job/job.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { forgetOutcome } from "../../calculation/outcome.ts";
import { setContour, setPrompt } from "../../document/edits.ts";
import { printedText } from "../../document/printed.ts";
import { useReading } from "../../document/reading.ts";
import { undoStep } from "../../document/history.ts";
import { openFirstWork, useEditor } from "../../document/store.ts";
import { openPrompt } from "../../place/place.ts";
import { CycleDialog } from "./CycleDialog.tsx";
import { FIRST_PLACE } from "./setup-prompts.ts";

function Page() {
  const read = useReading();
  return read && <CycleDialog read={read} />;
}
const job = () => {
  const open = useEditor.getState().job;
  if (!open) throw new Error("no job is open");
  return open;
};
const blank = () => /BLK FORM .*/.exec(printedText(job()))?.[0] ?? "";
const tool = () => /TOOL CALL \d+/.exec(printedText(job()))?.[0] ?? "";
const active = () => screen.getByRole("region", { name: "Active prompt" });
const field = () => within(active()).getByRole<HTMLInputElement>("textbox");
const question = () => within(active()).getByRole("heading").textContent;
const row = (letter: string) => screen.getByRole("button", { name: new RegExp(`^${letter} `) });

/** Opens a new, empty work of a cycle at the first prompt of its set-up. */
function begin(number: number): void {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  openFirstWork({ ...exampleJob(cycle), ...UNSET, drafts: {}, contour: [] }, "work");
  openPrompt(FIRST_PLACE, "");
  render(<Page />);
}

beforeEach(() => void changeSettings({ language: "en" }));
afterEach(() => {
  cleanup();
  forgetOutcome();
});

test("ENT takes what is proposed: it stays whatever is typed later", async () => {
  const user = userEvent.setup();
  begin(812);
  await user.keyboard("60{Enter}");
  expect([question(), field().placeholder]).toEqual(["Inside diameter (0 = solid)", "0"]);
  await user.keyboard("{Enter}".repeat(4));
  expect([question(), field().placeholder]).toEqual(["Start X", "60"]);
  setPrompt("Q500", "0.4");
  setPrompt("Q494", "+35");
  setPrompt("Q491", "44");
  expect([tool(), blank()]).toEqual(["TOOL CALL 1", expect.stringContaining("D60 L85")]);
  expect(job().start).toEqual(UNSET.start);
});

test("with END, what nobody has touched follows the values", async () => {
  const user = userEvent.setup();
  begin(812);
  await user.keyboard("60{Enter}{End}");
  setPrompt("Q494", "-65");
  expect(blank()).toContain("D60 L95");
  await waitFor(() => expect(row("BLK").getAttribute("aria-label")).toMatch(/⌀60 × 95 .*proposed/));
});

test("a set diameter stays while the contour is drawn; another proposal is shown beside it, with undo", async () => {
  const user = userEvent.setup();
  begin(810);
  await user.keyboard("{Enter}");
  const taken = job().blank.outside;
  setContour([newRow("a", { x: "44", z: "0" }), newRow("b", { z: "-20" })]);
  expect(job().blank.outside).toBe(taken);
  openPrompt(FIRST_PLACE, taken);
  const use = await screen.findByRole("button", { name: "Use 48" });
  expect(active().textContent).toContain("proposed: 48");
  await user.click(use);
  expect([job().blank.outside, document.activeElement]).toEqual(["48", field()]);
  await waitFor(() => expect(active().textContent).not.toContain("proposed: 48"));
  undoStep();
  expect(job().blank.outside).toBe(taken);
});

test("a tool that does not suit the contour has the suitable one beside it", async () => {
  const user = userEvent.setup();
  begin(812);
  openPrompt("tool", "");
  await user.keyboard("{Enter}");
  expect(tool()).toBe("TOOL CALL 1");
  setPrompt("Q500", "0.4");
  openPrompt("tool", "1");
  await user.click(await screen.findByRole("button", { name: "Use tool 3" }));
  expect(tool()).toBe("TOOL CALL 3");
});
