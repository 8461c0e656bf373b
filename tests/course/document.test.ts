import { describe, expect, test } from "vitest";
import { RULES } from "../../src/course/judge/judgement.ts";
import { readTask } from "../../src/course/read-task.ts";
import { setSchema } from "../../src/course/task-set.ts";
import { taskSchema } from "../../src/course/task.ts";
import { taskProblems } from "../../src/course/course-problems.ts";
import { projectFile } from "../sources.ts";
import { fieldsOf, neededFields, type Schema } from "./fields.ts";

const sectionOf = (section: string): string =>
  projectFile("docs/tasks.md")
    .split(/^## /m)
    .find((part) => part.startsWith(section)) ?? "";
/** The names in the first column of the tables of a section. */
const named = (section: string): string[] =>
  [...sectionOf(section).matchAll(/^\| `([^`]+)` \|/gm)].map(([, name = ""]) => name);
/** The fields of a set itself: those of its tasks are in the table of a task. */
const ofSet = (fields: readonly string[]) => fields.filter((field) => !field.startsWith("tasks["));
const own = (fields: readonly string[]) => fields;

describe.each([
  ["Fields", taskSchema, own, "part.threads[].pitch"],
  ["Sets", setSchema, ofSet, "exam.reports"],
])("docs/tasks.md, %s", (section, schema, only, one) => {
  test("names every field and no other", () => {
    const fields = only(fieldsOf(schema as unknown as Schema));
    expect(fields).toContain(one);
    expect(named(section).toSorted()).toEqual(fields.toSorted());
  });

  test("states for every field whether it is required", () => {
    const said = [...sectionOf(section).matchAll(/^\| `([^`]+)` \| needed/gm)].map(([, name = ""]) => name);
    expect(said.toSorted()).toEqual(only(neededFields(schema as unknown as Schema)).toSorted());
  });
});

describe("docs/tasks.md", () => {
  test("names every rule", () => expect(named("How an answer is judged")).toEqual([...RULES]));

  const examples = [...projectFile("docs/tasks.md").matchAll(/```json\n([\s\S]*?)```/g)].map(
    ([, text = ""]) => JSON.parse(text) as unknown,
  );

  test("has an example of each kind", () =>
    expect(new Set(examples.map((raw) => taskSchema.parse(raw).kind))).toEqual(
      new Set(["make", "fault", "predict", "drawing"]),
    ));

  test.each(examples)("shows a task that opens completely and is right: %#", (raw) => {
    const task = taskSchema.parse(raw);
    expect(readTask(raw)).toEqual({ task, left: [] });
    expect(taskProblems(task, `${task.id}.json`).filter((p) => !/^no (?:words in|wrong answer)/.test(p))).toEqual([]);
  });
});
