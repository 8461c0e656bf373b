import { courseIndexOf } from "virtual:course-index";
import { lessonSchema, type Lesson } from "../../../course/lesson.ts";
import type { CoursePath } from "../../../course/outline.ts";
import { taskSchema, type Task } from "../../../course/task.ts";
import { retryImport } from "../../base/parts.ts";
import { byLanguage } from "../../base/settings/loaded-texts.ts";
import { useByLanguage } from "../../base/settings/use-texts.ts";

/** Entry of a task in the lesson list. */
export interface TaskEntry {
  readonly id: string;
  readonly kind: Task["kind"];
  readonly title: string;
  /** Estimated time to solve it. */
  readonly seconds: number;
}

/** Entry of a lesson in the list. */
export interface LessonEntry {
  readonly id: string;
  readonly number: number;
  readonly title: string;
  readonly aim: string;
  readonly pages: number;
  /** Estimated time to study its pages. */
  readonly seconds: number;
  /** The questions on its pages, each by its page, from 1. */
  readonly questions: readonly { readonly id: string; readonly page: number }[];
  readonly tasks: readonly TaskEntry[];
}

/** Index of the course: its chapters and paths by the ids of their lessons, and all lessons without their content. */
export interface CourseIndex {
  readonly chapters: readonly { readonly id: string; readonly title: string; readonly lessons: readonly string[] }[];
  readonly paths: readonly (CoursePath & { readonly title: string; readonly about: string })[];
  readonly lessons: readonly LessonEntry[];
}

/** The list of lessons, in the screen language. */
export const courseIndex = byLanguage(courseIndexOf);
export const useCourseIndex = (): CourseIndex => useByLanguage(courseIndex);

const lessons = import.meta.glob<unknown>("../../../course/lessons/*.json", { import: "default" });
const tasks = import.meta.glob<unknown>("../../../course/tasks/*.json", { import: "default" });

const found = (files: typeof lessons, ends: (name: string) => boolean) =>
  Object.entries(files).find(([path]) => ends(path.slice(path.lastIndexOf("/") + 1, -".json".length)))?.[1];

/** Whether a task of this id ships with the page. */
const shipsWithPage = (id: string): boolean => found(tasks, (name) => name === id) !== undefined;

/** Longest id that leaves room for a prefix. */
const LONGEST_OWN = 57;

/**
 * An imported task. An id that a course task has is replaced, always in the same way, so that progress, works and
 * results of the two stay apart.
 */
export const fromOutside = (task: Task): Task =>
  shipsWithPage(task.id) ? { ...task, id: `own-${task.id.slice(0, LONGEST_OWN)}` } : task;

/** A lesson of the course; null where there is none of this id. */
export async function fetchLesson(id: string): Promise<Lesson | null> {
  const fetch = found(lessons, (name) => name.replace(/^\d\d-/, "") === id);
  return fetch ? lessonSchema.parse(await retryImport(fetch)) : null;
}

/** A task of the course; null where there is none of this id. */
export async function fetchTask(id: string): Promise<Task | null> {
  const fetch = found(tasks, (name) => name === id);
  return fetch ? taskSchema.parse(await retryImport(fetch)) : null;
}
