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

/** What follows in the course. */
export type NextStep<L extends OutlinedLesson> =
  | { readonly kind: "task"; readonly lesson: L; readonly task: L["tasks"][number] }
  | { readonly kind: "lesson"; readonly lesson: L };

/** The lesson after one; null after the last, and for a lesson that is not among them. */
export function lessonAfter<L extends OutlinedLesson>(lessons: readonly L[], id: string): L | null {
  const index = lessons.findIndex((lesson) => lesson.id === id);
  return index < 0 ? null : (lessons[index + 1] ?? null);
}

/** After an exercise: the next open one of its lesson, else the next lesson; null at the end of the course. */
export function stepAfterTask<L extends OutlinedLesson>(
  lessons: readonly L[],
  progress: CourseProgress,
  id: string,
): NextStep<L> | null {
  const lesson = lessons.find(({ tasks }) => tasks.some((task) => task.id === id));
  if (!lesson) return null;
  const index = lesson.tasks.findIndex((task) => task.id === id);
  const others = [...lesson.tasks.slice(index + 1), ...lesson.tasks.slice(0, index)];
  const task = others.find((each) => !isPassed(progress, each));
  if (task) return { kind: "task", lesson, task };
  const after = lessonAfter(lessons, lesson.id);
  return after && { kind: "lesson", lesson: after };
}

interface ReviewedLesson extends OutlinedLesson {
  readonly questions: readonly { readonly id: string; readonly page: number }[];
}

/** What was missed: an exercise that was passed with help, or a question whose last answer was wrong, by its page. */
export type Missed<L extends OutlinedLesson> =
  | { readonly kind: "task"; readonly lesson: L; readonly task: L["tasks"][number] }
  | { readonly kind: "question"; readonly lesson: L; readonly id: string; readonly page: number };

/** All that was missed, in the order of the lessons; of each, its questions before its exercises. */
export const missedIn = <L extends ReviewedLesson>(
  lessons: readonly L[],
  progress: CourseProgress,
): readonly Missed<L>[] =>
  lessons.flatMap((lesson): readonly Missed<L>[] => [
    ...lesson.questions
      .filter(({ id }) => answerToQuestion(progress, lesson.id, id)?.last === "wrong")
      .map(({ id, page }) => ({ kind: "question" as const, lesson, id, page })),
    ...lesson.tasks
      .filter(({ id }) => needsRepeat(progressOfTask(progress, id)))
      .map((task) => ({ kind: "task" as const, lesson, task })),
  ]);
