import { expect, test } from "vitest";
import { courseModules } from "../../scripts/course-index.ts";
import { outlineSchema } from "../../src/course/outline.ts";
import { lessonsOnPath } from "../../src/course/path.ts";
import { LESSON_LANGUAGES } from "../../src/i18n/languages.ts";
import type { CourseIndex } from "../../src/app/records/course/content.ts";
import file from "../../src/course/outline.json";

const { lessons } = JSON.parse(
  courseModules()["virtual:course-index/en"]?.replace(/^export const index = |;$/g, "") ?? "",
) as CourseIndex;
const { chapters, paths } = outlineSchema.parse(file);

test("each lesson is in one chapter, in the order of the course", () =>
  expect(chapters.flatMap((chapter) => chapter.lessons)).toEqual(lessons.map(({ id }) => id)));

test("chapters and paths have texts in all languages of the lessons", () => {
  for (const { words } of [...chapters, ...paths]) expect(Object.keys(words)).toEqual([...LESSON_LANGUAGES]);
});

test.each(paths)("path $id has lessons of the course in their order, each with two of its exercises", (path) => {
  const found = lessonsOnPath(lessons, path);
  expect(found.map(({ id, tasks }) => [id, tasks.map((task) => task.id).toSorted()])).toEqual(
    path.lessons.map(({ lesson, tasks }) => [lesson, tasks.toSorted()]),
  );
  expect(found.map(({ number }) => number)).toEqual(found.map(({ number }) => number).toSorted((a, b) => a - b));
  for (const { tasks } of found) expect(tasks.length).toBe(2);
});

test("three parts take an hour", () => {
  const path = paths.find(({ id }) => id === "hour") ?? null;
  const seconds = lessonsOnPath(lessons, path).flatMap((lesson) => [
    lesson.seconds,
    ...lesson.tasks.map((task) => task.seconds),
  ]);
  const minutes = seconds.reduce((a, b) => a + b, 0) / 60;
  expect(path?.lessons.length).toBe(6);
  expect(minutes).toBeGreaterThan(45);
  expect(minutes).toBeLessThan(70);
});

test("the index lists the questions of each lesson by their pages", () => {
  const first = lessons.find(({ questions }) => questions.length > 0);
  expect(new Set(first?.questions.map(({ id }) => id)).size).toBe(first?.questions.length);
  for (const { pages, questions } of lessons)
    for (const { page } of questions) expect(page >= 1 && page <= pages).toBe(true);
  expect(lessons.flatMap(({ questions }) => questions).length).toBeGreaterThan(20);
});
