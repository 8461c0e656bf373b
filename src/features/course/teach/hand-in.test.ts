import { readFileSync } from "node:fs";
import { beforeEach, expect, test, vi } from "vitest";
import { answerOf } from "../../../course/judge/answer.ts";
import { readResult, RESULT_FORMAT, type TaskResult } from "../../../course/made/result.ts";
import { truthOf } from "../../../course/judge/predicting.ts";
import { programOfLines } from "../../../course/task-start.ts";
import { taskSchema } from "../../../course/task.ts";
import { nextVariant, withNumbers, type OtherNumbers } from "../../../course/varied-numbers.ts";
import type { ProgramWork } from "../../../app/document/work.ts";
import type { RerunOutcome } from "../../../app/records/course/result-rows.ts";
import { rerunResult } from "./hand-in.ts";

const content = vi.hoisted(() => ({ task: null as unknown }));
vi.mock("../../../app/records/course/content.ts", () => ({ fetchTask: () => Promise.resolve(content.task) }));
vi.mock("../../../app/calculation/other-outcome.ts", () => ({
  outcomeOfOther: ({ text }: ProgramWork) => Promise.resolve(answerOf(text)),
}));

const taskOf = (id: string) =>
  taskSchema.parse(JSON.parse(readFileSync(new URL(`../../../course/tasks/${id}.json`, import.meta.url), "utf8")));

/** A result of an exam, as it comes out of the learner's file. */
function handedIn(answers: Pick<TaskResult, "told" | "varied" | "asked">): TaskResult {
  const result = {
    ...{ id: "asked", title: "", tries: 1, hints: 0, solution: false, passed: null, seconds: null, score: null },
    ...{ worked: 0, steps: 0, program: null, verdict: null, ...answers },
  };
  const read = readResult(JSON.parse(JSON.stringify({ format: RESULT_FORMAT, name: "A", made: 0, tasks: [result] })))
    ?.tasks[0];
  if (!read) throw new Error("not read");
  return read;
}

const task = taskOf("l07-after-roughing");
const varied = nextVariant(task, 1) ?? undefined;

/** The right answers to its questions, as typed. */
function rightAnswers(numbers: OtherNumbers | undefined): string[] {
  const asked = withNumbers(task, numbers);
  const answer = answerOf(programOfLines("program" in asked.start ? asked.start.program : []));
  return (asked.predict ?? []).map((prediction) => {
    const truth = truthOf(prediction, asked, answer);
    if (truth.kind === "choice") return String(truth.right);
    return truth.kind === "number" ? String(truth.value) : "";
  });
}

beforeEach(() => {
  content.task = task;
});

const told = rightAnswers(varied);
test.each<[string, Parameters<typeof handedIn>[0], RerunOutcome]>([
  ["with other numbers", { told, varied }, "passes"],
  ["without the numbers that they belong to", { told }, "fails"],
  ["wrong with other numbers", { told: rightAnswers(undefined), varied }, "fails"],
  ["with the numbers of the task", { told: rightAnswers(undefined) }, "passes"],
  ["only for the questions asked again", { told: told.with(0, ""), varied, asked: [1, 2] }, "passes"],
  ["open questions", { told: told.with(0, ""), varied }, "fails"],
])("handed-in answers are judged by the run that was asked for: %s", async (_, answers, expected) => {
  expect((await rerunResult(handedIn(answers))).is).toBe(expected);
});
