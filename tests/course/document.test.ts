import { describe, expect, test } from "vitest";
import { RULES } from "../../src/course/judge/judgement.ts";
import { taskSchema } from "../../src/course/task.ts";
import { taskProblems } from "../../src/course/whole.ts";
import { projectFile } from "../sources.ts";
import { fieldsOf, type Schema } from "./fields.ts";

/** The names in the first column of the tables of a section. */
function named(section: string): string[] {
  const text = projectFile("docs/tasks.md").split(/^## /m).find((part) => part.startsWith(section)) ?? "";
  return [...text.matchAll(/^\| `([^`]+)` \|/gm)].map(([, name = ""]) => name);
}

describe("docs/tasks.md", () => {
  test("names every field of a task and no other", () => {
    const fields = fieldsOf(taskSchema as unknown as Schema);
    expect(fields).toContain("part.threads[].pitch");
    expect(fields).toContain("rules.values[].q");
    expect(named("Fields").toSorted()).toEqual(fields.toSorted());
  });

  test("names every rule", () => expect(named("How an answer is judged")).toEqual([...RULES]));

  test("shows a task that is right but for its languages", () => {
    const [, example = ""] = /```json\n([\s\S]*?)```/.exec(projectFile("docs/tasks.md")) ?? [];
    const task = taskSchema.parse(JSON.parse(example));
    expect(taskProblems(task, `${task.id}.json`).filter((p) => !p.startsWith("no words in"))).toEqual([]);
  });
});
