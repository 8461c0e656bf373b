import { useMemo } from "react";
import { lessonsOnPath } from "../../course/path.ts";
import { shownStudyTime } from "../../course/study-time.ts";
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
