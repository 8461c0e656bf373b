import {
  answerToQuestion,
  NO_PROGRESS,
  progressOfTask,
  progressShape,
  taskProgress,
  withAnswer,
  withHint,
  withPass,
  withPlace,
  withSolution,
  withStart,
  withTry,
  type AnsweredQuestion,
  type CourseMark,
  type PassedAnswer,
  type CourseProgress,
  type TaskProgress,
} from "../../../course/progress.ts";
import { time } from "../../base/clock.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";
import { editRecord } from "../../document/edit-record.ts";

/** Course progress on this device. */
export const progressRecord = record({
  key: "course",
  version: 1,
  schema: progressShape,
  rows: { of: "tasks", each: taskProgress },
  from: (progress): CourseProgress => progress,
  to: (progress) => progress,
  first: NO_PROGRESS,
  document: COURSE,
});
export const useLearning = progressRecord.use;

const change = (by: (progress: CourseProgress) => CourseProgress): void => progressRecord.put(by(progressRecord.now()));

/** Progress of a task, by its id. */
export const useTaskProgress = (task: string): TaskProgress => useLearning((s) => progressOfTask(s.list, task));

/** An answer to a task was checked, whether it passed or not. */
export const noteTry = (task: string): void => change((now) => withTry(now, task));
/** The hint of a task was shown up to a stage, from 1 to 3. */
export const noteHint = (task: string, stage: number): void => change((now) => withHint(now, task, stage));
/** The solution of a task was shown. */
export const noteSolution = (task: string): void => change((now) => withSolution(now, task));
/** An answer passed. The hints and the solution that were shown before decide how it counts. */
export const notePass = (task: string, worth: Omit<PassedAnswer, "when"> = {}): void =>
  change((now) => withPass(now, task, { ...worth, when: time() }));
/** A task was started over. */
export const noteStart = (task: string): void => change((now) => withStart(now, task));

/** The answer to a question on a page of a lesson; undefined before the first one. */
export const useAnswerToQuestion = (lesson: string, question: string): AnsweredQuestion | undefined =>
  useLearning((s) => answerToQuestion(s.list, lesson, question));
/** A question on a page of a lesson was answered. */
export const noteAnswer = (lesson: string, question: string, isRight: boolean): void =>
  change((now) => withAnswer(now, lesson, question, isRight, time()));

/** A page of a lesson was opened. */
export const noteLessonPage = (at: CourseMark): void => change((now) => withPlace(now, at));

/** Chooses the path through the course; null: the whole course. */
export const choosePath = (path: string | null): void => change((now) => ({ ...now, path }));

/** Restarts the course on the chosen path, as one step of undo. */
export const restartCourse = (): void => editRecord(progressRecord, ({ path }) => ({ ...NO_PROGRESS, path }));
