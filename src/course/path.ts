import type { CoursePath } from "./outline.ts";
import { answerToQuestion, needsRepeat, progressOfTask, type CourseProgress } from "./progress.ts";

/* Where a learner stands on the chosen path, what comes next, and what was missed. */

interface OutlinedLesson {
  readonly id: string;
  readonly tasks: readonly { readonly id: string }[];
}

/** The lessons of a path, each with only the exercises of the path. */
export function lessonsOnPath<L extends OutlinedLesson>(lessons: readonly L[], path: CoursePath | null): readonly L[] {
  if (!path) return lessons;
  return path.lessons.flatMap((stop) =>
    lessons
      .filter(({ id }) => id === stop.lesson)
      .map((lesson) => ({ ...lesson, tasks: lesson.tasks.filter(({ id }) => stop.tasks.includes(id)) })),
  );
}

/** Passed exercises, and all of them. */
export interface PassedCount {
  readonly passed: number;
  readonly of: number;
}

const isPassed = (progress: CourseProgress, { id }: { readonly id: string }): boolean =>
  progressOfTask(progress, id).passed !== null;

/** The total of lessons. Only their own exercises count, so that every total of the page agrees. */
export function passedOf(lessons: readonly OutlinedLesson[], progress: CourseProgress): PassedCount {
  const tasks = lessons.flatMap((lesson) => lesson.tasks);
  return { passed: tasks.filter((task) => isPassed(progress, task)).length, of: tasks.length };
}

/** State of a lesson: nothing of it was done, something, or it was read and all its exercises passed. */
export type LessonState = "new" | "begun" | "done";

export function stateOfLesson(lesson: OutlinedLesson, progress: CourseProgress): LessonState {
  const isRead = progress.read.includes(lesson.id);
  if (isRead && lesson.tasks.every((task) => isPassed(progress, task))) return "done";
  const isBegun =
    isRead || progress.last?.lesson === lesson.id || lesson.tasks.some(({ id }) => Object.hasOwn(progress.tasks, id));
  return isBegun ? "begun" : "new";
}

/** The lesson to continue with: the first one not done from the one opened last, else the first one not done at all. */
export function lessonToContinue<L extends OutlinedLesson>(lessons: readonly L[], progress: CourseProgress): L | null {
  const at = lessons.findIndex(({ id }) => id === progress.last?.lesson);
  const isOpen = (lesson: L) => stateOfLesson(lesson, progress) !== "done";
  return lessons.slice(Math.max(0, at)).find(isOpen) ?? lessons.find(isOpen) ?? null;
}

/** The lesson after one; null after the last, and for a lesson that is not among them. */
export function lessonAfter<L extends OutlinedLesson>(lessons: readonly L[], id: string): L | null {
  const index = lessons.findIndex((lesson) => lesson.id === id);
  return index < 0 ? null : (lessons[index + 1] ?? null);
}

interface ReviewedLesson extends OutlinedLesson {
  readonly questions: readonly { readonly id: string; readonly page: number }[];
}

/**
 * What was missed, and when, ms since 1970: an exercise that was passed with help, or a question whose last answer was
 * wrong, by its page.
 */
export type Missed<L extends OutlinedLesson> = { readonly lesson: L; readonly when: number } & (
  | { readonly kind: "task"; readonly task: L["tasks"][number] }
  | { readonly kind: "question"; readonly id: string; readonly page: number }
);

/** All that was missed, in the order of the lessons; of each, its questions before its exercises. */
export const missedIn = <L extends ReviewedLesson>(
  lessons: readonly L[],
  progress: CourseProgress,
): readonly Missed<L>[] =>
  lessons.flatMap((lesson): readonly Missed<L>[] => [
    ...lesson.questions.flatMap(({ id, page }) => {
      const answer = answerToQuestion(progress, lesson.id, id);
      return answer?.last === "wrong" ? [{ kind: "question" as const, lesson, id, page, when: answer.when }] : [];
    }),
    ...lesson.tasks.flatMap((task) => {
      const now = progressOfTask(progress, task.id);
      return now.passed && needsRepeat(now) ? [{ kind: "task" as const, lesson, task, when: now.passed.when }] : [];
    }),
  ]);

/** What follows in the course. A review comes before a lesson, which stays as the other way; null: it was the last. */
export type NextStep<L extends OutlinedLesson> =
  | { readonly kind: "task"; readonly lesson: L; readonly task: L["tasks"][number] }
  | { readonly kind: "lesson"; readonly lesson: L }
  | { readonly kind: "review"; readonly missed: readonly Missed<L>[]; readonly lesson: L | null };

/** A course: the lessons of a path, all lessons, and the chapters of all. */
export interface OutlinedCourse<L> {
  readonly lessons: readonly L[];
  readonly all: readonly L[];
  readonly chapters: readonly { readonly lessons: readonly string[] }[];
}

/** The lesson at whose end a step is asked for, and the exercise of it that was passed last. */
export interface EndOfLesson {
  readonly lesson: string;
  readonly task?: string;
}

/** At the end of a lesson: the next open exercise of it, else the next lesson that is not done. */
function stepInOrder<L extends OutlinedLesson>(
  lessons: readonly L[],
  progress: CourseProgress,
  end: EndOfLesson,
): Exclude<NextStep<L>, { kind: "review" }> | null {
  const at = lessons.findIndex(({ id }) => id === end.lesson);
  const lesson = lessons[at];
  if (!lesson) return null;
  const index = lesson.tasks.findIndex(({ id }) => id === end.task);
  const others = [...lesson.tasks.slice(index + 1), ...lesson.tasks.slice(0, Math.max(0, index))];
  const task = others.find((each) => !isPassed(progress, each));
  if (task) return { kind: "task", lesson, task };
  const after = lessons.slice(at + 1).find((each) => stateOfLesson(each, progress) !== "done");
  return after ? { kind: "lesson", lesson: after } : null;
}

/**
 * The next step at the end of a lesson, or else from where the learner was last. Between two chapters, and on a later
 * day than a miss, that is the review of what was missed. `today`: when the day began, ms since 1970.
 */
export function nextStep<L extends ReviewedLesson>(
  { lessons, all, chapters }: OutlinedCourse<L>,
  progress: CourseProgress,
  today: number,
  end: EndOfLesson | null = null,
): NextStep<L> | null {
  const open = end ? null : lessonToContinue(lessons, progress);
  const step = end ? stepInOrder(lessons, progress, end) : open && { kind: "lesson" as const, lesson: open };
  if (step?.kind === "task") return step;
  const next = step?.lesson ?? null;
  const left = end?.lesson ?? progress.last?.lesson ?? next?.id;
  const isChapterEnd =
    next === null ||
    chapters.some((chapter) => chapter.lessons.some((id) => id === left) && !chapter.lessons.includes(next.id));
  const missed = missedIn(all, progress);
  const isDue = missed.length > 0 && (isChapterEnd || missed.some(({ when }) => when < today));
  return isDue ? { kind: "review", missed, lesson: next } : step;
}
