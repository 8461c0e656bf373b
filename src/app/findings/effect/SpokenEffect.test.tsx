import { act, cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import { never } from "../../../kernel/never.ts";
import { parse } from "../../../nc/parse.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { simulate } from "../../../sim/simulate.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { forgetOutcome, takeOutcome } from "../../calculation/outcome.ts";
import { setPrompt } from "../../document/edits.ts";
import { printedText } from "../../document/printed.ts";
import { openFirstWork, useEditor } from "../../document/store.ts";
import { openPrompt } from "../../place/place.ts";
import { SpokenEffect } from "./SpokenEffect.tsx";

const cycle = catalogue.find(({ number }) => number === 812) ?? never("no such cycle");

let version = 0;
/** The open work is calculated. */
function calculate(): void {
  const text = printedText(useEditor.getState().job ?? never("no job"));
  const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  version += 1;
  act(() => takeOutcome({ version, text, run: made, simulation: simulate(made) }));
}
const said = () => screen.getByRole("status").textContent;

beforeEach(() => {
  changeSettings({ language: "en" });
  openFirstWork(exampleJob(cycle), "work");
  openPrompt("Q463", "3");
  render(<SpokenEffect />);
  calculate();
});
afterEach(() => {
  cleanup();
  forgetOutcome();
});

test("a taken value is followed by one sentence, once it is calculated", () => {
  act(() => setPrompt("Q463", "2.2"));
  calculate();
  expect(said()).toBe("");
  act(() => openPrompt("Q478", "0.3"));
  expect(said()).toMatch(/^6 passes of 2\.04 mm, \d+ min \d+ s$/);

  act(() => setPrompt("Q463", "1.5"));
  act(() => openPrompt("Q483", "0.4"));
  expect(said()).toContain("6 passes");
  calculate();
  expect(said()).toContain("9 passes of 1.36 mm");
});

test("opening a prompt or a work says nothing", () => {
  act(() => openPrompt("Q478", "0.3"));
  act(() => openPrompt("Q463", "3"));
  expect(said()).toBe("");
  act(() => openFirstWork(exampleJob(catalogue.find(({ number }) => number === 811) ?? cycle), "other"));
  act(() => openPrompt("Q478", "0.3"));
  calculate();
  expect(said()).toBe("");
});
