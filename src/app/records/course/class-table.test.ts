import { expect, test } from "vitest";
import type { HandedResult, TaskResult } from "../../../course/made/result.ts";
import { classTable, filteredRows, sortedLearners, type ClassSort } from "./class-table.ts";
import { resultRows, type Rerun } from "./result-rows.ts";

const task = (id: string, more: Partial<TaskResult> = {}): TaskResult => ({
  id,
  title: `Task ${id}`,
  tries: 1,
  hints: 0,
  solution: false,
  passed: null,
  seconds: null,
  score: null,
  worked: 9,
  steps: 3,
  program: "x",
  verdict: null,
  ...more,
});
const DUE = 1_795_000_000_000;
const set = { id: "set-a1", title: "Test 1", due: DUE };
const handed = (name: string, tasks: TaskResult[], more: Partial<HandedResult> = {}): HandedResult => ({
  format: "turnwise-result/1",
  name,
  made: DUE - 1,
  tasks,
  ...more,
});
const passed = { way: "hints", when: 7 } as const;
const files = [
  handed("Zoe", [task("pin", { passed }), task("disc")], { group: "MT 2", set }),
  handed("Ada", [task("pin"), task("disc")], { group: "mt 2", made: DUE + 600_000, set }),
  handed("Bo", [task("pin", { tries: 0, program: null })], { exam: { begun: 3, by: "time" } }),
  handed("Cy", [task("disc")]),
].map((result, i) => ({ file: `${i}`, result }));
const missed = (...goals: Rerun["missed"]): Rerun => ({ is: "fails", missed: goals });
const reruns = new Map<string, Rerun>([
  ["0 pin", { is: "passes", missed: [] }],
  ["0 disc", missed("size", "residue")],
  ["1 pin", { is: "passes", missed: [] }],
  ["1 disc", missed("size")],
  ["2 pin", { is: "none", missed: [] }],
]);
const rows = resultRows(files);
const table = classTable(rows, reruns);
const compare = (a: string, b: string) => a.localeCompare(b, "en");

test("each learner has a cell for each task: the run here decides, and the device knows the help", () => {
  expect(
    table.learners.map(({ name, cells, passed: all }) => [name, all, ...cells.map((cell) => cell?.state)]),
  ).toEqual([
    ["Zoe", 1, "hints", "failed"],
    ["Ada", 1, "passed", "failed"],
    ["Bo", 0, "new", undefined],
    ["Cy", 0, undefined, "pending"],
  ]);
  expect(table.learners.map(({ late, timeOut }) => [late, timeOut])).toEqual([
    [false, false],
    [true, false],
    [false, true],
    [false, false],
  ]);
});

test("each task says how many passed of those who handed it in, and what the others miss most", () => {
  expect(table.tasks).toEqual([
    { id: "pin", title: "Task pin", passed: 2, of: 3, mostMissed: null },
    { id: "disc", title: "Task disc", passed: 0, of: 3, mostMissed: { goal: "size", learners: 2 } },
  ]);
});

test.each<[ClassSort, boolean, string]>([
  ["name", false, "Ada Bo Cy Zoe"],
  ["name", true, "Zoe Cy Bo Ada"],
  ["passed", true, "Zoe Ada Bo Cy"],
  [0, false, "Zoe Ada Bo Cy"],
  [1, false, "Zoe Ada Cy Bo"],
])("learners are sorted by %s, descending: %s", (by, down, order) =>
  expect(
    sortedLearners(table.learners, by, down, compare)
      .map(({ name }) => name)
      .join(" "),
  ).toBe(order),
);

test.each([
  [{ group: "MT 2" }, "Zoe Zoe Ada Ada"],
  [{ set: "set-a1", name: "AD" }, "Ada Ada"],
  [{ name: "o" }, "Zoe Zoe Bo"],
])("rows are filtered by %j", (some, names) =>
  expect(
    filteredRows(rows, { group: "", set: "", name: "", ...some })
      .map(({ name }) => name)
      .join(" "),
  ).toBe(names),
);
