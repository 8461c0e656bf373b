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
import { time } from "../../base/clock.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";

const NONE: Exams = {};

/** The exams of this device, running and over. They are no steps of undo, and nothing removes them. */
export const examRecord = record({
  key: "course-exams",
  version: 1,
  schema: z.object({ exams: z.record(z.string().check(z.maxLength(100)), examShape) }),
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

/** Records the latest moment of each running exam; the exams whose time has run out. */
export function overdueExams(): readonly Exam[] {
  const now = time();
  const running = Object.values(examRecord.now()).filter((exam) => !exam.ended && endOfExam(exam) !== null);
  for (const exam of running) if (now - exam.seen > SEEN) put(seenAt(exam, now));
  return running.filter((exam) => timeLeft(exam, now) === 0);
}
