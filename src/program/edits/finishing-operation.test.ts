import { expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print, type Program } from "../../nc/program.ts";
import { simulate } from "../../sim/simulate.ts";
import { exampleJob } from "../job/job.ts";
import { printJob } from "../job/print-job.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { canBeFinished, finishedOperation } from "./finishing-operation.ts";
import { isRefused } from "./operation-edits.ts";
import { operationsOf } from "./operations.ts";

const example = (number: number): Program => {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  return parse(printJob(exampleJob(cycle), ncLabels("en")));
};
const runOf = (program: Program) => run(program, { tools: shippedTools, rapid: 10_000 });
const finished = (program: Program, tool: number): Program => {
  const made = finishedOperation(program, 0, tool);
  if (isRefused(made)) throw new Error(made.refused);
  return parse(print(made));
};

test.each([
  [812, 3],
  [811, 3],
  [822, 3],
  [862, 10],
  [810, 3],
])("%i: roughing, then finishing with its own tool to the same contour", (number, tool) => {
  const program = finished(example(number), tool);
  const { operations, issues } = runOf(program);
  expect(issues.filter(({ issue }) => issue.severity === "error")).toEqual([]);
  expect(operations.map(({ call }) => call?.values["Q215"])).toEqual([1, 2]);
  expect(operations[1]?.tool.T).toBe(tool);
  expect(operations[1]?.plan.contour).toEqual(operations[0]?.plan.contour);
  expect(operations[0]?.plan.contour).toEqual(runOf(example(number)).operations[0]?.plan.contour);
  expect(operationsOf(program).units).toHaveLength(2);
});

test("a size that is changed once changes both", () => {
  const text = print(finished(example(812), 3));
  const assigned = /\n\d+ (Q\d+ = \+?)50\n/.exec(text);
  expect(assigned).not.toBeNull();
  const changed = runOf(parse(text.replace(`${assigned?.[1]}50\n`, `${assigned?.[1]}47.3\n`)));
  expect(changed.operations.map(({ call }) => call?.values["Q493"])).toEqual([47.3, 47.3]);
  expect(simulate(changed).proof).toBeDefined();
});

test("parameters in use are left alone", () => {
  const used = parse(print(example(812)).replace("M136\n", "M136\n5 Q20 = 7\n"));
  expect(new Set(print(finished(used, 3)).match(/Q20 = .*/g))).toEqual(new Set(["Q20 = 7"]));
});

test("a thread and a finishing operation cannot be finished again", () => {
  const able = (program: Program) => operationsOf(program).units.map((own) => canBeFinished(program, own));
  expect(able(example(831))).toEqual([false]);
  expect(able(example(812))).toEqual([true]);
  expect(able(finished(example(812), 3))).toEqual([true, false]);
});
