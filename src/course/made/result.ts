import { z } from "zod/mini";
import { amount, measure, moment } from "../../program/files/bounded.ts";
import { WAYS_PASSED } from "../progress.ts";
import { RULES } from "../judge/judgement.ts";
import { askedQuestions, otherNumbers } from "./other-numbers.ts";

/*
 * A learner's results: the outcome of each task as the device recorded it, with the last program. They prove nothing: a
 * file can be changed.
 */

export const RESULT_FORMAT = "turnwise-result/1";

const count = z.int().check(z.gte(0), z.lte(1_000_000));
const text = (most: number) => z.string().check(z.maxLength(most));
/** Longest program in a result, characters. */
const LONGEST = 400_000;

const taskResult = z.object({
  id: text(100),
  title: text(2000),
  tries: count,
  hints: count,
  /** Whether the stored answer was shown. */
  solution: z.boolean(),
  passed: z.nullable(z.object({ way: z.enum(WAYS_PASSED), when: moment })),
  /** Shortest machining time of a passing answer, s; greatest score. */
  seconds: z.nullable(amount),
  score: z.nullable(measure),
  /** Time that the task was open and visible, s, and the number of changes made. */
  worked: amount,
  steps: count,
  /** The last program; null where none was stored. */
  program: z.nullable(text(LONGEST)),
  /** The answers to the questions before the run, as typed. */
  told: z.optional(z.array(text(40)).check(z.maxLength(60))),
  /** The numbers that these questions were asked with, and which of them; absent: those of the task, and all. */
  varied: z.optional(otherNumbers),
  asked: z.optional(askedQuestions),
  /** Whether that program passes, and the rules that refuse it; null where it was not judged. */
  verdict: z.nullable(
    z.object({ passed: z.boolean(), refused: z.array(z.enum(RULES)).check(z.maxLength(RULES.length)) }),
  ),
});
export type TaskResult = z.output<typeof taskResult>;

export const resultShape = z.object({
  format: z.literal(RESULT_FORMAT),
  /** As typed; empty where no name was typed. */
  name: text(200),
  /** The class of the learner, as typed. */
  group: z.optional(text(200)),
  /** ms since 1970. */
  made: moment,
  /** The set that the tasks belong to, and when it was due, ms since 1970. */
  set: z.optional(z.object({ id: text(100), title: text(2000), due: z.optional(moment) })),
  /** Start of the exam, ms since 1970, and what ended it. */
  exam: z.optional(z.object({ begun: moment, by: z.enum(["learner", "time"]) })),
  tasks: z.array(taskResult).check(z.maxLength(500)),
});
export type HandedResult = z.output<typeof resultShape>;

/** A learner's results from a file; null where they are damaged. */
export function readResult(raw: unknown): HandedResult | null {
  const read = resultShape.safeParse(raw);
  return read.success ? read.data : null;
}
