import { describe, expect, test } from "vitest";
import { axial, radius } from "../kernel/units.ts";
import { goalsOf, isMet } from "./goals.ts";
import { answerOf } from "./judge/answer.ts";
import { judge } from "./judge/judge.ts";
import { programOfLines } from "./task-start.ts";
import { taskSchema, type Task } from "./task.ts";
import { comparePredictedAnswers, parsePredictedAnswer, typedNumber, typedPlace } from "./predicted-answers.ts";

const files = import.meta.glob<unknown>("./tasks/*.json", { eager: true, import: "default" });
const taskOf = (id: string): Task => taskSchema.parse(files[`./tasks/${id}.json`]);
const begun = ({ start }: Task) => answerOf(programOfLines("program" in start ? start.program : []));

test.each([
  ["4", 4],
  ["-0,35", -0.35],
  ["−7.5", -7.5],
  [" 12. ", 12],
  ["", null],
  ["4a", null],
  ["1e3", null],
  ["1.2.3", null],
])("%j is read as %s", (text, value) => expect(typedNumber(text)).toBe(value));

test("a place is a diameter and Z; below the axis it is the same", () => {
  expect(typedPlace("41,4 -13.2")).toEqual({ z: axial(-13.2), r: radius(20.7) });
  expect(typedPlace("-41.4 -13.2")).toEqual({ z: axial(-13.2), r: radius(20.7) });
  expect(typedPlace("41.4 ")).toBeNull();
  expect(parsePredictedAnswer({ ask: "rapidPlace", within: 3 }, "7")).toBeNull();
  expect(parsePredictedAnswer({ ask: "passes" }, "7")).toBe(7);
});

test("predictions are compared with the run, each by its question", () => {
  const task = taskOf("l03-how-many-passes");
  const answer = begun(task);
  const { passes = 0, infeed = 0 } = answer.run.operations[0]?.plan ?? {};
  const rights = (texts: readonly string[]) => comparePredictedAnswers(task, texts, answer).map(({ right }) => right);
  expect(rights([String(passes), (infeed + 0.015).toFixed(3)])).toEqual([true, true]);
  expect(rights([String(passes), (infeed + 0.031).toFixed(3)])).toEqual([true, false]);
  expect(rights(["", "x"])).toEqual([false, false]);
  expect(rights([])).toEqual([false, false]);
});

describe("goals", () => {
  const task = taskOf("l03-equal-passes");
  const kinds = goalsOf(task).map(({ kind }) => kind);

  test("are the rules of the task, and no contour damage", () =>
    expect(kinds).toEqual(["part", "safe", "depth", "passes"]));

  test("are met one by one", () => {
    const met = (lines: readonly string[]) => {
      const judgement = judge(task, answerOf(programOfLines(lines)));
      return goalsOf(task)
        .filter((goal) => isMet(goal, judgement, []))
        .map(({ kind }) => kind);
    };
    expect(met(task.solution ?? [])).toEqual(kinds);
    expect(met(task.wrong?.[0]?.program ?? [])).toEqual(["part", "safe", "depth"]);
  });

  test("a prediction is a goal of its own, and the only one where nothing is made", () => {
    expect(goalsOf(taskOf("l03-how-many-passes"))).toEqual([
      { kind: "predicted", entry: 0, of: 2 },
      { kind: "predicted", entry: 1, of: 2 },
    ]);
    const [goal] = goalsOf(taskOf("l20-minus"));
    expect(goal && [isMet(goal, null, [true]), isMet(goal, null, [false]), isMet(goal, null, [])]).toEqual([
      true,
      false,
      false,
    ]);
  });
});
