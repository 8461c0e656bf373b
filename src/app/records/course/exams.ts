import { z } from "zod/mini";
import {
  beginExam,
  endOfExam,
  examOfTask,
  examShape,
  seenAt,
  timeLeft,
  withCheck,
  type Exam,
  type ExamCheck,
  type Exams,
} from "../../../course/exam.ts";
import type { HandedResult } from "../../../course/made/result.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import { clock, time } from "../../base/clock.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";

const NONE: Exams = {};

/** The exams of this device, running and over. They are no steps of undo, and nothing removes them. */
export const examRecord = record({
  key: "course-exams",
  version: 1,
  schema: z.object({ exams: z.record(z.string().check(z.maxLength(100)), examShape) }),
  rows: { of: "exams", each: examShape },
  from: ({ exams }): Exams => exams,
  to: (exams) => ({ exams }),
  first: NONE,
  document: COURSE,
});
export const useExams = examRecord.use;

/** The exam that a task belongs to; undefined if it is in none. */
export const useExamOfTask = (task: string): Exam | undefined => useExams(({ list }) => examOfTask(list, task));

const put = (exam: Exam): void => examRecord.put({ ...examRecord.now(), [exam.set.id]: exam });
const examOf = (set: string): Exam | undefined => {
  const all = examRecord.now();
  return Object.hasOwn(all, set) ? all[set] : undefined;
};

/** Begins an exam, once. */
export function startExam(set: TaskSet, name: string, group: string): void {
  if (!examOf(set.id)) put(beginExam(set, name, group, time()));
}

/** An answer to a task of an exam was checked. */
export function noteExamCheck(task: string, found: Omit<ExamCheck, "count">): void {
  const exam = examOfTask(examRecord.now(), task);
  if (exam) put(withCheck(exam, task, found));
}

/** Ends an exam with what is handed in; what was handed in before stays. */
export function endExam(set: string, by: "learner" | "time", result: HandedResult): void {
  const exam = examOf(set);
  if (exam && !exam.ended) put({ ...exam, seen: Math.max(exam.seen, time()), ended: { by, result } });
}

/** How often the latest moment of a running exam is recorded, ms. */
const SEEN = 5000;

/** When this page recorded the latest moment of each exam, by its set, in the time of this page. */
const recorded = new Map<string, { readonly seen: number; readonly at: number }>();

/** Time that passed since the latest moment of an exam was recorded, whatever the time of day was set to meanwhile, ms. */
function passedSince({ set: { id }, seen }: Exam): number {
  const last = recorded.get(id);
  const now = clock.now();
  if (last?.seen === seen) return now - last.at;
  recorded.set(id, { seen, at: now });
  return 0;
}

/** Time left in an exam now, ms; null without a limit. */
export const timeLeftNow = (exam: Exam): number | null => timeLeft(exam, time(), passedSince(exam));

/** Records the latest moment of each running exam; the exams whose time has run out. */
export function overdueExams(): readonly Exam[] {
  const running = Object.values(examRecord.now()).filter((exam) => !exam.ended && endOfExam(exam) !== null);
  for (const exam of running) {
    const now = seenAt(exam, time(), passedSince(exam));
    if (now.seen - exam.seen > SEEN) put(now);
  }
  return running.filter((exam) => timeLeftNow(exam) === 0);
}
