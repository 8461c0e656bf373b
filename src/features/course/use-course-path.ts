import { useMemo } from "react";
import { lessonsOnPath, nextStep, type EndOfLesson, type Missed, type NextStep } from "../../course/path.ts";
import type { CourseProgress } from "../../course/progress.ts";
import { shownStudyTime } from "../../course/study-time.ts";
import { time } from "../../app/base/clock.ts";
import { useCourseIndex, type LessonEntry } from "../../app/records/course/content.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The lessons of the chosen path, each with its exercises on it; `all`: the whole course. */
export interface ChosenPath {
  /** Null: the whole course. */
  readonly id: string | null;
  readonly lessons: readonly LessonEntry[];
  readonly all: readonly LessonEntry[];
}

export function useCoursePath(): ChosenPath {
  const { lessons: all, paths } = useCourseIndex();
  const chosen = useLearning((s) => s.list.path);
  return useMemo(() => {
    const path = paths.find(({ id }) => id === chosen) ?? null;
    return { id: path?.id ?? null, lessons: lessonsOnPath(all, path), all };
  }, [all, paths, chosen]);
}

/** The path on which a lesson lies: the chosen one, or the whole course. */
export const lessonsAround = ({ lessons, all }: ChosenPath, lesson: string): readonly LessonEntry[] =>
  lessons.some(({ id }) => id === lesson) ? lessons : all;

/** When the day of this device began, ms since 1970. */
const beginOfDay = (): number => new Date(time()).setHours(0, 0, 0, 0);

/** The next step at the end of a lesson; without one, from where the learner was last. */
export function useNextStep(end: EndOfLesson | null = null): NextStep<LessonEntry> | null {
  const { chapters } = useCourseIndex();
  const path = useCoursePath();
  const { list } = useLearning();
  // The exercises of the path only, unless the exercise at hand is not on it.
  const around = end ? lessonsAround(path, end.lesson) : path.lessons;
  const isOnPath = !end?.task || around.some(({ tasks }) => tasks.some(({ id }) => id === end.task));
  return nextStep({ lessons: isOnPath ? around : path.all, all: path.all, chapters }, list, beginOfDay(), end);
}

/** The page to continue a lesson at: the one opened last, the exercises of a lesson that was read, else the first. */
export const pageToContinue = ({ id }: LessonEntry, { last, read }: CourseProgress) =>
  last?.lesson === id ? last.page : read.includes(id) ? "tasks" : 1;

/** Estimated seconds to do again what was missed: an exercise, or the page of a question. */
export const secondsOfMissed = (missed: readonly Missed<LessonEntry>[]): number =>
  missed.reduce(
    (sum, each) => sum + (each.kind === "task" ? each.task.seconds : each.lesson.seconds / each.lesson.pages),
    0,
  );

/** Estimated seconds of lessons with their exercises. */
export const secondsOfLessons = (lessons: readonly LessonEntry[]): number =>
  lessons.reduce((sum, { seconds, tasks }) => tasks.reduce((all, task) => all + task.seconds, sum + seconds), 0);

/** Says an estimated time: "about 25 min". */
export function useStudyTime(): (seconds: number) => string {
  const t = useTexts("course-path");
  return (seconds) => {
    const { hours, minutes } = shownStudyTime(seconds);
    return t.time(hours, minutes);
  };
}
