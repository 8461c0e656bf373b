import { z } from "zod/mini";
import { moment } from "../program/files/bounded.ts";
import { resultShape } from "./made/result.ts";
import { setSchema, type TaskSet } from "./task-set.ts";

/*
 * An exam as the learner's device records it: when it began, the checks of each task, and what was handed in. The record
 * outlives the set and its programs, so that neither a reload nor removing and opening the set again starts it again.
 */

const count = z.int().check(z.gte(0), z.lte(1_000_000));

export const examShape = z.object({
  /** The set as it was when the exam began. */
  set: setSchema,
  /** As typed before the start; empty only where the exam allows it. */
  name: z.string().check(z.maxLength(200)),
  group: z.string().check(z.maxLength(200)),
  /** ms since 1970: the start, and the latest moment seen since: a clock that is set back gains nothing. */
  begun: moment,
  seen: moment,
  /** Checks of each task by its id: how many, and how the last one went: whether it passed, and the goals met. */
  checks: z.record(z.string().check(z.maxLength(100)), z.object({ count, passed: z.boolean(), met: count, of: count })),
  /** What was handed in, and whether time had run out; null while it goes on. */
  ended: z.nullable(z.object({ by: z.enum(["learner", "time"]), result: resultShape })),
});
export type Exam = z.output<typeof examShape>;
export type ExamCheck = Exam["checks"][string];
/** Exams by the id of their set. */
export type Exams = Readonly<Record<string, Exam>>;

const MINUTE = 60_000;

export const beginExam = (set: TaskSet, name: string, group: string, now: number): Exam => ({
  set,
  name: name.trim(),
  group: group.trim(),
  begun: now,
  seen: now,
  checks: {},
  ended: null,
});

/** The moment at which an exam ends by itself, ms since 1970; null without a limit. */
export function endOfExam({ set: { exam, due }, begun }: Pick<Exam, "set" | "begun">): number | null {
  const ends = [
    ...(exam?.minutes === undefined ? [] : [begun + exam.minutes * MINUTE]),
    ...(due === undefined ? [] : [due]),
  ];
  return ends.length === 0 ? null : Math.min(...ends);
}

/**
 * The moment in an exam, ms since 1970: that of the clock, or of the latest moment seen and the `passed` time since, if
 * the clock is behind it. A clock that is set back gains nothing while the page is open.
 */
export const momentIn = ({ seen }: Pick<Exam, "seen">, now: number, passed = 0): number => Math.max(now, seen + passed);

/** Time left, ms, never negative; null without a limit. */
export function timeLeft(exam: Exam, now: number, passed = 0): number | null {
  const end = endOfExam(exam);
  return end === null ? null : Math.max(0, end - momentIn(exam, now, passed));
}

/** The latest moment seen moves on. */
export const seenAt = (exam: Exam, now: number, passed = 0): Exam => {
  const seen = momentIn(exam, now, passed);
  return seen > exam.seen ? { ...exam, seen } : exam;
};

/** Whether an exam can still be begun. */
export const canBegin = ({ due }: TaskSet, now: number): boolean => due === undefined || now < due;

/** The last check of a task, with the number of its checks; undefined before the first. */
export const checkIn = ({ checks }: Exam, task: string): ExamCheck | undefined =>
  Object.hasOwn(checks, task) ? checks[task] : undefined;

/** Checks left in a task; null without a limit. */
export function checksLeft(exam: Exam, task: string): number | null {
  const most = exam.set.exam?.tries;
  return most === undefined ? null : Math.max(0, most - (checkIn(exam, task)?.count ?? 0));
}

/** A task was checked once more. */
export const withCheck = (exam: Exam, task: string, found: Omit<ExamCheck, "count">): Exam => ({
  ...exam,
  checks: { ...exam.checks, [task]: { ...found, count: (checkIn(exam, task)?.count ?? 0) + 1 } },
});

/** The exam that a task belongs to; undefined if it is in none. */
export const examOfTask = (exams: Exams, task: string): Exam | undefined =>
  Object.values(exams).find(({ set }) => set.tasks.some(({ id }) => id === task));

/** Two records of one exam: the earlier start, the later moment, the more checks, what was handed in first. */
function mergedExam(one: Exam, other: Exam): Exam {
  const checks = { ...one.checks };
  for (const [task, theirs] of Object.entries(other.checks))
    if (theirs.count > (checkIn(one, task)?.count ?? 0)) checks[task] = theirs;
  const ended = [one.ended, other.ended]
    .filter((each) => each !== null)
    .toSorted((a, b) => a.result.made - b.result.made)[0];
  return {
    ...one,
    begun: Math.min(one.begun, other.begun),
    seen: Math.max(one.seen, other.seen),
    checks,
    ended: ended ?? null,
  };
}

export function mergedExams(mine: Exams, brought: Exams): Exams {
  const all = { ...mine };
  for (const [id, theirs] of Object.entries(brought)) {
    const ours = Object.hasOwn(mine, id) ? mine[id] : undefined;
    all[id] = ours ? mergedExam(ours, theirs) : theirs;
  }
  return all;
}
