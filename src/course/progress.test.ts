import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  answerToQuestion,
  isEmptyProgress,
  mergedProgress,
  needsRepeat,
  NO_PROGRESS,
  progressOfTask,
  progressShape,
  shownHelp,
  stateOfTask,
  withAnswer,
  withHint,
  withPass,
  withPlace,
  withSolution,
  withStart,
  withTry,
  type CourseProgress,
} from "./progress.ts";

const state = (progress: CourseProgress, task = "q463") => stateOfTask(progressOfTask(progress, task));

describe("how a task was passed", () => {
  test("not begun, tried, unaided, with hints, with the solution", () => {
    expect(state(NO_PROGRESS)).toBe("new");
    const tried = withTry(NO_PROGRESS, "q463");
    expect(state(tried)).toBe("tried");
    expect(state(tried, "other")).toBe("new");
    expect(state(withPass(tried, "q463", { when: 17 }))).toBe("alone");
    expect(state(withHint(NO_PROGRESS, "q463", 1))).toBe("tried");
    expect(state(withPass(withHint(tried, "q463", 2), "q463", { when: 17 }))).toBe("hints");
    expect(state(withPass(withSolution(withHint(tried, "q463", 3), "q463"), "q463", { when: 17 }))).toBe("solution");
  });

  test("hints shown after passing change nothing", () => {
    const alone = withPass(NO_PROGRESS, "q463", { when: 17, seconds: 61.25 });
    const later = withPass(withSolution(withHint(alone, "q463", 3), "q463"), "q463", {
      when: 99,
      seconds: 48.5,
      score: 71,
    });
    expect(progressOfTask(later, "q463")).toMatchObject({
      passed: { way: "alone", when: 17 },
      seconds: 48.5,
      score: 71,
    });
    expect(progressOfTask(withPass(later, "q463", { when: 120, seconds: 52, score: 64 }), "q463")).toMatchObject({
      seconds: 48.5,
      score: 71,
    });
  });

  test("a hint stays shown", () =>
    expect(progressOfTask(withHint(withHint(NO_PROGRESS, "q463", 3), "q463", 1), "q463").hints).toBe(3));

  test("a JavaScript property name is an ordinary task id", () =>
    expect(state(NO_PROGRESS, "constructor")).toBe("new"));
});

describe("a repeated attempt", () => {
  const help = (progress: CourseProgress) => shownHelp(progressOfTask(progress, "q463"));
  const due = (progress: CourseProgress) => needsRepeat(progressOfTask(progress, "q463"));
  const aided = withPass(withSolution(withHint(NO_PROGRESS, "q463", 2), "q463"), "q463", { when: 17 });

  test("is needed after a pass with help, and only then", () => {
    expect(due(NO_PROGRESS)).toBe(false);
    expect(due(withHint(NO_PROGRESS, "q463", 2))).toBe(false);
    expect(due(withPass(NO_PROGRESS, "q463", { when: 17 }))).toBe(false);
    expect(due(aided)).toBe(true);
  });

  test("begins with all help covered; the first attempt stays as it was", () => {
    const begun = withStart(aided, "q463");
    expect(help(aided)).toEqual({ hints: 2, solution: true });
    expect(help(begun)).toEqual({ hints: 0, solution: false });
    const passed = withPass(begun, "q463", { when: 23 });
    expect([due(passed), state(passed)]).toEqual([false, "alone"]);
    expect(progressOfTask(passed, "q463").passed).toEqual({ way: "solution", when: 17 });
    expect(withStart(passed, "q463")).toBe(passed);
  });

  test("with help again is needed once more", () => {
    const begun = withStart(aided, "q463");
    for (const again of [withHint(begun, "q463", 1), withSolution(begun, "q463")]) {
      expect(due(withPass(again, "q463", { when: 23 }))).toBe(true);
      expect(due(withPass(withStart(withPass(again, "q463", { when: 23 }), "q463"), "q463", { when: 29 }))).toBe(false);
    }
  });

  test("starting over before a pass uncovers and covers nothing", () => {
    const hinted = withHint(NO_PROGRESS, "q463", 2);
    expect(withStart(hinted, "q463")).toBe(hinted);
  });
});

test("the last answer to a question counts, and all are counted", () => {
  const wrong = withAnswer(NO_PROGRESS, "tool", "nose", false, 5);
  expect(answerToQuestion(wrong, "tool", "nose")).toEqual({ last: "wrong", answers: 1, when: 5 });
  expect(answerToQuestion(withAnswer(wrong, "tool", "nose", true, 6), "tool", "nose")).toEqual({
    last: "right",
    answers: 2,
    when: 6,
  });
  expect(answerToQuestion(wrong, "tool", "edge")).toBeUndefined();
  expect(answerToQuestion(wrong, "constructor", "name")).toBeUndefined();
  expect(answerToQuestion(withAnswer(wrong, "tool", "edge", true, 6), "tool", "nose")?.last).toBe("wrong");
});

describe("the place", () => {
  const at = (page: number | "tasks") => ({ lesson: "tool", number: 2, page });
  test("a lesson counts as read when its tasks are reached", () => {
    const third = withPlace(NO_PROGRESS, at(3));
    expect([third.read, third.last]).toEqual([[], at(3)]);
    const end = withPlace(third, at("tasks"));
    expect(end.read).toEqual(["tool"]);
    expect(withPlace(end, at("tasks"))).toBe(end);
    expect(withPlace(end, at(1)).read).toEqual(["tool"]);
  });
});

const ids = fc.constantFrom("a-1", "b-2", "c-3");
const event = fc.oneof(
  fc.record({ does: fc.constant("try" as const), task: ids }),
  fc.record({ does: fc.constant("hint" as const), task: ids, stage: fc.integer({ min: 1, max: 3 }) }),
  fc.record({ does: fc.constant("solution" as const), task: ids }),
  fc.record({
    does: fc.constant("pass" as const),
    task: ids,
    when: fc.integer({ min: 1, max: 9999 }),
    seconds: fc.integer({ min: 3, max: 977 }),
    score: fc.integer({ min: 1, max: 100 }),
  }),
  fc.record({ does: fc.constant("start" as const), task: ids }),
  fc.record({
    does: fc.constant("answer" as const),
    lesson: ids,
    question: ids,
    isRight: fc.boolean(),
    when: fc.integer({ min: 1, max: 9999 }),
  }),
  fc.record({ does: fc.constant("read" as const), lesson: ids, page: fc.constantFrom(1, 4, "tasks" as const) }),
);
type Event = typeof event extends fc.Arbitrary<infer E> ? E : never;
function after(progress: CourseProgress, each: Event): CourseProgress {
  switch (each.does) {
    case "try":
      return withTry(progress, each.task);
    case "hint":
      return withHint(progress, each.task, each.stage);
    case "solution":
      return withSolution(progress, each.task);
    case "pass":
      return withPass(progress, each.task, each);
    case "start":
      return withStart(progress, each.task);
    case "answer":
      return withAnswer(progress, each.lesson, each.question, each.isRight, each.when);
    case "read":
      return withPlace(progress, { lesson: each.lesson, number: 7, page: each.page });
  }
}
const made = fc.array(event, { maxLength: 12 }).map((events) => events.reduce(after, NO_PROGRESS));
const RANK = ["alone", "hints", "solution", "tried", "new"];

describe("imported progress", () => {
  test("is at least as good as either side, and a second import changes nothing", () =>
    fc.assert(
      fc.property(made, made, (mine, brought) => {
        const both = mergedProgress(mine, brought);
        for (const task of ["a-1", "b-2", "c-3"]) {
          const [here, there, now] = [mine, brought, both].map((p) => progressOfTask(p, task));
          expect(RANK.indexOf(state(both, task))).toBe(
            Math.min(RANK.indexOf(state(mine, task)), RANK.indexOf(state(brought, task))),
          );
          expect(now?.tries).toBe(Math.max(here?.tries ?? 0, there?.tries ?? 0));
          expect(now?.seconds ?? Infinity).toBe(Math.min(here?.seconds ?? Infinity, there?.seconds ?? Infinity));
          expect(now?.score ?? 0).toBe(Math.max(here?.score ?? 0, there?.score ?? 0));
          expect(now?.repeated).toBe(here?.repeated || there?.repeated);
          for (const lesson of ["a-1", "b-2", "c-3"]) {
            const [my, their, is] = [mine, brought, both].map((p) => answerToQuestion(p, lesson, task));
            const isRight = my?.last === "right" || their?.last === "right";
            expect(is?.last).toBe(my || their ? (isRight ? "right" : "wrong") : undefined);
            expect(is?.answers ?? 0).toBe(Math.max(my?.answers ?? 0, their?.answers ?? 0));
          }
        }
        expect(both.read).toEqual(expect.arrayContaining([...mine.read, ...brought.read]));
        expect(both.last).toEqual(mine.last ?? brought.last);
        expect(mergedProgress(both, brought)).toEqual(both);
      }),
    ));

  test("stored progress is read again; damaged progress is not", () => {
    fc.assert(
      fc.property(made, (progress) => {
        expect(progressShape.parse(JSON.parse(JSON.stringify(progress)))).toEqual(progress);
      }),
    );
    for (const bad of [
      "[]",
      '{"version":2,"tasks":{},"read":[],"last":null}',
      '{"version":1,"tasks":{"a":{}},"read":[],"last":null}',
    ])
      expect(progressShape.safeParse(JSON.parse(bad)).success, bad).toBe(false);
  });

  test("progress of a version without questions and paths is read", () =>
    expect(progressShape.parse({ version: 1, tasks: {}, read: ["tool"], last: null })).toEqual({
      ...NO_PROGRESS,
      read: ["tool"],
    }));

  test("only untouched progress is empty", () => {
    expect(isEmptyProgress(NO_PROGRESS)).toBe(true);
    expect(isEmptyProgress(withTry(NO_PROGRESS, "a-1"))).toBe(false);
    expect(isEmptyProgress(withAnswer(NO_PROGRESS, "tool", "nose", true, 6))).toBe(false);
    expect(isEmptyProgress(withPlace(NO_PROGRESS, { lesson: "tool", number: 2, page: 1 }))).toBe(false);
  });
});
