import { expect, test } from "vitest";
import { secondsOfPages, secondsOfTask, shownStudyTime } from "./study-time.ts";
import type { Lesson } from "./lesson.ts";
import type { Task } from "./task.ts";

const NINE = "one two three four five six seven eight nine";
const page = { begins: "play" as const };
const slide = { q: "Q463", from: 1, to: 3, step: 1 };
const pages = (of: Lesson["pages"], texts: readonly string[]) =>
  secondsOfPages({ pages: of, words: { en: { title: "A", aim: "B", pages: [...texts] } } } as unknown as Lesson);

test("a page takes the time of its words, its program and its slider", () => {
  expect(pages([page], [NINE])).toBe(3);
  expect(pages([page, page], [NINE, ` ${NINE}\n\n${NINE} `])).toBe(9);
  expect(pages([{ ...page, program: ["0 BEGIN PGM A MM"] }], [NINE])).toBe(11);
  expect(pages([{ ...page, slide }], [NINE])).toBe(23);
});

const task = (more: Partial<Task>): number =>
  secondsOfTask({
    kind: "make",
    start: { empty: true },
    words: { en: { title: "A", ask: NINE, hints: ["1", "2", "3"] } },
    ...more,
  });
const begun = { program: ["0 BEGIN PGM A MM", "1 L X+0", "2 L X+0", "3 END PGM A MM"] };

test.each<readonly [string, number, Partial<Task>]>([
  ["reads the assignment and finds its way", 63, {}],
  ["looks for a fault first", 123, { kind: "fault" }],
  ["predicts two answers", 30 + 3 + 90, { kind: "predict", predict: [{ ask: "passes" }, { ask: "infeed" }] }],
  ["writes a program", 63 + 16, { solution: ["0 BEGIN PGM A MM", "1 END PGM A MM"] }],
  [
    "changes one of two equal lines",
    63 + 8,
    { start: begun, solution: ["0 BEGIN PGM A MM", "5 L X+0", "6 L X+9", "7 END PGM A MM"] },
  ],
  [
    "answers the open prompts, not those that are given",
    63 + 16,
    {
      start: { cycle: 812, values: { Q215: "0" } },
      solution: ["0 BEGIN PGM A MM", "1 CYCL DEF 812 ~", "   Q215=+0 ~", "  Q460=+2 ~", "  Q463=+3", "2 L X+5"],
    },
  ],
])("an exercise that %s", (_, seconds, more) => expect(task(more)).toBe(seconds));

test.each([
  [1, 0, 1],
  [89, 0, 1],
  [91, 0, 2],
  [29.4 * 60, 0, 29],
  [52 * 60, 0, 50],
  [58 * 60, 1, 0],
  [63 * 60, 1, 5],
  [6.1 * 3600, 6, 0],
  [6.4 * 3600, 6, 30],
])("%d s is shown as %d h %d min", (seconds, hours, minutes) =>
  expect(shownStudyTime(seconds)).toEqual({ hours, minutes }),
);
