import { expect, test } from "vitest";
import { cycleByNumber } from "../cycles/index.ts";
import { message } from "../i18n/message.ts";
import { ncLabels } from "../i18n/nc-labels.ts";
import { issue } from "../kernel/plan/issue.ts";
import { parse } from "../nc/parse.ts";
import { exampleJob } from "../program/job/job.ts";
import { printJob } from "../program/job/print-job.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { simulate } from "../sim/simulate.ts";
import { joinPlaces, operationKey } from "./places.ts";
import { report } from "./report.ts";

const stays = (x: number, area: number, work = "7", reason: "mainEdge" | "cutLength" = "mainEdge") => ({
  issue: issue("materialLeft", "warning", { reason, area, x, z: -5 }),
  work,
});

test("places of one kind at one piece of work are one finding with a count, at the first of them", () => {
  const found = joinPlaces([stays(40, 1), stays(30, 2), stays(20, 4, "9"), stays(10, 8, "7", "cutLength")]);
  expect(found.map((each) => each.issue.data)).toEqual([
    { reason: "mainEdge", area: 3, x: 40, z: -5, places: 2 },
    {
      reason: "mainEdge",
      area: 4,
      x: 20,
      z: -5,
    },
    { reason: "cutLength", area: 8, x: 10, z: -5 },
  ]);
  expect(found.map(({ issue: { data } }) => "places" in data && data.places)).toEqual([2, false, false]);
});

test("intended cuts are one finding with their blocks and total area, whatever their blocks", () => {
  const cut = (block: number, area: number) => ({
    issue: issue("intendedCut", "info", { blocks: [block], area, x: 20, z: -block }),
    work: String(block),
  });
  const found = joinPlaces([cut(17, 2), stays(40, 1), cut(31, 3), cut(31, 4)]);
  expect(found.map((each) => each.issue.data)).toEqual([
    { blocks: [17, 31], area: 9, x: 20, z: -17, places: 3 },
    { reason: "mainEdge", area: 1, x: 40, z: -5 },
  ]);
});

test("a few places are listed one by one where the list has a mark for each", () => {
  expect(joinPlaces([stays(40, 1), stays(30, 2)], 2)).toHaveLength(2);
  expect(joinPlaces([stays(40, 1), stays(30, 2), stays(20, 4)], 2)).toHaveLength(1);
});

test("findings of one code with different data stay separate: a parameter value is no place", () => {
  const deep = (infeed: number) => ({
    issue: issue("infeedOverCutLength", "warning", { infeed, cutLength: 4 }, "Q463"),
    work: "7",
  });
  expect(joinPlaces([deep(5), deep(6), deep(5)]).map((each) => each.issue.data)).toEqual([
    { infeed: 5, cutLength: 4, places: 2 },
    {
      infeed: 6,
      cutLength: 4,
    },
  ]);
});

test("a loop over a call is one piece of work, two definitions at one call are two", () => {
  const call = { block: 20, cycle: 861, definedLine: 9 };
  expect(operationKey(call, call)).toBe(operationKey({ block: 20 }, { ...call }));
  expect(operationKey(call, call)).not.toBe(operationKey(call, { ...call, definedLine: 14 }));
});

test.each([
  ["en", "X⌀40 Z-5 and 1 more place"],
  ["de", "X⌀40 Z-5 und einer weiteren Stelle"],
] as const)("%s: the text names the first place and counts the others", (language, words) => {
  const [joined] = joinPlaces([stays(40, 1), stays(30, 2)]);
  expect(joined && message(language, joined.issue)).toContain(words);
});

test("the report of a thread lists the residue between its grooves once", () => {
  const text = printJob(exampleJob(cycleByNumber(832) as never), ncLabels("en"));
  const ran = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  const checked = {
    file: "t.h",
    run: ran,
    simulation: simulate(ran),
    milliseconds: { parse: 0, plan: 0, simulate: 0 },
  };
  const { issues, operations, proof } = report(checked, "en");
  const left = issues.filter(({ code }) => code === "materialLeft");
  expect(left).toHaveLength(1);
  expect(left[0]?.data).toMatchObject({ places: 17, area: expect.closeTo(1.421, 3) });
  expect(proof.residual.length).toBe(17);
  expect(operations[0]?.issues).toContainEqual(left[0]);
});
