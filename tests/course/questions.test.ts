import { describe, expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judgePageAnswer } from "../../src/course/judge/page-answer.ts";
import { truthOf } from "../../src/course/judge/predicting.ts";
import { lessonSchema, type Lesson } from "../../src/course/lesson.ts";
import { programOfQuestion } from "../../src/course/page-question.ts";
import { blocksOfLines, programOfLines } from "../../src/course/task-start.ts";
import { LESSON_LANGUAGES } from "../../src/i18n/languages.ts";
import { toDiameter, radius } from "../../src/kernel/units.ts";

const files = import.meta.glob<unknown>("../../src/course/lessons/*.json", { eager: true, import: "default" });
const lessons = Object.values(files).map((raw) => lessonSchema.parse(raw));

/** The questions of a lesson, each with the program of its page. */
function questionsOf({ number, pages }: Lesson) {
  let program: readonly string[] = [];
  return pages.flatMap((page, i) => {
    program = page.program ?? program;
    return page.question ? [{ at: `${number}.${i + 1}`, index: i, question: page.question, program }] : [];
  });
}

test("every page of every lesson has a question or a slider", () => {
  const without = lessons.flatMap(({ number, pages }) =>
    pages.flatMap(({ question, slide }, i) => ((question ?? slide) ? [] : [`${number}.${i + 1}`])),
  );
  expect(without).toEqual([]);
});

test("every question has a name of its own in its lesson, and one right answer of several", () => {
  for (const lesson of lessons) {
    const all = questionsOf(lesson);
    expect(new Set(all.map(({ question }) => question.id)).size).toBe(all.length);
    for (const { at, index, question, program } of all) {
      const { asks } = question;
      if (asks.ask === "choice") {
        for (const language of LESSON_LANGUAGES) {
          const choices = lesson.words[language]?.questions[index]?.choices ?? [];
          expect(choices.length, `${at} ${language}`).toBeGreaterThan(asks.right);
          expect(asks.right, at).toBeGreaterThanOrEqual(0);
          expect(new Set(choices).size, `${at} ${language}`).toBe(choices.length);
        }
      }
      if (asks.ask === "block") {
        const numbers = blocksOfLines(program).map((block) => Number.parseInt(block, 10));
        for (const right of asks.right) expect(numbers, at).toContain(right);
      }
    }
  }
});

test("the right choice is not always at the same place", () => {
  const places = lessons.flatMap((lesson) =>
    questionsOf(lesson).flatMap(({ question: { asks } }) => (asks.ask === "choice" ? [asks.right] : [])),
  );
  for (const place of [0, 1, 2])
    expect(places.filter((each) => each === place).length).toBeGreaterThan(places.length / 5);
});

describe.each(LESSON_LANGUAGES)("the words of the questions in %s", (language) => {
  test("are there for each question and for no other page, with a reason for each answer", () => {
    for (const { number, pages, words } of lessons) {
      const texts = words[language]?.questions ?? [];
      expect(
        texts.map((text) => text !== null),
        String(number),
      ).toEqual(pages.map(({ question }) => !!question));
      pages.forEach(({ question }, i) => {
        const text = texts[i];
        if (!question || !text) return;
        const isChoice = question.asks.ask === "choice";
        expect(text.choices !== undefined, `${number}.${i + 1}`).toBe(isChoice);
        expect(text.why.length, `${number}.${i + 1}`).toBe(isChoice ? text.choices?.length : 2);
      });
    }
  });

  test("are short", () => {
    const most = language === "zh" ? 110 : 170;
    const long = lessons.flatMap(({ number, words }) =>
      (words[language]?.questions ?? []).flatMap((text, i) =>
        [text?.ask ?? "", ...(text?.why ?? [])].filter((each) => each.length > most).map(() => `${number}.${i + 1}`),
      ),
    );
    expect(long).toEqual([]);
  });
});

const calculated = lessons.flatMap((lesson) =>
  questionsOf(lesson)
    .filter(({ question: { asks } }) => asks.ask !== "choice" && asks.ask !== "block")
    .map((each) => ({ ...each, lesson })),
);

test.each(calculated)(
  "the run answers the question on page $at, as its reason says",
  ({ question, program, lesson, index }) => {
    const lines = programOfQuestion(question, program);
    // A question about other values has lines that change something.
    expect(lines.filter((line, i) => line !== program[i]).length > 0).toBe(question.with !== undefined);
    const answer = answerOf(programOfLines(lines));
    expect(answer.run.issues.filter(({ issue }) => issue.severity === "error")).toEqual([]);
    const truth = truthOf(question.asks, {}, answer);
    if (truth.kind === "place") {
      const { place } = truth;
      if (!place) throw new Error("no such place");
      const said = `${toDiameter(radius(place.r)).toFixed(1)} ${place.z.toFixed(1)}`;
      expect(judgePageAnswer(question, said, answer)?.right).toBe(true);
      expect(judgePageAnswer(question, "0 -1", answer)?.right).toBe(false);
      return;
    }
    const value = truth.kind === "number" ? truth.value : null;
    if (value === null) throw new Error("the run has no such value");
    // The number of the reason is a right answer, as typed in each language.
    for (const language of LESSON_LANGUAGES) {
      const reason = lesson.words[language]?.questions[index]?.why[0] ?? "";
      const numbers = reason.match(/-?\d+(?:[.,]\d+)?/g) ?? [];
      expect(
        numbers.some((typed) => judgePageAnswer(question, typed, answer)?.right === true),
        `${language}: ${value} is not in "${reason}"`,
      ).toBe(true);
    }
  },
);

test("a radius in place of a diameter is recognised, and a text without a number is no answer", () => {
  const { question, program } = calculated.find(({ question: { id } }) => id === "finished-size") ?? {};
  if (!question || !program) throw new Error("missing");
  const answer = answerOf(programOfLines(program));
  const judged = (text: string) => judgePageAnswer(question, text, answer);
  expect(judged("52")).toEqual({ right: true, why: 0, slip: null });
  expect(judged("26")).toEqual({ right: false, why: 1, slip: "half" });
  expect(judged("104")?.slip).toBe("twice");
  expect(judged("51")?.slip).toBe(null);
  expect(judged("about")).toBe(null);
});
