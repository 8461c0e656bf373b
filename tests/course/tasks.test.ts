import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { lessonProblems, taskProblems } from "../../src/course/course-problems.ts";
import { lessonSchema } from "../../src/course/lesson.ts";
import { taskSchema } from "../../src/course/task.ts";

const folder = (name: string) => fileURLToPath(new URL(`../../src/course/${name}/`, import.meta.url));
const filesIn = (name: string) => readdirSync(folder(name)).filter((file) => file.endsWith(".json"));
const dataOf = (name: string, file: string): unknown => JSON.parse(readFileSync(`${folder(name)}${file}`, "utf8"));

const [tasks, lessons] = [filesIn("tasks"), filesIn("lessons")];

describe("tasks that ship with the page", () => {
  it("have names of their own", () => expect(new Set(tasks).size).toBe(tasks.length));

  it.each(tasks)(
    "%s is complete: its solution passes and its wrong answers are refused at the stated place",
    (file) => {
      const read = taskSchema.safeParse(dataOf("tasks", file));
      expect(read.error?.issues ?? []).toEqual([]);
      expect(taskProblems(taskSchema.parse(dataOf("tasks", file)), file)).toEqual([]);
    },
  );
});

describe("lessons that ship with the page", () => {
  it.each(lessons)("%s is complete: a text for each page, and programs that run", (file) => {
    const read = lessonSchema.safeParse(dataOf("lessons", file));
    expect(read.error?.issues ?? []).toEqual([]);
    expect(lessonProblems(lessonSchema.parse(dataOf("lessons", file)), file)).toEqual([]);
  });

  it("are numbered consecutively, and name existing tasks", () => {
    const all = lessons.map((file) => lessonSchema.parse(dataOf("lessons", file)));
    const numbers = all.map((lesson) => lesson.number);
    expect(new Set(numbers).size).toBe(numbers.length);
    expect(new Set(all.map((lesson) => lesson.id)).size).toBe(all.length);
    const known = new Set(tasks.map((file) => file.replace(/\.json$/, "")));
    const named = all.flatMap((lesson) => lesson.tasks);
    expect(named.filter((id) => !known.has(id))).toEqual([]);
    expect(new Set(named).size).toBe(named.length);
  });
});
