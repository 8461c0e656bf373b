import { expect, test } from "vitest";
import type { HandedResult, TaskResult } from "../../../course/made/result.ts";
import { hasResult, learnerCount, resultRows, sortedRows, type RerunOutcome, type LearnerFile } from "./result-rows.ts";

const task = (id: string, more: Partial<TaskResult> = {}): TaskResult => ({
  id,
  title: `Task ${id}`,
  tries: 2,
  hints: 0,
  solution: false,
  passed: null,
  seconds: null,
  score: null,
  worked: 97,
  steps: 13,
  program: null,
  verdict: null,
  ...more,
});
const ada: HandedResult = {
  format: "turnwise-result/1",
  name: "Ada",
  made: 1_795_000_000_123,
  tasks: [task("pin", { tries: 11 }), task("disc")],
};
const none: HandedResult = { ...ada, name: "", tasks: [] };
const zoe: HandedResult = {
  ...ada,
  name: "zoé",
  tasks: [task("pin", { seconds: 61.7, passed: { way: "alone", when: 7 } })],
};

const inFiles = (...all: readonly HandedResult[]): readonly LearnerFile[] =>
  all.map((result, i) => ({ file: `${i}.json`, result }));
const compare = (a: string, b: string) => a.localeCompare(b, "en");

test("rows of several learners are sorted by any column, or in order of arrival", () => {
  const rows = resultRows(inFiles(zoe, none, ada));
  const again = new Map<string, RerunOutcome>([
    ["0 pin", "fails"],
    ["2 disc", "passes"],
  ]);
  const order = (column: Parameters<typeof sortedRows>[1], down = false) =>
    sortedRows(rows, column, down, { again, compare }).map(({ name, result }) => `${name} ${result.id}`);
  expect(order(null)).toEqual(["zoé pin", "Ada pin", "Ada disc"]);
  expect(order("name")).toEqual(["Ada pin", "Ada disc", "zoé pin"]);
  expect(order("name", true)).toEqual(["zoé pin", "Ada pin", "Ada disc"]);
  expect(order("tries", true)[0]).toBe("Ada pin");
  expect(order("machining")[0]).toBe("zoé pin");
  expect(order("state")[0]).toBe("zoé pin");
  expect(order("again")).toEqual(["Ada disc", "zoé pin", "Ada pin"]);
  expect(resultRows(inFiles(none))).toEqual([]);
});

test("if a learner handed a task in twice the newest counts and the others stay; each result without a name is another learner", () => {
  const later = { ...ada, name: " ada  ", made: ada.made + 7, tasks: [task("disc", { tries: 5 }), task("bush")] };
  const all = inFiles(later, ada, zoe, { ...none, tasks: [task("pin")] }, { ...none, tasks: [task("pin")] });
  expect(learnerCount(all)).toBe(4);
  expect(resultRows(all).map(({ key, earlier }) => `${key}${earlier ? " earlier" : ""}`)).toEqual([
    "0 disc",
    "0 bush",
    "1 pin",
    "1 disc earlier",
    "2 pin",
    "3 pin",
    "4 pin",
  ]);
  // Of two of the same moment one counts, and only one.
  expect(
    resultRows(inFiles(ada, { ...ada, tasks: [task("pin", { tries: 12 })] })).map(({ earlier }) => earlier),
  ).toEqual([true, false, false]);
});

test("the same file is recognised", () => {
  expect(hasResult(inFiles(ada, zoe), { ...zoe })).toBe(true);
  expect(hasResult(inFiles(ada), { ...ada, made: ada.made + 1 })).toBe(false);
});
