import { setPlace } from "../../document/setup-edits.ts";
import { undoStep, redoStep } from "../../document/history.ts";
import { cleanup, render, screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import { parse } from "../../../nc/parse.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { simulate } from "../../../sim/simulate.ts";
import { draftOf, setPrompt } from "../../document/edits.ts";
import { forgetOutcome, takeOutcome } from "../../calculation/outcome.ts";
import { openPrompt } from "../../place/place.ts";
import { printedText } from "../../document/printed.ts";
import { useReading } from "../../document/reading.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../document/store.ts";
import { CycleDialog } from "./CycleDialog.tsx";

const cycle = catalogue.find((c) => c.contour === "own" && c.evidence === "A");
if (!cycle) throw new Error("no cycle with a contour of its own");
const prompts = Object.keys(cycle.params);
const of = (kind: string) => Object.keys(cycle.params).find((q) => cycle.params[q]?.kind === kind) ?? "";
const [diameter, axial, feed, choice, angle] = [of("diameter"), of("axial"), of("feed"), of("choice"), of("angle")];
const optional = prompts.find((q) => cycle.params[q]?.optional) ?? "";
const after = (q: string) => prompts[prompts.indexOf(q) + 1] ?? "";

function Page() {
  const read = useReading();
  return read && <CycleDialog read={read} />;
}
const typed = (q: string) => draftOf(useEditor.getState().job ?? exampleJob(cycle))[q];
const goTo = (q: string | null) => openPrompt(q, q === null ? "" : (typed(q) ?? ""));
const active = () => screen.getByRole("region", { name: "Active prompt" });
const field = () => within(active()).getByRole<HTMLInputElement>("textbox");
const question = () => within(active()).getByRole("heading").textContent;
const shows = (q: string) => within(active()).queryByText(q) !== null;

beforeEach(() => {
  changeSettings({ language: "en" });
  openFirstWork(exampleJob(cycle), "work");
  goTo(prompts[0] ?? null);
  render(<Page />);
});
afterEach(() => {
  cleanup();
  forgetOutcome();
});

test("ENT takes each value and ends with the copy button", async () => {
  const user = userEvent.setup();
  for (const q of prompts) {
    expect(shows(q), q).toBe(true);
    await user.keyboard("{Enter}");
  }
  expect(question()).toBe("Checking …");
  expect(document.activeElement).toBe(screen.getByRole("button", { name: /^Copy the program/ }));
});

test("ENT skips prompts without effect; arrows reach them, NO ENT omits them, and typed text is kept", async () => {
  const user = userEvent.setup();
  const size = prompts.find((q) => cycle.params[q]?.sizes !== undefined) ?? "";
  const element = cycle.params[size]?.sizes ?? "";
  const line = () => screen.getByRole("button", { name: new RegExp(`^${size} `) });
  setPrompt(element, "0");
  goTo(element);
  await waitFor(() => expect(line().getAttribute("aria-label")).toContain("no effect"));
  await user.keyboard("{Enter}");
  expect(shows(after(size))).toBe(true);
  expect(typed(size)).toBe(String(cycle.params[size]?.example));
  await user.keyboard("{ArrowUp}");
  expect(shows(size)).toBe(true);
  expect(within(active()).getByText(`no effect with ${element} = 0`)).toBeTruthy();
  await user.keyboard("{Delete}");
  expect(typed(size)).toBe("");
  expect(shows(after(size))).toBe(true);
  await user.keyboard("{End}");
  expect(question()).toBe("Checking …");
  setPrompt(element, "1");
  await screen.findByText("1 prompt open");
});

test("arrows and Tab move, before the first prompt through the set-up, and stop at its first prompt", async () => {
  const user = userEvent.setup();
  await user.keyboard("{ArrowDown}{ArrowDown}{ArrowUp}");
  expect(shows(prompts[1] ?? "")).toBe(true);
  await user.keyboard("{ArrowUp}");
  expect(shows(prompts[0] ?? "")).toBe(true);
  await user.keyboard("{ArrowUp}".repeat(9));
  expect(question()).toBe("Outside diameter");
  await user.keyboard("{End}");
  expect(shows(prompts[0] ?? "")).toBe(true);
  goTo(axial);
  await user.keyboard("{Tab}");
  while (shows(axial)) await user.keyboard("{Tab}");
  expect(shows(after(axial))).toBe(true);
  await user.keyboard("{Shift>}{Tab}{/Shift}");
  expect(shows(axial)).toBe(true);
});

test("a typed value replaces the previous one at once", async () => {
  const user = userEvent.setup();
  goTo(diameter);
  await screen.findByDisplayValue(typed(diameter) ?? "");
  await user.keyboard("62,5");
  expect(typed(diameter)).toBe("62,5");
  await user.keyboard("{Enter}");
  expect(screen.getByRole("button", { name: new RegExp(`^${diameter} .*\\+62\\.500 mm ⌀`) })).toBeTruthy();
});

test("minus toggles the sign wherever the caret is", async () => {
  const user = userEvent.setup();
  goTo(axial);
  await screen.findByDisplayValue(typed(axial) ?? "");
  await user.keyboard("12");
  await user.keyboard("-");
  expect(field().value).toBe("-12");
  await user.keyboard("-3");
  expect(field().value).toBe("123");
});

test("a minus behind a negative number begins a sum", async () => {
  const user = userEvent.setup();
  goTo(axial);
  await screen.findByDisplayValue(typed(axial) ?? "");
  await user.keyboard("-55-2");
  expect(field().value).toBe("-55-2");
});

test("a sign is no error while its number is typed, but when it was left so", async () => {
  const user = userEvent.setup();
  goTo(axial);
  await screen.findByDisplayValue(typed(axial) ?? "");
  const error = () => within(active()).queryByText(/is not a number/);
  await user.keyboard("{Backspace}-x");
  await waitFor(() => expect(error()).toBeTruthy());
  await user.keyboard("{Backspace}");
  await waitFor(() => expect([typed(axial), error()]).toEqual(["-", null]));
  await user.keyboard("{ArrowDown}{ArrowUp}");
  await waitFor(() => expect(error()).toBeTruthy());
});

test("a sum becomes its value when the field is left, a Q parameter stays", async () => {
  const user = userEvent.setup();
  goTo(diameter);
  await screen.findByDisplayValue(typed(diameter) ?? "");
  await user.keyboard("75/2+1");
  expect(typed(diameter)).toBe("75/2+1");
  await user.keyboard("{Enter}");
  expect(typed(diameter)).toBe("38.5");
});

test("Escape restores the value from when the prompt opened", async () => {
  const user = userEvent.setup();
  goTo(diameter);
  const before = typed(diameter) ?? "";
  await screen.findByDisplayValue(before);
  await user.keyboard("1x{Escape}");
  expect(typed(diameter)).toBe(before);
  expect(shows(diameter)).toBe(true);
});

test("Delete is NO ENT where the prompt is optional, and a plain key elsewhere", async () => {
  const user = userEvent.setup();
  goTo(optional);
  await screen.findByDisplayValue(typed(optional) ?? "");
  await user.keyboard("{Delete}");
  expect(typed(optional)).toBe("");
  expect(shows(after(optional))).toBe(true);
  goTo(diameter);
  await screen.findByDisplayValue(typed(diameter) ?? "");
  await user.keyboard("{Delete}");
  expect(shows(diameter)).toBe(true);
});

test("End keeps the rest and closes the dialog; open values are counted", async () => {
  const user = userEvent.setup();
  goTo(diameter);
  await screen.findByDisplayValue(typed(diameter) ?? "");
  await user.keyboard("nothing{End}");
  expect(question()).toBe("1 prompt open");
  await user.keyboard("{Enter}");
  expect(shows(diameter)).toBe(true);
});

test("a digit or an arrow takes a choice", async () => {
  const user = userEvent.setup();
  goTo(choice);
  await within(active()).findByRole("radiogroup");
  await user.keyboard("2");
  expect(typed(choice)).toBe("2");
  await user.keyboard("{ArrowLeft}");
  expect(typed(choice)).toBe("1");
  await user.keyboard("9");
  expect(typed(choice)).toBe("1");
});

test("FAUTO stands in for a feed", async () => {
  const user = userEvent.setup();
  goTo(feed);
  await screen.findByDisplayValue(typed(feed) ?? "");
  await user.click(within(active()).getByRole("button", { name: /^FAUTO/ }));
  expect(typed(feed)).toBe("FAUTO");
  await user.keyboard("{Enter}");
  expect(screen.getByRole("button", { name: new RegExp(`^${feed} .*FAUTO`) })).toBeTruthy();
});

test.each([
  ["out of range", () => angle, "-5", /Use 5/],
  ["no number", () => diameter, "abc", null],
  ["missing", () => diameter, "", null],
])("%s gives a message at the field while typing, and never stops the typing", async (_, q, text, nearest) => {
  const user = userEvent.setup();
  goTo(q());
  await screen.findByDisplayValue(typed(q()) ?? "");
  await user.clear(field());
  if (text !== "") await user.type(field(), text);
  expect(field().value).toBe(text);
  await waitFor(() => expect(field().getAttribute("aria-invalid")).toBe("true"));
  const said = within(active()).getByRole("status");
  expect(said.textContent).not.toBe("");
  if (!nearest) return;
  await user.click(await within(said).findByRole("button", { name: nearest }));
  expect(field().getAttribute("aria-invalid")).toBe("false");
  expect(document.activeElement).toBe(field());
});

test("typing is one step of undo, and the field follows undo and redo", async () => {
  const user = userEvent.setup();
  goTo(diameter);
  const before = typed(diameter) ?? "";
  await screen.findByDisplayValue(before);
  await user.keyboard("61.75");
  undoStep();
  expect(typed(diameter)).toBe(before);
  await screen.findByDisplayValue(before);
  redoStep();
  await screen.findByDisplayValue("61.75");
});

test("prompts are asked in the language of the screen, with its decimal sign", async () => {
  const user = userEvent.setup();
  changeSettings({ language: "de" });
  goTo(feed);
  const input = await screen.findByRole<HTMLInputElement>("textbox", { name: new RegExp(`^${feed} `) });
  expect(input.value).toBe((typed(feed) ?? "").replace(".", ","));
  await user.keyboard("0,25{Enter}");
  expect(screen.getByRole("button", { name: new RegExp(`^${feed} .*0,250 mm/U`) })).toBeTruthy();
});

test("a fault without a path is shown first at the prompt that shapes the contour", async () => {
  const wide = prompts.find((q) => cycle.params[q]?.kind === "diameter") ?? "";
  goTo(wide);
  setPlace("tool", "12");
  setPlace("blank.outside", "60");
  const { job } = useEditor.getState();
  const text = job ? printedText(job) : "",
    made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  expect(made.steps.filter((step) => step.operation !== null)).toEqual([]);
  takeOutcome({ version: 1, text, run: made, simulation: simulate(made) });
  const said = () =>
    [...within(active()).getByRole("status", { name: "Findings" }).children].map((each) => each.textContent ?? "");
  await waitFor(() => expect(said()).toHaveLength(2));
  expect(said()[0]).toMatch(/^Error: T Tool: A THREAD tool/);
  expect(said()[1]).toMatch(/^Warning: D Outside diameter: The contour/);
  // Roughing or finishing has nothing to do with it.
  goTo(prompts[0] ?? null);
  await waitFor(() => expect(said()).toEqual([]));
});
