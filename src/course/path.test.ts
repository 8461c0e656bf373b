import { describe, expect, test } from "vitest";
import type { CoursePath } from "./outline.ts";
import { lessonAfter, lessonsOnPath, lessonToContinue, missedIn, passedOf, nextStep, stateOfLesson } from "./path.ts";
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
  const CHAPTERS = [{ lessons: ["axes", "tool"] }, { lessons: ["speed", "bores"] }];
  /** The day after every pass and answer of these tests that is not said to be of that day. */
  const TODAY = 100;
  const step = (progress: CourseProgress, end: string | null, lessons = LESSONS) => {
    const [lesson = "", task] = end?.split(" ") ?? [];
    const from = end === null ? null : { lesson, ...(task !== undefined && { task }) };
    const next = nextStep({ lessons, all: LESSONS, chapters: CHAPTERS }, progress, TODAY, from);
    if (next?.kind === "review") return `review ${next.missed.length}, ${next.lesson?.id ?? "end"}`;
    return next && (next.kind === "task" ? next.task.id : `lesson ${next.lesson.id}`);
  };
  const missedOn = (progress: CourseProgress, when: number) => withAnswer(progress, "axes", "sign", false, when);
  const helpedOn = (progress: CourseProgress, task: string, when: number) =>
    withPass(withHint(progress, task, 1), task, { when });
  const axesDone = at(passed("a1", "a2", "a3"), "axes");
  const chapterDone = at(withPass(axesDone, "t1", { when: 7 }), "tool");
  const allDone = LESSONS.reduce((p, { id }) => at(p, id), passed("a1", "a2", "a3", "t1", "b1", "b2"));

  test.each([
    // Nothing was missed: the exercises of a lesson in turn, then the next lesson that is not done.
    ["lesson axes", null, NO_PROGRESS],
    ["a1", "axes", NO_PROGRESS],
    ["a2", "axes a1", passed("a1")],
    ["a1", "axes a3", passed("a3", "a2")],
    ["lesson tool", "axes a2", passed("a1", "a2", "a3")],
    ["lesson tool", "axes", axesDone],
    ["lesson speed", "axes", chapterDone],
    ["lesson speed", "tool t1", chapterDone],
    ["lesson speed", null, chapterDone],
    [null, "bores b2", passed("b1", "b2")],
    [null, null, allDone],
    [null, "own-pin", NO_PROGRESS],
    // Missed on the same day: the review waits for the end of a chapter, and comes no more in the next one.
    ["a2", "axes a1", missedOn(passed("a1"), TODAY)],
    ["lesson tool", "axes", missedOn(axesDone, TODAY)],
    ["lesson tool", null, missedOn(axesDone, TODAY)],
    ["review 1, speed", "tool", missedOn(chapterDone, TODAY)],
    ["review 1, speed", "tool t1", missedOn(chapterDone, TODAY)],
    ["review 1, speed", null, missedOn(chapterDone, TODAY)],
    ["review 2, speed", null, missedOn(helpedOn(at(axesDone, "tool"), "t1", TODAY), TODAY)],
    ["review 1, speed", "axes a2", missedOn(chapterDone, TODAY)],
    ["lesson speed", null, withAnswer(missedOn(chapterDone, TODAY), "axes", "sign", true, TODAY)],
    ["lesson speed", null, at(missedOn(chapterDone, TODAY), "speed", 1)],
    ["lesson bores", "speed", at(missedOn(chapterDone, TODAY), "speed")],
    ["review 1, end", null, missedOn(allDone, TODAY)],
    ["review 1, end", "bores b2", missedOn(passed("b1", "b2"), TODAY)],
    // Missed on an earlier day, or on a day that is not known: the review comes first, but within no lesson.
    ["a2", "axes a1", missedOn(passed("a1"), TODAY - 1)],
    ["review 1, tool", "axes", missedOn(axesDone, TODAY - 1)],
    ["review 1, axes", null, missedOn(at(NO_PROGRESS, "axes", 2), TODAY - 1)],
    ["review 1, tool", null, missedOn(axesDone, 0)],
    ["review 1, tool", null, helpedOn(at(passed("a1", "a2"), "axes"), "a3", TODAY - 1)],
    ["lesson tool", null, helpedOn(at(passed("a1", "a2"), "axes"), "a3", TODAY)],
    ["review 2, tool", null, missedOn(helpedOn(at(passed("a1", "a2"), "axes"), "a3", TODAY), TODAY - 1)],
  ] as const)("is %s at the end of %s (%#)", (next, end, progress) => expect(step(progress, end)).toBe(next));

  test("follows the path", () => {
    const short = [...lessonsOnPath(LESSONS, PATH)];
    expect(step(passed("a1"), "axes a1", short)).toBe("a3");
    expect(step(passed("a1", "a3"), "axes a3", short)).toBe("lesson bores");
    expect(step(missedOn(passed("a1", "a3"), TODAY), "axes a3", short)).toBe("review 1, bores");
    expect(step(passed("a1", "a3", "b2"), "bores b2", short)).toBeNull();
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
    withAnswer(withAnswer(aided, "bores", "side", false, 8), "axes", "sign", false, 8),
    "axes",
    "zero",
    true,
    8,
  );
  expect(missed(withAnswer(wrong, "axes", "gone", false, 8))).toEqual(["axes sign 3", "a2", "bores side 2"]);
  const repeated = withPass(withStart(withAnswer(wrong, "bores", "side", true, 8), "a2"), "a2", { when: 11 });
  expect(missed(repeated)).toEqual(["axes sign 3"]);
});
