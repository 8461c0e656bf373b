import { undoStep } from "../../app/document/history.ts";
import { afterEach, beforeEach, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { never } from "../../kernel/never.ts";
import { parse } from "../../nc/parse.ts";
import { exampleJob, newRow } from "../../program/job/job.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { forgetOutcome, takeOutcome } from "../../app/calculation/outcome.ts";

import { printedText } from "../../app/document/printed.ts";
import { readJob } from "../../app/document/reading.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { useOpenCall } from "../../app/place/open-call.ts";
import { guideSources } from "./guide-source.ts";
import { applyToBlock, applyValue } from "./apply-value.ts";

const cycle = cycleByNumber(820) ?? never("no such cycle");
const CONTOUR = [
  ["0", "0"],
  ["23.7", "0"],
  ["23.7", "-11.3"],
  ["47.9", "-19.1"],
  ["47.9", "-33.3"],
] as const;
const job = { ...exampleJob(cycle), contour: CONTOUR.map(([x, z], i) => newRow(`r${i}`, { x, z })) };
const own = { ...job, spindle: { ...job.spindle, cuttingSpeed: "173", limit: "2350" } };
const text = printedText(own);
const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
const line = made.operations[0]?.definedLine ?? never("no call");
const textNow = () => useEditor.getState().program?.text ?? "";
const lineOf = (q: string) =>
  textNow()
    .split("\n")
    .find((each) => each.trim().startsWith(q))
    ?.trim();

beforeEach(() => {
  forgetOutcome();
  openFirstWork({ name: "OWN.H", text, encoding: "utf-8" }, "w");
  useOpenCall.setState({ call: { work: "w", cycle: 820, line } });
  takeOutcome({ version: 1, text, run: made, simulation: simulate(made) });
});
afterEach(forgetOutcome);

test("a free contour of a program is shown as programmed, with its speed", () => {
  const [source] = guideSources(cycle);
  expect(source?.isOwn).toBe(true);
  expect(source?.job.contour.map(({ x, z }) => [x, z])).toEqual(CONTOUR);
  expect(source?.job.spindle).toMatchObject({ mode: "surface", cuttingSpeed: "173", limit: "2350" });
  expect(source && readJob(source.job)?.reading.values).toMatchObject({ Q463: Number(job.drafts[820]?.["Q463"]) });
});

test("a value goes into the open block as one step of undo, and nowhere if no block was open", async () => {
  const before = lineOf("Q463");
  await applyValue(820, "Q463", 1.7);
  expect(lineOf("Q463")).toContain("+1.7");
  await applyValue(820, "Q478", "auto");
  expect(lineOf("Q478")).toContain("FAUTO");
  expect(
    textNow()
      .split("\n")
      .filter((each, i) => each !== text.split("\n")[i]),
  ).toHaveLength(2);
  undoStep();
  expect(lineOf("Q478")).not.toContain("FAUTO");
  expect(lineOf("Q463")).toContain("+1.7");
  undoStep();
  expect(lineOf("Q463")).toBe(before);
  expect(textNow()).toBe(text);
  useOpenCall.setState({ call: { work: "other", cycle: 820, line } });
  await applyValue(820, "Q463", 2.3);
  useOpenCall.setState({ call: { work: "w", cycle: 820, line: line - 1 } });
  await applyValue(820, "Q463", 2.3);
  expect(textNow()).toBe(text);
});

test("a text goes into a word of the block with the open form, as one named step of undo, and nowhere else", async () => {
  const at = text.split("\n").findIndex((each) => each.includes("TURNDATA SPIN")) + 1;
  await applyToBlock(at, "spin", "speedLimit", "1370", "SMAX");
  expect(lineOf(`${at - 1} FUNCTION TURNDATA SPIN`)).toContain("SMAX1370");
  expect(
    textNow()
      .split("\n")
      .filter((each, i) => each !== text.split("\n")[i]),
  ).toHaveLength(1);
  undoStep();
  expect(textNow()).toBe(text);
  await applyToBlock(at, "toolCall", "speed", "1370", "S");
  await applyToBlock(at + 1, "spin", "speedLimit", "1370", "SMAX");
  expect(textNow()).toBe(text);
});
