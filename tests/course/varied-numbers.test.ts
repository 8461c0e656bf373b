import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { LESSON_LANGUAGES } from "../../src/i18n/languages.ts";
import { answerOf } from "../../src/course/judge/answer.ts";
import type { Answer } from "../../src/course/judge/judgement.ts";
import { decidingBlock } from "../../src/course/judge/deciding-block.ts";
import { isRight, truthOf, type Truth } from "../../src/course/judge/predicting.ts";
import { answerKindOf } from "../../src/course/predicted-answers.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { hasAnswerInRun } from "../../src/course/made/made-questions.ts";
import { taskSchema, type Prediction, type Task } from "../../src/course/task.ts";
import { nextVariant, varyNumbers, withNumbers } from "../../src/course/varied-numbers.ts";

const folder = new URL("../../src/course/tasks/", import.meta.url);
const tasks = readdirSync(folder)
  .map((file) => taskSchema.parse(JSON.parse(readFileSync(new URL(file, folder), "utf8"))))
  .filter(({ kind }) => kind === "predict");
const taskOf = (id: string): Task => tasks.find((task) => task.id === id) as Task;
const answers = new Map<string, Answer>();
/** The answer of a program; each is run once. */
function runOnce(text: string): Answer {
  const answer = answers.get(text) ?? answerOf(text);
  answers.set(text, answer);
  return answer;
}
const runOf = (text: string) => Promise.resolve(runOnce(text));
const programOf = ({ start }: Task) => ("program" in start ? start.program : []);
const answerTo = (task: Task) => runOnce(programOfLines(programOf(task)));
const truthsOf = (task: Task): readonly Truth[] =>
  (task.predict ?? []).map((each) => truthOf(each, task, answerTo(task)));
const calculated = ({ predict = [] }: Task) =>
  predict.flatMap((each, i) => (["number", "place"].includes(answerKindOf(each)) ? [i] : []));

/** Tasks whose first question the kernel can ask with other numbers. */
const VARIED = [
  "l01-read-diameter",
  "l02-what-stays",
  "l03-how-many-passes",
  "l05-measure-the-chamfer",
  "l06-foretell-the-cone",
  "l07-after-roughing",
  "l08-foretell-812",
  "l13-offset",
  "l19-family-of-bushes",
];

const withoutVariants = (id: string): Task => ({ ...taskOf(id), variants: undefined });

describe("without a variant, a question that was answered wrongly is asked with other numbers", () => {
  test.each(VARIED)("%s", async (id) => {
    const task = withoutVariants(id),
      [question = 0] = calculated(task);
    const [one, two] = [await varyNumbers(task, [question], 1, runOf), await varyNumbers(task, [question], 2, runOf)];
    expect(one).not.toBeNull();
    expect(await varyNumbers(task, [question], 1, runOf)).toEqual(one);
    for (const other of [one, two]) {
      const varied = withNumbers(task, other ?? undefined);
      expect(truthsOf(varied)[question]).not.toEqual(truthsOf(task)[question]);
      // One number of the program, and wherever the words name it.
      expect(programOf(varied).filter((line, i) => line !== programOf(task)[i])).toHaveLength(1);
      for (const [from] of other?.named ?? [])
        expect(varied.words.en?.ask).not.toMatch(new RegExp(String.raw`(?<![\d.])${from}(?![\d.])`));
    }
  });

  test("a choice, or a sentence with a number that follows from others, is not", async () => {
    for (const [id, questions] of [
      ["l01-read-diameter", [0, 2]],
      ["l21-towards-the-axis", [1]],
      ["l18-which-form", [0]],
    ] as const)
      expect(await varyNumbers(withoutVariants(id), questions, 1, runOf)).toBeNull();
  });
});

/** What is asked, and the right answer as it is read. */
const asRead = (task: Task, language: "en" | "de" | "fr" | "zh") =>
  truthsOf(task).map((truth, i) => {
    const words = task.words[language];
    const right = truth.kind === "choice" ? words?.choices?.[i]?.[truth.right] : JSON.stringify(truth);
    return `${words?.questions?.[i]} ${right}`;
  });

describe("every question of predictions has variants with other answers", () => {
  test.each(tasks.map((task) => [task.id, task] as const))("%s", (_, task) => {
    const variants = task.variants ?? [];
    expect(variants).not.toEqual([]);
    const asked = [task, ...variants.map((_, i) => withNumbers(task, nextVariant(task, i + 1) ?? undefined))];
    expect(nextVariant(task, asked.length)).toBeNull();
    const findings = new Set(answerTo(task).run.issues.map(({ issue }) => issue.code as string));
    asked.slice(1).forEach((next, i) => {
      const before = asked[i] as Task;
      expect(programOf(next)).not.toEqual(programOf(before));
      const answer = answerTo(next);
      expect(answer.run.issues.flatMap(({ issue }) => (findings.has(issue.code) ? [] : [issue.code]))).toEqual([]);
      const known = truthsOf(before);
      truthsOf(next).forEach((truth, q) => {
        const prediction = next.predict?.[q] as Prediction;
        expect(hasAnswerInRun(truth, answer)).toBe(true);
        const now = truth.kind === "number" ? truth.value : truth.kind === "place" ? truth.place : null;
        // What was right before is wrong now.
        if (now !== null) expect([q, isRight(prediction, known[q] as Truth, now)]).toEqual([q, false]);
        if (prediction.ask === "passes") expect(now).toBeGreaterThan(0);
      });
      for (const language of LESSON_LANGUAGES) {
        const [was, is] = [asRead(before, language), asRead(next, language)];
        expect(is.filter((text, q) => text === was[q])).toEqual([]);
        // As many answers to choose from, all different.
        next.words[language]?.choices?.forEach((choices, q) => {
          expect(new Set(choices).size).toBe(before.words[language]?.choices?.[q]?.length);
        });
      }
    });
  });

  test.each([
    ["l01-read-diameter", 1, "de", 2, "3,8 mm"],
    ["l01-read-diameter", 2, "en", 2, "2.2 mm"],
    ["l21-towards-the-axis", 1, "fr", 0, "⌀31,8"],
  ] as const)("choices have the numbers of the variant: %s, %i", (id, tries, language, question, right) => {
    const varied = withNumbers(taskOf(id), nextVariant(taskOf(id), tries) ?? undefined);
    const prediction = varied.predict?.[question];
    expect(
      varied.words[language]?.choices?.[question]?.[prediction?.ask === "choice" ? (prediction.right ?? -1) : -1],
    ).toBe(right);
  });
});

test.each([
  ["l01-read-diameter", [15, 12, null]],
  ["l03-how-many-passes", [7, 7]],
  ["l19-family-of-bushes", [18, 14, null]],
])("the block that decides the answer: %s", (id, blocks) => {
  const task = taskOf(id);
  const answer = answerTo(task);
  expect((task.predict ?? []).map((each) => decidingBlock(each, answer))).toEqual(blocks);
});
