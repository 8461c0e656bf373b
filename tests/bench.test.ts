import { runInNewContext } from "node:vm";
import { expect, test } from "vitest";
import { readOptions } from "../scripts/browser-bench/options.ts";
import { grownProgram } from "../scripts/large-programs.ts";
import { markdownTable } from "../scripts/performance-page.ts";
import { middle, referenceWork } from "../scripts/reference.ts";
import { parse } from "../src/nc/parse.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";

test("the reference loop is the same every time, also as text in another place", () => {
  const once = referenceWork();
  expect(once).not.toBe(0);
  expect(referenceWork()).toBe(once);
  expect(runInNewContext(`(${String(referenceWork)})()`)).toBe(once);
});

test("the median of numbers in any order", () => {
  expect(middle([7.25, 0.5, 11])).toBe(7.25);
  expect(middle([7.5, 0.5, 11, 2.25])).toBe(4.875);
  expect(middle([])).toBeNaN();
});

test("a case of the browser bench is selected by its name or by a part of it", () => {
  const names = (args: string[]) => readOptions(args).screens.map(({ name }) => name);
  expect(names(["--screen=1440x900"])).toEqual(["1440x900"]);
  expect(names(["--screen=slow"])).toEqual(["1440x900 slow", "1024x768 slow", "768x1024 slow"]);
  const { works, cases, rounds } = readOptions(["--work=flange,812", "--case=10x", "--rounds=7", "--quick"]);
  expect([works.map(({ name }) => name), cases, rounds]).toEqual([["flange", "812"], ["10x"], 7]);
  expect(() => readOptions(["--work=shaft"])).toThrow("none of: flange, 812");
  expect(() => readOptions(["--fast"])).toThrow("--fast is not understood");
  expect(() => readOptions(["--seconds=none"])).toThrow("above zero");
});

test("a grown program has the requested operations and about the requested moves", () => {
  const made = run(parse(grownProgram(7, 1130)), { tools: shippedTools, rapid: 10_000 });
  expect(made.operations).toHaveLength(7);
  expect(made.issues.filter(({ issue }) => issue.severity === "error")).toEqual([]);
  expect(Math.abs(made.steps.length - 1130)).toBeLessThan(7 * 10);
});

test("columns of words begin, columns of numbers end at one line", () => {
  expect(
    markdownTable(
      1,
      ["", "ms"],
      [
        ["update 812", "9.5"],
        ["plan", "10.25"],
      ],
    ),
  ).toEqual(["|            |    ms |", "|------------|------:|", "| update 812 |   9.5 |", "| plan       | 10.25 |"]);
});
