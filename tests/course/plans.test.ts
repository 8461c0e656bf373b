import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { drawnTask } from "../../src/course/drawn-task.ts";
import { answerOf } from "../../src/course/judge/answer.ts";
import { partOfDrawn } from "../../src/course/part-of-drawn.ts";
import {
  betterOf,
  comparingPlans,
  type Achieved,
  type PlanComparison,
} from "../../src/course/plans/plan-comparison.ts";
import { programOperations } from "../../src/course/plans/program-operations.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { taskSchema } from "../../src/course/task.ts";
import { planOf, requestOf } from "../planning/plan-laws.ts";

const taskOf = (id: string) =>
  taskSchema.parse(JSON.parse(readFileSync(new URL(`../../src/course/tasks/${id}.json`, import.meta.url), "utf8")));
const task = taskOf("l26-bearing-flange");
const drawn = drawnTask(task),
  part = drawn && partOfDrawn(drawn, { name: "FLANGE", material: "c45" }),
  request = part && requestOf(part);
if (!request) throw new Error("no part");
const plan = planOf(request);
const solution = programOfLines(task.solution ?? []);

function compared(text: string): PlanComparison {
  const comparing = comparingPlans(task, answerOf(text), plan, request as NonNullable<typeof request>);
  for (;;) {
    const next = comparing.next();
    if (next.done) return next.value;
  }
}
/** A program with one change, which has to be in it. */
function changed(text: string, from: string, to: string): string {
  expect(text).toContain(from);
  return text.replace(from, to);
}
const keyOf = (op: { cycle: number | null; tool: number }) => `${op.cycle} T${op.tool}`;

describe("the plan of the solution beside that of the planner", () => {
  const { own, planned, rows } = compared(solution);

  test("both make the part", () => {
    expect([own.achieved.missed, planned.achieved.missed]).toEqual([[], []]);
    expect([own.achieved.left, planned.achieved.left].every((left) => left < 0.05)).toBe(true);
  });

  test("the rows have every operation of both plans once", () => {
    const sorted = (all: readonly number[]) => all.toSorted((a, b) => a - b);
    expect(sorted(rows.flatMap((row) => row.own))).toEqual(own.operations.map((_, i) => i));
    expect(sorted(rows.flatMap((row) => row.other))).toEqual(planned.steps.map((_, i) => i));
    // Whatever the operations are called: rough with rough, bore with bore.
    expect(rows.every((row) => row.own.length === 1 && row.other.length === 1)).toBe(true);
  });

  test("the times of the operations are that of the program", () => {
    const sum = own.operations.reduce((all, { seconds }) => all + seconds, 0);
    expect(sum).toBeCloseTo(own.achieved.seconds, 1);
  });

  test("each difference was tried, and the trial makes the part", () => {
    for (const { tried } of rows) {
      expect(tried.filter(({ kind }) => kind === "way").length).toBe(1);
      for (const { missed, left } of tried) expect([missed, left < 0.05]).toEqual([[], true]);
    }
  });

  test("one tool fewer saves its change", () => {
    const [face] = rows;
    expect(face).toMatchObject({ isSameTool: false, isSameCycle: true });
    expect(face?.tried[0]?.changes).toBe(own.achieved.changes - 1);
    expect(betterOf(own.achieved, face?.tried[0] as Achieved)).toBe("other");
  });
});

test("the program of the planner beside its plan has no difference", () => {
  const { rows, own, planned } = compared(plan.text);
  expect(own.operations.map(keyOf)).toEqual(
    planned.steps.map(({ tried: { action } }) => keyOf({ cycle: action.cycle, tool: action.tool.T })),
  );
  for (const { tried, moved, isSameTool, isSameCycle } of rows)
    expect({ tried, moved, isSameTool, isSameCycle }).toEqual({
      tried: [],
      moved: null,
      isSameTool: true,
      isSameCycle: true,
    });
});

test("where the learner is faster, the learner's way is better", () => {
  const { own, rows } = compared(changed(plan.text, "Q478=+0.3 ", "Q478=+0.5 "));
  const [tried] = rows.flatMap((row) => row.tried);
  expect(rows.flatMap((row) => row.tried).length).toBe(1);
  expect(betterOf(own.achieved, tried as Achieved)).toBe("own");
});

test.each<[what: string, own: Partial<Achieved>, other: Partial<Achieved>, better: ReturnType<typeof betterOf>]>([
  ["the same", {}, {}, "same"],
  ["half a second", {}, { seconds: 99.6 }, "same"],
  ["faster", {}, { seconds: 90 }, "other"],
  ["slower", {}, { seconds: 110 }, "own"],
  ["slower and cleaner", { left: 0.4 }, { seconds: 110 }, "other"],
  ["faster with residual material", {}, { seconds: 80, left: 0.4 }, "own"],
  ["a sliver less", { left: 0.04 }, { seconds: 110 }, "own"],
  ["a goal less, however fast", {}, { seconds: 1, missed: [{ kind: "safe" }] }, "own"],
  ["a goal more", { missed: [{ kind: "clean" }] }, { seconds: 300, left: 2 }, "other"],
])("%s", (_, own, other, better) => {
  const usual: Achieved = { seconds: 100, changes: 3, tools: [1], left: 0, missed: [] };
  expect(betterOf({ ...usual, ...own }, { ...usual, ...other })).toBe(better);
});

describe("the operations of a program", () => {
  const of = (text: string) => programOperations(answerOf(text), 10);

  test("are those of its cycles, with the stock that each takes", () => {
    const found = of(solution);
    expect(found.map(keyOf)).toEqual(["821 T15", "810 T1", "810 T5", "810 T3", "810 T6"]);
    expect(found.every(({ cut }) => cut > 5)).toBe(true);
    expect(found[1]?.values).toMatchObject({ Q463: 3, Q478: 0.3, speed: 200, limit: 2500 });
  });

  test("are there without a cycle, too, and for a thread its stretch", () => {
    const byHand = of(programOfLines(taskOf("l01-turn-by-hand").solution ?? []));
    expect(byHand.map(({ cycle }) => cycle)).toEqual([null]);
    expect(byHand[0]?.cut).toBeGreaterThan(1);
    const spindle = of(programOfLines(taskOf("l26-valve-spindle").solution ?? []));
    expect(spindle.at(-1)).toMatchObject({ taken: [], thread: { isInside: false } });
    expect(spindle.at(-1)?.thread?.rear).toBeLessThan(-20);
  });

  test("none in an empty program", () => {
    const { rows, own } = compared(`BEGIN PGM A MM\n${(task.part?.blank ?? []).join("\n")}\nEND PGM A MM\n`);
    expect(own.operations).toEqual([]);
    expect(rows.flatMap(({ tried }) => tried)).toEqual([]);
  });
});
