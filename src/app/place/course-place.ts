import { create } from "zustand";
import type { LessonPage } from "../../course/progress.ts";

/** Whether the course stands in place of the start page, and what of it. Undo does not touch it. */
export interface CoursePlace {
  readonly shown: boolean;
  /** Id of the open lesson; null shows the list of all. */
  readonly lesson: string | null;
  readonly page: LessonPage;
  /** What the page is called while it shows this. */
  readonly title: string;
}

export const useCoursePlace = create<CoursePlace>(() => ({ shown: false, lesson: null, page: 1, title: "" }));

export const hideCourse = (): void => useCoursePlace.setState({ shown: false });
