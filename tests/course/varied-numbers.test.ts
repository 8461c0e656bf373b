import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { decidingBlock } from "../../src/course/judge/deciding-block.ts";
import { truthOf, type Truth } from "../../src/course/judge/predicting.ts";
import { answerKindOf } from "../../src/course/predicted-answers.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { taskSchema, type Task } from "../../src/course/task.ts";
import { varyNumbers, withNumbers } from "../../src/course/varied-numbers.ts";

const folder = new URL("../../src/course/tasks/", import.meta.url);
const tasks = readdirSync(folder)
  .map((file) => taskSchema.parse(JSON.parse(readFileSync(new URL(file, folder), "utf8"))))
  .filter(({ kind }) => kind === "predict");
const taskOf = (id: string): Task => tasks.find((task) => task.id === id) as Task;
const runOf = (text: string) => Promise.resolve(answerOf(text));
const programOf = ({ start }: Task) => ("program" in start ? start.program : []);
const truthsOf = (task: Task): readonly Truth[] =>
  (task.predict ?? []).map((each) => truthOf(each, task, answerOf(programOfLines(programOf(task)))));
const calculated = ({ predict = [] }: Task) =>
  predict.flatMap((each, i) => (["number", "place"].includes(answerKindOf(each)) ? [i] : []));

/** Tasks whose first question can be asked with other numbers. */
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

describe("a question that was answered wrongly is asked with other numbers", () => {
  test.each(VARIED)("%s", async (id) => {
    const task = taskOf(id),
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
});

test("a choice, or a sentence with a number that follows from others, is not asked again", async () => {
  for (const [id, questions] of [
    ["l01-read-diameter", [0, 2]],
    ["l21-towards-the-axis", [1]],
    ["l18-which-form", [0]],
  ] as const)
    expect(await varyNumbers(taskOf(id), questions, 1, runOf)).toBeNull();
});

test.each([
  ["l01-read-diameter", [15, 12, null]],
  ["l03-how-many-passes", [7, 7]],
  ["l19-family-of-bushes", [18, 14, null]],
])("the block that decides the answer: %s", (id, blocks) => {
  const task = taskOf(id);
  const answer = answerOf(programOfLines(programOf(task)));
  expect((task.predict ?? []).map((each) => decidingBlock(each, answer))).toEqual(blocks);
});
