import { z } from "zod/mini";
import { amount, measure, moment } from "../program/files/bounded.ts";

/*
 * A learner's progress in the course. It is stored by the ids of lessons and tasks, so that lessons added or removed in
 * another version lose nothing. Everything here is plain data; the page stores it.
 */

/** How a task was passed: without help, after hints, or after its solution was shown. The first is the best. */
export const WAYS_PASSED = ["alone", "hints", "solution"] as const;
export type WayPassed = (typeof WAYS_PASSED)[number];

/** The number of hints of a task. */
const STAGES = 3;
const count = z.int().check(z.gte(0), z.lte(1_000_000));
const stage = z.int().check(z.gte(0), z.lte(STAGES));

export const taskProgress = z.object({
  /** Number of answers checked. */
  tries: count,
  /** Number of hints shown, and whether the solution was shown, both before the task was passed. */
  hints: stage,
  solution: z.boolean(),
  /** The best way in which it was passed, and when for the first time, ms since 1970; null while not passed. */
  passed: z.nullable(z.object({ way: z.enum(WAYS_PASSED), when: moment })),
  /** Shortest machining time of a passing answer, s, and greatest score; null without one. */
  seconds: z.nullable(amount),
  score: z.nullable(measure),
  /** The help shown in a repeated attempt: one started over after a pass with help. Null while there is none. */
  repeat: z._default(z.nullable(z.object({ hints: stage, solution: z.boolean() })), null),
  /** Whether a repeated attempt passed without help. `passed` keeps saying how the first one did. */
  repeated: z._default(z.boolean(), false),
});
export type TaskProgress = z.output<typeof taskProgress>;

/**
 * A question on a page: the last answer, when it was given, ms since 1970 (0: not known), and the number of answers. A
 * question without an answer has no entry.
 */
const answered = z.object({ last: z.enum(["right", "wrong"]), answers: count, when: z._default(moment, 0) });
export type AnsweredQuestion = z.output<typeof answered>;

/** A page of a lesson from 1, or the tasks behind the last one. */
const lessonPage = z.union([z.int().check(z.gte(1), z.lte(99)), z.literal("tasks")]);
export type LessonPage = z.output<typeof lessonPage>;

const id = z.string().check(z.minLength(1), z.maxLength(100));
const place = z.object({ lesson: id, number: count, page: lessonPage });
/** Where the learner was last: the lesson, its number in the course, and its page. */
export type CourseMark = z.output<typeof place>;

/** Progress as stored. */
export const progressShape = z.object({
  version: z.literal(1),
  tasks: z.record(id, taskProgress),
  /** Lessons read to the end. */
  read: z.array(id).check(z.maxLength(1000)),
  last: z.nullable(place),
  /** Answered questions on pages, by lesson and question. */
  questions: z._default(z.record(id, z.record(id, answered)), {}),
  /** The chosen path through the course, by its id; null: the whole course. */
  path: z._default(z.nullable(id), null),
});
export type CourseProgress = z.output<typeof progressShape>;

export const NO_PROGRESS: CourseProgress = {
  version: 1,
  tasks: {},
  read: [],
  last: null,
  questions: {},
  path: null,
};
const NOT_BEGUN: TaskProgress = {
  tries: 0,
  hints: 0,
  solution: false,
  passed: null,
  seconds: null,
  score: null,
  repeat: null,
  repeated: false,
};

/** The progress of a task. */
export const progressOfTask = ({ tasks }: CourseProgress, task: string): TaskProgress =>
  (Object.hasOwn(tasks, task) && tasks[task]) || NOT_BEGUN;

const changed = (
  progress: CourseProgress,
  task: string,
  change: (now: TaskProgress) => TaskProgress,
): CourseProgress => ({
  ...progress,
  tasks: { ...progress.tasks, [task]: change(progressOfTask(progress, task)) },
});

/** An answer to a task was checked. */
export const withTry = (progress: CourseProgress, task: string): CourseProgress =>
  changed(progress, task, (now) => ({ ...now, tries: now.tries + 1 }));

/** Changes the help shown: of the repeated attempt, or else of the first one. */
const helped = (progress: CourseProgress, task: string, change: (now: ShownHelp) => ShownHelp): CourseProgress =>
  changed(progress, task, (now) => (now.repeat ? { ...now, repeat: change(now.repeat) } : { ...now, ...change(now) }));

/** The help shown in the attempt that is going on. */
export interface ShownHelp {
  readonly hints: number;
  readonly solution: boolean;
}
export const shownHelp = ({ hints, solution, repeat }: TaskProgress): ShownHelp => repeat ?? { hints, solution };

/** Hints of a task were shown up to a number, from 1. After the task is passed they change nothing. */
export const withHint = (progress: CourseProgress, task: string, hint: number): CourseProgress =>
  helped(progress, task, ({ hints, solution }) => ({ hints: Math.min(STAGES, Math.max(hints, hint)), solution }));

/** The solution of a task was shown. */
export const withSolution = (progress: CourseProgress, task: string): CourseProgress =>
  helped(progress, task, ({ hints }) => ({ hints, solution: true }));

/** Whether a task was passed with help and not yet unaided in a repeated attempt. */
export const needsRepeat = ({ passed, repeated }: TaskProgress): boolean =>
  passed !== null && passed.way !== "alone" && !repeated;

/** A task was started over. One that needs a repeated attempt begins it, with all help covered again. */
export function withStart(progress: CourseProgress, task: string): CourseProgress {
  const needs = needsRepeat(progressOfTask(progress, task));
  return needs ? changed(progress, task, (now) => ({ ...now, repeat: { hints: 0, solution: false } })) : progress;
}

const rank = (passed: TaskProgress["passed"]): number =>
  passed ? WAYS_PASSED.indexOf(passed.way) : WAYS_PASSED.length;
/** The better of two passes; of equal ones the earlier. */
function betterPass(one: TaskProgress["passed"], other: TaskProgress["passed"]): TaskProgress["passed"] {
  if (!one || !other) return one ?? other;
  if (rank(one) !== rank(other)) return rank(one) < rank(other) ? one : other;
  return one.when <= other.when ? one : other;
}
const least = (one: number | null, other: number | null): number | null =>
  one === null || other === null ? (one ?? other) : Math.min(one, other);
const greatest = (one: number | null, other: number | null): number | null =>
  one === null || other === null ? (one ?? other) : Math.max(one, other);

/** An answer that passed. */
export interface PassedAnswer {
  /** ms since 1970. */
  readonly when: number;
  /** Machining time, s, and score, where the task has them. */
  readonly seconds?: number;
  readonly score?: number;
}

/** A task was passed: unaided if neither hint nor solution was shown before. A better earlier pass is kept. */
export const withPass = (
  progress: CourseProgress,
  task: string,
  { when, seconds, score }: PassedAnswer,
): CourseProgress =>
  changed(progress, task, (now) => {
    const firstWay: WayPassed = now.hints > 0 ? "hints" : "alone";
    const way = now.solution ? "solution" : firstWay;
    const isUnaidedRepeat = now.repeat !== null && now.repeat.hints === 0 && !now.repeat.solution;
    return {
      ...now,
      repeated: now.repeated || isUnaidedRepeat,
      passed: betterPass(now.passed, { way, when }),
      seconds: least(now.seconds, seconds ?? null),
      score: greatest(now.score, score ?? null),
    };
  });

/** A lesson was opened at a page; at its tasks it counts as read. */
export function withPlace(progress: CourseProgress, last: CourseMark): CourseProgress {
  const { lesson, number, page } = last;
  const is = progress.last;
  const read = page === "tasks" && !progress.read.includes(lesson) ? [...progress.read, lesson] : progress.read;
  if (read === progress.read && is?.lesson === lesson && is.page === page && is.number === number) return progress;
  return { ...progress, read, last };
}

/** The answer to a question on a page; undefined before the first one. */
export function answerToQuestion(
  { questions }: CourseProgress,
  lesson: string,
  question: string,
): AnsweredQuestion | undefined {
  const ofLesson = Object.hasOwn(questions, lesson) ? questions[lesson] : undefined;
  return ofLesson && Object.hasOwn(ofLesson, question) ? ofLesson[question] : undefined;
}

/** A question on a page of a lesson was answered. */
export function withAnswer(
  progress: CourseProgress,
  lesson: string,
  question: string,
  isRight: boolean,
  when: number,
): CourseProgress {
  const answers = (answerToQuestion(progress, lesson, question)?.answers ?? 0) + 1;
  const ofLesson = Object.hasOwn(progress.questions, lesson) ? progress.questions[lesson] : {};
  const now: AnsweredQuestion = { last: isRight ? "right" : "wrong", answers, when };
  return { ...progress, questions: { ...progress.questions, [lesson]: { ...ofLesson, [question]: now } } };
}

/** State of a task: not begun, tried, or passed in one of the three ways; unaided also if a repeated attempt was. */
export type TaskState = "new" | "tried" | WayPassed;
export function stateOfTask({
  tries,
  hints,
  solution,
  passed,
  repeated = false,
}: Pick<TaskProgress, "tries" | "hints" | "solution" | "passed"> & { readonly repeated?: boolean }): TaskState {
  if (passed) return repeated ? "alone" : passed.way;
  return tries > 0 || hints > 0 || solution ? "tried" : "new";
}

/** Merges the progress of one task: the better of each value is kept. */
function mergedTask(one: TaskProgress, other: TaskProgress): TaskProgress {
  return {
    tries: Math.max(one.tries, other.tries),
    hints: Math.max(one.hints, other.hints),
    solution: one.solution || other.solution,
    passed: betterPass(one.passed, other.passed),
    seconds: least(one.seconds, other.seconds),
    score: greatest(one.score, other.score),
    repeat: one.repeat ?? other.repeat,
    repeated: one.repeated || other.repeated,
  };
}

/** Merges the answers to one question: right if it was right on either side. */
const mergedAnswer = (one: AnsweredQuestion, other: AnsweredQuestion): AnsweredQuestion => ({
  last: one.last === "right" ? "right" : other.last,
  answers: Math.max(one.answers, other.answers),
  when: Math.max(one.when, other.when),
});

function mergedQuestions(mine: CourseProgress, brought: CourseProgress): CourseProgress["questions"] {
  const questions = { ...mine.questions };
  for (const [lesson, theirs] of Object.entries(brought.questions)) {
    const merged = Object.entries(theirs).map(([question, their]) => {
      const my = answerToQuestion(mine, lesson, question);
      return [question, my ? mergedAnswer(my, their) : their] as const;
    });
    questions[lesson] = { ...(Object.hasOwn(questions, lesson) && questions[lesson]), ...Object.fromEntries(merged) };
  }
  return questions;
}

/** Merges two progresses. Place and path are the local ones, if there are any. */
export function mergedProgress(mine: CourseProgress, brought: CourseProgress): CourseProgress {
  const tasks = { ...mine.tasks };
  for (const [task, theirs] of Object.entries(brought.tasks))
    tasks[task] = mergedTask(progressOfTask(mine, task), theirs);
  return {
    version: 1,
    tasks,
    read: [...new Set([...mine.read, ...brought.read])],
    last: mine.last ?? brought.last,
    questions: mergedQuestions(mine, brought),
    path: mine.path ?? brought.path,
  };
}

/** Whether nothing was begun yet. */
export const isEmptyProgress = ({ tasks, read, last, questions }: CourseProgress): boolean =>
  last === null && read.length === 0 && Object.keys(tasks).length === 0 && Object.keys(questions).length === 0;
