import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import type { Slip } from "../../src/course/judge/judgement.ts";
import {
  BY_DIMENSIONS,
  everySlip,
  findSlip,
  hasSlip,
  wantedSizes,
  withoutSlip,
  withSlip,
} from "../../src/course/judge/slips.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { taskSchema, type Task } from "../../src/course/task.ts";

const folder = new URL("../../src/course/tasks/", import.meta.url);
const tasks = readdirSync(folder).map((file) =>
  taskSchema.parse(JSON.parse(readFileSync(new URL(file, folder), "utf8"))),
);
const runOf = (text: string) => Promise.resolve(answerOf(text));

/** The slip that a change makes: its reverse is what the learner has to be told. */
const UNDONE: Readonly<Record<Slip["kind"], Slip["kind"]>> = {
  sign: "sign",
  exchanged: "exchanged",
  reversed: "reversed",
  radius: "doubled",
  doubled: "radius",
  tools: "tools",
  tool: "tool",
};
const reverse = ({ kind, values }: Slip): Slip => ({
  kind: UNDONE[kind],
  values: values.map(({ value, better, ...where }) => ({ ...where, value: better, better: value })),
});

/** Whether a slip is one in a size of the part: of the start points, nobody doubles one. */
function isInSize(task: Task, { kind, values }: Slip): boolean {
  const { x, z } = wantedSizes(task);
  const sizes = kind === "sign" ? z : kind === "exchanged" ? [...x, ...z] : x;
  return values.every(({ value }) => kind === "reversed" || sizes.some((size) => Math.abs(size - value) < 0.001));
}

/** One slip of each kind in the solution of a task, if the part suffers from it. */
function planted({ solution = [], ...task }: Task): readonly { readonly slip: Slip; readonly text: string }[] {
  const found = new Map<Slip["kind"], { readonly slip: Slip; readonly text: string }>();
  for (const { slip, text } of everySlip(programOfLines(solution))) {
    const told = reverse(slip);
    if (found.has(told.kind) || !isInSize(task, slip)) continue;
    const suffers = judge(task, answerOf(text)).marks.some(({ passed, rule }) => !passed && BY_DIMENSIONS.has(rule));
    if (suffers) found.set(told.kind, { slip: told, text });
  }
  return [...found.values()];
}

describe("a slip in a task's solution is the first that a check names, with its value", () => {
  test.each(tasks.filter(({ solution }) => solution).map((task) => [task.id, task] as const))("%s", async (_, task) => {
    for (const { slip, text } of planted(task)) {
      const answer = answerOf(text),
        judgement = judge(task, answer);
      const found = await findSlip(task, answer, judgement, runOf);
      expect(found?.slip).toEqual(slip);
      if (found) expect(withSlip(judgement, found).marks[0]?.slip).toEqual(slip);
    }
  });
});

test("the tasks together plant every kind of slip", () => {
  const kinds = new Set(
    tasks.filter(({ id }) => /^l0[59]/.test(id)).flatMap((task) => planted(task).map(({ slip }) => slip.kind)),
  );
  expect([...kinds].toSorted()).toEqual(["doubled", "exchanged", "radius", "reversed", "sign"]);
});

const taskOf = (id: string): Task => {
  const task = tasks.find((each) => each.id === id);
  if (!task) throw new Error(`no task ${id}`);
  return task;
};

test("a wrong part without a slip has none, and a right one is not searched", async () => {
  const task = taskOf("l03-first-shoulder");
  const right = programOfLines(task.solution ?? []);
  const slipOf = async (text: string) => {
    const answer = answerOf(text);
    return findSlip(task, answer, judge(task, answer), runOf);
  };
  expect(await slipOf(right.replace("Q493=+48.2", "Q493=+51.7"))).toBeNull();
  expect(await slipOf(right.replace("Q494=-27.4", "Q494=-19.6"))).toBeNull();
  const none = () => Promise.reject(new Error("a right part is searched"));
  const answer = answerOf(right);
  expect(await findSlip(task, answer, judge(task, answer), none)).toBeNull();
});

test.each([
  ["l15-retaining-ring", { Q491: 25, Q493: 23.5 }, "radius"],
  ["l05-chamfered-seat", { Q491: 132, Q493: 105.6 }, "doubled"],
] as const)("%s: all diameters of the cycle are named: %j", async (id, values, kind) => {
  const task = taskOf(id);
  const text = Object.entries(values).reduce(
    (now, [q, value]) => now.replace(new RegExp(String.raw`\b${q}=\S+`), `${q}=+${value}`),
    programOfLines(task.solution ?? []),
  );
  const answer = answerOf(text);
  const slip = (await findSlip(task, answer, judge(task, answer), runOf))?.slip;
  expect(slip?.kind).toBe(kind);
  expect(slip?.values.map(({ q, value }) => [q, value])).toEqual(Object.entries(values));
});

test("what the slip causes is not reported beside it; a slip that the task itself contains is not named", async () => {
  const shoulder = taskOf("l03-first-shoulder");
  const answer = answerOf(programOfLines(shoulder.solution ?? []).replace("Q494=-27.4", "Q494=+27.4"));
  const judgement = judge(shoulder, answer);
  expect(judgement.marks.filter(({ passed, rule }) => !passed && rule === "errors")).toHaveLength(1);
  const found = await findSlip(shoulder, answer, judgement, runOf);
  const told = found && withSlip(judgement, found).marks.filter(({ passed }) => !passed);
  expect(told?.map(({ rule, issue }) => (issue ? issue.code : rule)).slice(0, 2)).toEqual(["errors", "residue"]);

  const fault = taskOf("l20-diameter-as-radius");
  const text = "program" in fault.start ? programOfLines(fault.start.program) : "";
  const unmended = answerOf(text);
  const slip = (await findSlip(fault, unmended, judge(fault, unmended), runOf))?.slip;
  expect(slip?.kind).toBe("radius");
  expect(slip && hasSlip(fault, text, slip)).toBe(true);
  expect(slip && hasSlip(fault, programOfLines(fault.solution ?? []), slip)).toBe(false);
});

describe("the tools are named first where they explain the fault", () => {
  const swapped = (task: Task, one: number, other: number) =>
    programOfLines(task.solution ?? []).replaceAll(/TOOL CALL (\d+)/g, (call, tool) =>
      Number(tool) === one ? `TOOL CALL ${other}` : Number(tool) === other ? `TOOL CALL ${one}` : call,
    );
  test.each([
    // Roughing and finishing, with the sides of the part.
    ["l07-second-tool", [1, 3], "tools"],
    ["l07-tools-exchanged", [1, 3], "tools"],
    // Facing and boring.
    ["l22-hub-flange", [15, 5], "tools"],
    // An outside tool in a bore, and an inside one outside.
    ["l17-bush", [5, 1], "tool"],
    ["l03-first-shoulder", [1, 5], "tool"],
    ["l14-852-values", [8, 10], "tool"],
  ] as const)("%s: %j", async (id, [one, other], kind) => {
    const task = taskOf(id);
    const answer = answerOf(swapped(task, one, other));
    const judgement = judge(task, answer);
    expect(judgement.passed).toBe(false);
    const found = await findSlip(task, answer, judgement, runOf);
    expect(found?.slip.kind).toBe(kind);
    expect(found?.slip.values.map(({ value }) => value)).toEqual(
      kind === "tools" ? expect.arrayContaining([one, other]) : [other],
    );
    expect(found && withSlip(judgement, found).marks[0]?.slip).toEqual(found?.slip);
  });
});

test("a refused tool that no slip explains is to blame itself", async () => {
  const fault = taskOf("l02-wrong-row");
  const unmended = answerOf("program" in fault.start ? programOfLines(fault.start.program) : "");
  const judgement = judge(fault, unmended);
  expect(await findSlip({ ...fault, solution: undefined }, unmended, judgement, runOf)).toBeNull();
  expect(withoutSlip(judgement).marks[0]).toMatchObject({ issue: { code: "toolUnfit" }, isByTool: true });
});
