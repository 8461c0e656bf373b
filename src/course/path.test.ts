import { describe, expect, test } from "vitest";
import type { CoursePath } from "./outline.ts";
import {
  lessonAfter,
  lessonsOnPath,
  lessonToContinue,
  missedIn,
  passedOf,
  stateOfLesson,
  stepAfterTask,
} from "./path.ts";
import { NO_PROGRESS, withAnswer, withHint, withPass, withPlace, withStart, type CourseProgress } from "./progress.ts";

const lesson = (id: string, tasks: readonly string[], questions: readonly string[] = []) => ({
  id,
  tasks: tasks.map((each) => ({ id: each })),
  questions: questions.map((each, i) => ({ id: each, page: i + 2 })),
});
const LESSONS = [
  lesson("axes", ["a1", "a2", "a3"], ["zero", "sign"]),
  lesson("tool", ["t1"]),
  lesson("speed", []),
  lesson("bores", ["b1", "b2"], ["side"]),
];
const PATH: CoursePath = {
  id: "short",
  lessons: [
    { lesson: "axes", tasks: ["a1", "a3"] },
    { lesson: "bores", tasks: ["b2"] },
  ],
};
const passed = (...ids: readonly string[]): CourseProgress =>
  ids.reduce((progress, id) => withPass(progress, id, { when: 7 }), NO_PROGRESS);
const at = (progress: CourseProgress, id: string, page: number | "tasks" = "tasks") =>
  withPlace(progress, { lesson: id, number: 1, page });

test("a path has its lessons with its exercises only; without one the course is whole", () => {
  expect(lessonsOnPath(LESSONS, null)).toBe(LESSONS);
  expect(lessonsOnPath(LESSONS, PATH).map(({ id, tasks }) => [id, tasks.map((task) => task.id)])).toEqual([
    ["axes", ["a1", "a3"]],
    ["bores", ["b2"]],
  ]);
});

test("a total counts the exercises of its lessons, not an instructor's", () => {
  const progress = passed("a1", "a2", "b2", "own-pin");
  expect(passedOf(LESSONS, progress)).toEqual({ passed: 3, of: 6 });
  expect(passedOf(lessonsOnPath(LESSONS, PATH), progress)).toEqual({ passed: 2, of: 3 });
  expect(passedOf([], progress)).toEqual({ passed: 0, of: 0 });
});

describe("a lesson", () => {
  const [axes] = LESSONS;
  test.each([
    ["new", NO_PROGRESS],
    ["begun", at(NO_PROGRESS, "axes", 2)],
    ["begun", at(at(NO_PROGRESS, "axes"), "tool", 1)],
    ["begun", passed("a2")],
    ["begun", passed("a1", "a2", "a3")],
    ["done", at(passed("a1", "a2", "a3"), "axes")],
  ] as const)("is %s", (state, progress) => expect(axes && stateOfLesson(axes, progress)).toBe(state));

  test.each([
    ["the first one at the beginning", "axes", NO_PROGRESS],
    ["the one that is open", "tool", at(at(NO_PROGRESS, "axes"), "tool", 1)],
    ["the next one when that is done", "speed", at(passed("t1"), "tool")],
    ["an earlier one when all later ones are done", "axes", at(passed("b1", "b2"), "bores")],
    [
      "none when all are done",
      undefined,
      LESSONS.reduce((p, { id }) => at(p, id), passed(..."a1 a2 a3 t1 b1 b2".split(" "))),
    ],
  ] as const)("to continue with is %s", (_, id, progress) => expect(lessonToContinue(LESSONS, progress)?.id).toBe(id));
});

describe("the next step", () => {
  const step = (lessons: readonly (typeof LESSONS)[number][], progress: CourseProgress, id: string) => {
    const next = stepAfterTask(lessons, progress, id);
    return next && (next.kind === "task" ? next.task.id : `lesson ${next.lesson.id}`);
  };
  test.each([
    ["a2", "a1", passed("a1")],
    ["a3", "a1", passed("a1", "a2")],
    ["a1", "a3", passed("a3", "a2")],
    ["lesson tool", "a2", passed("a1", "a2", "a3")],
    ["lesson speed", "t1", passed("t1")],
    [null, "b2", passed("b1", "b2")],
    [null, "own-pin", NO_PROGRESS],
  ] as const)("is %s after %s", (next, id, progress) => expect(step(LESSONS, progress, id)).toBe(next));

  test("follows the path", () => {
    const short = lessonsOnPath(LESSONS, PATH);
    expect(step(short, passed("a1"), "a1")).toBe("a3");
    expect(step(short, passed("a1", "a3"), "a3")).toBe("lesson bores");
    expect(step(short, passed("a1", "a3", "b2"), "b2")).toBeNull();
    expect(lessonAfter(short, "axes")?.id).toBe("bores");
    expect(lessonAfter(short, "tool")).toBeNull();
    expect(lessonAfter(LESSONS, "axes")?.id).toBe("tool");
  });
});

test("missed are questions with a wrong last answer and exercises passed with help, until they are repeated", () => {
  const missed = (progress: CourseProgress) =>
    missedIn(LESSONS, progress).map((each) =>
      each.kind === "task" ? each.task.id : `${each.lesson.id} ${each.id} ${each.page}`,
    );
  const aided = withPass(withHint(withPass(NO_PROGRESS, "a1", { when: 7 }), "a2", 1), "a2", { when: 9 });
  const wrong = withAnswer(
    withAnswer(withAnswer(aided, "bores", "side", false), "axes", "sign", false),
    "axes",
    "zero",
    true,
  );
  expect(missed(withAnswer(wrong, "axes", "gone", false))).toEqual(["axes sign 3", "a2", "bores side 2"]);
  const repeated = withPass(withStart(withAnswer(wrong, "bores", "side", true), "a2"), "a2", { when: 11 });
  expect(missed(repeated)).toEqual(["axes sign 3"]);
});
