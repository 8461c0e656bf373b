import { expect, test } from "vitest";
import { RESULT_FORMAT, type HandedResult } from "./made/result.ts";
import {
  beginExam,
  canBegin,
  checksLeft,
  endOfExam,
  examOfTask,
  mergedExams,
  seenAt,
  timeLeft,
  withCheck,
} from "./exam.ts";
import { SET_FORMAT, setSchema, type TaskSet } from "./task-set.ts";
import { TASK_FORMAT } from "./task.ts";

const START = 1_795_000_000_000,
  MINUTE = 60_000;
const set = (more: object = {}): TaskSet =>
  setSchema.parse({
    format: SET_FORMAT,
    id: "set-a1",
    words: { en: { title: "S" } },
    tasks: [
      {
        format: TASK_FORMAT,
        id: "pin-a1",
        kind: "make",
        start: { empty: true },
        words: { en: { title: "A", ask: "B" } },
      },
    ],
    exam: { reports: "goals", minutes: 45, tries: 2 },
    ...more,
  });
const begun = (more: object = {}) => beginExam(set(more), " Ada ", "MT 2", START);
const failed = { passed: false, met: 1, of: 4 };

test.each([
  ["its minutes", {}, START + 45 * MINUTE],
  ["its due date, if that is earlier", { due: START + 7 * MINUTE }, START + 7 * MINUTE],
  ["its minutes, if they are earlier", { due: START + 90 * MINUTE }, START + 45 * MINUTE],
  ["its due date without minutes", { due: START + 9 * MINUTE, exam: { reports: "passed" } }, START + 9 * MINUTE],
  ["nothing", { exam: { reports: "passed" } }, null],
])("an exam ends by %s", (_, more, end) => expect(endOfExam(begun(more))).toBe(end));

test("time runs down to zero, and a clock that is set back gains nothing", () => {
  const exam = seenAt(begun(), START + 30 * MINUTE);
  expect(timeLeft(exam, START + 31 * MINUTE)).toBe(14 * MINUTE);
  expect(timeLeft(exam, START - 99 * MINUTE)).toBe(15 * MINUTE);
  expect(timeLeft(exam, START + 99 * MINUTE)).toBe(0);
  // Set back while the page is open: time goes on from the latest moment seen.
  expect(timeLeft(exam, START - 99 * MINUTE, 4 * MINUTE)).toBe(11 * MINUTE);
  expect(timeLeft(exam, START - 99 * MINUTE, 16 * MINUTE)).toBe(0);
  expect(seenAt(exam, START - 99 * MINUTE, 4 * MINUTE).seen).toBe(START + 34 * MINUTE);
  expect(seenAt(exam, START)).toBe(exam);
});

test("an exam can be begun until it is due", () => {
  expect([canBegin(set(), START), canBegin(set({ due: START }), START - 1)]).toEqual([true, true]);
  expect(canBegin(set({ due: START }), START)).toBe(false);
});

test("checks are counted down for each task, with how the last one went", () => {
  const exam = withCheck(withCheck(begun(), "pin-a1", { ...failed, met: 3 }), "pin-a1", failed);
  expect([checksLeft(begun(), "pin-a1"), checksLeft(exam, "pin-a1"), checksLeft(exam, "disc-a1")]).toEqual([2, 0, 2]);
  expect(exam.checks["pin-a1"]).toEqual({ ...failed, count: 2 });
  expect(checksLeft(begun({ exam: { reports: "passed" } }), "pin-a1")).toBeNull();
  expect([examOfTask({ x: exam }, "pin-a1"), examOfTask({ x: exam }, "pin")]).toEqual([exam, undefined]);
});

test("two records of an exam give no second start, no more checks, and what was handed in first", () => {
  const result = (made: number): HandedResult => ({ format: RESULT_FORMAT, name: "Ada", made, tasks: [] });
  const later = { ...begun(), begun: START + 5 * MINUTE, ended: { by: "learner" as const, result: result(9) } };
  const mine = { ...withCheck(begun(), "pin-a1", failed), ended: { by: "time" as const, result: result(7) } };
  for (const [a, b] of [
    [mine, later],
    [later, mine],
  ] as const) {
    const both = mergedExams({ x: a }, { x: b, y: begun() });
    expect(both["x"]).toMatchObject({ begun: START, ended: { by: "time" }, checks: { "pin-a1": { count: 1 } } });
    expect(both["y"]).toEqual(begun());
  }
});
