import { describe, expect, test } from "vitest";
import { lessonSchema } from "../../src/course/lesson.ts";
import { taskSchema, type Task } from "../../src/course/task.ts";
import { lessonProblems, taskProblems } from "../../src/course/course-problems.ts";
import { projectFile } from "../sources.ts";

/* The checks of course files must detect faults: the example of the document, broken in one place at a time. */

const [, example = ""] = /```json\n([\s\S]*?)```/.exec(projectFile("docs/tasks.md")) ?? [];
const read = taskSchema.parse(JSON.parse(example));
const whole: Task = { ...read, words: { en: read.words.en, de: read.words.en, fr: read.words.en, zh: read.words.en } };
const problems = (change: Partial<Task>) => taskProblems({ ...whole, ...change }, "tasks/journal-52.json");
const [wrong] = whole.wrong ?? [];
const wordsWith = (more: object): Task["words"] => {
  const words = { ...read.words.en, ...more } as Task["words"]["en"];
  return { en: words, de: words, fr: words, zh: words };
};

describe("a task that ships with the page", () => {
  test("is complete", () => expect(problems({})).toEqual([]));

  test.each([
    ["another name", { id: "other" }, "the id is other"],
    ["a language less", { words: { en: read.words.en, de: read.words.en, zh: read.words.en } }, "no words in fr"],
    ["no solution", { solution: undefined }, "no solution"],
    ["no wrong answer", { wrong: [] }, "no wrong answer"],
    [
      "a part that can not be read",
      { part: { blank: ["BLK FORM CYLINDER Z D60 L90 DIST+0"], outside: ["L X+0", "CR X+9 Z-40 R1 DR+"] } },
      "part: ",
    ],
    ["a solution that is refused", { rules: { depth: 1 } }, "the solution is refused: depth"],
    ["a wrong answer that passes", { rules: {} }, "wrong answer 1 is not refused by depth"],
    ["a wrong answer at another block", { wrong: [{ ...wrong, block: 7 }] }, "wrong answer 1 is not refused by depth"],
    [
      "a wrong answer by another rule",
      { wrong: [{ ...wrong, rule: "missing" }] },
      "wrong answer 1 is not refused by missing",
    ],
    ["a wrong answer without a place", { wrong: [{ ...wrong, block: undefined }] }, "wrong answer 1 names no place"],
    [
      "a wrong answer at another place",
      { wrong: [{ ...wrong, block: undefined, at: { x: 20, z: -80 } }] },
      "wrong answer 1 is not refused",
    ],
    ["nothing to do", { start: { program: whole.solution ?? [] } }, "what lies open in the beginning passes already"],
    ["another blank in the prompts", { start: { cycle: 811, values: {}, tool: 1 } }, "typed into the prompts"],
    ["a parameter of another cycle", { start: { ...whole.start, values: { Q500: "1" } } }, "cycle 811 has no Q500"],
    ["a question less", { predict: [{ ask: "passes" }] }, "en: 0 questions for 1 predictions"],
    [
      "a place that is nowhere",
      {
        start: { program: whole.solution ?? [] },
        predict: [{ ask: "rapidPlace", within: 3 }],
        words: wordsWith({ questions: ["Where?"] }),
      },
      "prediction 1: there is no such thing in the run",
    ],
    [
      "a block that is none",
      {
        start: { program: whole.solution ?? [] },
        predict: [{ ask: "block", right: [77] }],
        words: wordsWith({ questions: ["Which?"] }),
      },
      "prediction 1: there is no such thing in the run",
    ],
    [
      "seconds to the hundredth",
      {
        start: { program: whole.solution ?? [] },
        predict: [{ ask: "seconds" }],
        words: wordsWith({ questions: ["?"] }),
      },
      "prediction 1 needs `within`",
    ],
    [
      "a choice without choices",
      {
        start: { program: whole.solution ?? [] },
        predict: [{ ask: "choice", right: 1 }],
        words: wordsWith({ questions: ["?"], choices: [["one"]] }),
      },
      "en: choices of prediction 1",
    ],
    ["nothing to predict", { kind: "predict", start: { program: whole.solution ?? [] } }, "nothing is predicted"],
    ["a drawing without a par", { kind: "drawing" }, "a drawing needs a part and a par"],
  ] as readonly (readonly [string, Partial<Task>, string])[])("with %s is not", (_, change, problem) => {
    expect(problems(change).some((said) => said.startsWith(problem))).toBe(true);
  });
});

describe("a lesson that ships with the page", () => {
  const words = { title: "Title", aim: "Aim", pages: ["One"], questions: [null] };
  const lesson = lessonSchema.parse({
    id: "law",
    number: 7,
    pages: [{ program: whole.solution }],
    tasks: [],
    words: { en: words, de: words, fr: words, zh: words },
  });
  test("is complete", () => expect(lessonProblems(lesson, "07-law.json")).toEqual([]));
  test("is not under another name, without a text for a page, or with a program that has errors", () => {
    expect(lessonProblems(lesson, "8-law.json")).not.toEqual([]);
    expect(lessonProblems({ ...lesson, pages: [...lesson.pages, ...lesson.pages] }, "07-law.json")).toContain(
      "en: 1 texts for 2 pages",
    );
    expect(
      lessonProblems({ ...lesson, example: ["BEGIN PGM A MM", "CYCL CALL", "END PGM A MM"] }, "07-law.json"),
    ).not.toEqual([]);
  });
});
