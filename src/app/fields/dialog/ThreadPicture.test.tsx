import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeAll, beforeEach, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import { parse } from "../../../nc/parse.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { run } from "../../../program/run/run.ts";
import type { Operation } from "../../../program/state/run-types.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { simulate } from "../../../sim/simulate.ts";
import { forgetOutcome, takeOutcome } from "../../calculation/outcome.ts";
import { printedText } from "../../document/printed.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { partOf } from "../../base/settings/loaded-texts.ts";
import { ThreadPicture } from "./ThreadPicture.tsx";

const cycle = cycleByNumber(831);
if (!cycle) throw new Error("no cycle for threads");
const text = printedText(exampleJob(cycle));
const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
const [first] = made.operations;
const thread = first?.plan.thread;
if (!first || !thread) throw new Error("the example makes no thread");
const FURTHER_DOWN = first.definedLine + 40;
const second: Operation = {
  ...first,
  definedLine: FURTHER_DOWN,
  plan: { ...first.plan, thread: { ...thread, depths: thread.depths.slice(-2) } },
};
const passes = (n: number) => `Thread profile with the chips of ${n} passes`;

beforeAll(async () => void (await partOf("threads").fetchWithRetry("en")));
beforeEach(() => {
  changeSettings({ language: "en" });
  forgetOutcome();
  takeOutcome({ version: 1, text, run: { ...made, operations: [first, second] }, simulation: simulate(made) });
});
afterEach(cleanup);

test.each([
  ["the job", null, thread.depths.length],
  ["the first of two threads", first.definedLine, thread.depths.length],
  ["the second of two threads", FURTHER_DOWN, 2],
])("shows the chips of %s", async (_, line, chips) => {
  render(<ThreadPicture line={line} />);
  expect((await screen.findByRole("img")).getAttribute("aria-label")).toBe(passes(chips));
});

test("shows none for a thread that was not run", () => {
  render(<ThreadPicture line={first.definedLine + 1} />);
  expect(screen.queryByRole("img")).toBeNull();
});
