import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { answerOf } from "../judge/answer.ts";
import { judge } from "../judge/judge.ts";
import { possibleFaults, withFaults } from "./faults.ts";
import { linesOfText, proposedTask, programOfMade, promptsOf, taskOfMade, type MadeTask } from "./made-task.ts";

const answer = (name: string) => answerOf(readFileSync(`src/examples/${name}.h`, "utf8"));
const flange = answer("flange"), shoulder = answer("shoulder");
const words: MadeTask["words"] = { title: "Flange, ⌀100!", ask: "Turn it.", hints: ["a", "b", "c"] };

const made = (of: typeof flange, change: Partial<MadeTask> = {}) => {
  const task = taskOfMade({ ...proposedTask(of), words, ...change }, of, "de", "7k");
  if ("length" in task) throw new Error(task.join());
  return task;
};

test.each([["flange", flange], ["shoulder", shoulder]])("a task made of the %s is passed by its own program", (_, of) => {
  const task = made(of);
  expect(judge(task, of).marks.filter(({ passed }) => !passed)).toEqual([]);
  expect(task.id).toBe("flange-100-7k");
});

test("proposed rules hold the numbers of the program", () => {
  const { rules } = made(flange);
  expect(rules.tools).toEqual([15, 1, 3, 5, 6, 8]);
  expect(rules.speed).toBe(3000);
  expect(rules.depth).toBeGreaterThan(1.1);
});

test("what is missing is named", () => {
  expect(taskOfMade({ ...proposedTask(shoulder), outside: "L X+20 Z+0\nCR X+30 Z-40 R2 DR+" }, shoulder, "en", "1")).toEqual([
    "title",
    "ask",
    "hints",
    "part",
  ]);
});

test("prompts begin with the values of the call, without those that are left empty", () => {
  const { start } = made(shoulder, { start: "prompts", prompts: { operation: 0, emptied: ["Q463"] } });
  expect(start).toMatchObject({ cycle: shoulder.run.operations[0]?.cycle });
  const values = "values" in start ? start.values : {};
  expect(Object.keys(values)).toEqual(promptsOf(shoulder, 0).map(([q]) => q).filter((q) => q !== "Q463"));
});

test("each fault changes one line, and the program with it is refused", () => {
  const lines = linesOfText(shoulder.text);
  for (const fault of possibleFaults(lines)) {
    const broken = withFaults(lines, [fault]);
    expect(broken).not.toEqual(lines);
    expect(lines.filter((line) => !broken.includes(line)).length).toBeLessThanOrEqual(1);
  }
  const task = made(shoulder, { kind: "fault", start: "program", faults: ["minus"] });
  const begun = programOfMade({ ...proposedTask(shoulder), faults: ["minus"] }, shoulder);
  expect(task.start).toEqual({ program: begun });
  expect(judge(task, answerOf(begun.join("\n"))).passed).toBe(false);
});
