import { expect, test } from "vitest";
import { courseModules } from "../../scripts/course-index.ts";
import { CHAPTERS, PATHS } from "../../src/course/outline.ts";
import { lessonsOnPath } from "../../src/course/path.ts";
import type { CourseIndex } from "../../src/app/records/course/content.ts";

const index = JSON.parse(
  courseModules()["virtual:course-index/en"]?.replace(/^export const index = |;$/g, "") ?? "",
) as CourseIndex;

test("each lesson is in one chapter, in the order of the course", () =>
  expect(CHAPTERS.flatMap(({ lessons }) => lessons)).toEqual(index.lessons.map(({ id }) => id)));

test.each(PATHS)("path $id has lessons of the course in their order, each with two of its exercises", (path) => {
  const found = lessonsOnPath(index.lessons, path);
  expect(found.map(({ id, tasks }) => [id, tasks.map((task) => task.id).sort()])).toEqual(
    path.lessons.map(({ lesson, tasks }) => [lesson, [...tasks].sort()]),
  );
  expect(found.map(({ number }) => number)).toEqual(found.map(({ number }) => number).sort((a, b) => a - b));
  for (const { tasks } of found) expect(tasks.length).toBe(2);
});

test("three parts take an hour", () => {
  const seconds = lessonsOnPath(index.lessons, PATHS[0]).flatMap((lesson) => [
    lesson.seconds,
    ...lesson.tasks.map((task) => task.seconds),
  ]);
  const minutes = seconds.reduce((a, b) => a + b, 0) / 60;
  expect(minutes).toBeGreaterThan(45);
  expect(minutes).toBeLessThan(70);
});
