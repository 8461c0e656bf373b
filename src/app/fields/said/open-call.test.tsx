import { act, cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import { never } from "../../../kernel/never.ts";
import { advice } from "../../../i18n/en/advice.ts";
import { parse } from "../../../nc/parse.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { run } from "../../../program/run/run.ts";
import type { Operation } from "../../../program/state/run-types.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { simulate } from "../../../sim/simulate.ts";
import { forgetOutcome, takeOutcome } from "../../calculation/outcome.ts";
import { printedText } from "../../document/printed.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { openFirstWork } from "../../document/store.ts";
import { useOpenCall } from "../../place/open-call.ts";
import { guideSources } from "../../../features/guide/guide-source.ts";
import { PromptMore } from "../../../features/guide/PromptMore.tsx";

const cycle = cycleByNumber(812) ?? never("no such cycle");
const text = printedText(exampleJob(cycle));
const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
const first = made.operations[0] ?? never("no call");
const FURTHER_DOWN = first.definedLine + 41;
/** A second call with a deeper infeed than the spindle can cut. */
const deep: Operation = {
  ...first,
  definedLine: FURTHER_DOWN,
  plan: { ...first.plan, infeed: 7.9 as typeof first.plan.infeed },
  call: first.call && { ...first.call, values: { ...first.call.values, Q463: 7.9 } as typeof first.call.values },
};
const open = (line: number, work = "w") => act(() => useOpenCall.setState({ call: { work, cycle: 812, line } }));
const infeedOf = () => guideSources(cycle).map(({ job, isOwn }) => isOwn && job.drafts["812"]?.["Q463"]);

beforeEach(() => {
  changeSettings({ language: "en" });
  forgetOutcome();
  useOpenCall.setState({ call: null });
  openFirstWork({ name: "TWO.H", text, encoding: "utf-8" }, "w");
  takeOutcome({ version: 1, text, run: { ...made, operations: [first, deep] }, simulation: simulate(made) });
});
afterEach(cleanup);

test("advice at a prompt and the pages of its cycle refer to the open block's call", async () => {
  render(<PromptMore page={["guide", "812", "Q463"]} name="Q463" />);
  await screen.findByRole("button", { name: "More about Q463" });
  const usual = String(first.call?.values["Q463"]);
  expect(screen.queryByRole("button", { name: advice.mark(1) })).toBeNull();
  expect(infeedOf()).toEqual([usual, false]);
  open(FURTHER_DOWN);
  await screen.findByRole("button", { name: advice.mark(1) });
  expect(infeedOf()).toEqual(["7.9", false]);
  open(first.definedLine);
  expect(screen.queryByRole("button", { name: advice.mark(1) })).toBeNull();
  expect(infeedOf()).toEqual([usual, false]);
});

test("a block that was not run has none; a block of another work does not count", () => {
  open(FURTHER_DOWN + 1);
  expect(infeedOf()).toEqual([false]);
  open(FURTHER_DOWN, "other");
  expect(infeedOf()).toEqual([String(first.call?.values["Q463"]), false]);
});
