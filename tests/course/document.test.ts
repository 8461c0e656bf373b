import { describe, expect, test } from "vitest";
import { RULES } from "../../src/course/judge/judgement.ts";
import { readTask } from "../../src/course/read-task.ts";
import { taskSchema } from "../../src/course/task.ts";
import { taskProblems } from "../../src/course/course-problems.ts";
import { projectFile } from "../sources.ts";
import { fieldsOf, neededFields, type Schema } from "./fields.ts";

/** The names in the first column of the tables of a section. */
function named(section: string): string[] {
  const text =
    projectFile("docs/tasks.md")
      .split(/^## /m)
      .find((part) => part.startsWith(section)) ?? "";
  return [...text.matchAll(/^\| `([^`]+)` \|/gm)].map(([, name = ""]) => name);
}

describe("docs/tasks.md", () => {
  test("names every field of a task and no other", () => {
    const fields = fieldsOf(taskSchema as unknown as Schema);
    expect(fields).toContain("part.threads[].pitch");
    expect(fields).toContain("rules.values[].q");
    expect(named("Fields").toSorted()).toEqual(fields.toSorted());
  });

  test("states for every field whether it is required", () => {
    const said = [...projectFile("docs/tasks.md").matchAll(/^\| `([^`]+)` \| needed/gm)].map(([, name = ""]) => name);
    expect(said.toSorted()).toEqual(neededFields(taskSchema as unknown as Schema).toSorted());
  });

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
