import { describe, expect, test } from "vitest";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { startOfTask, toolsOfTask } from "./task-start.ts";
import { taskSchema, TASK_FORMAT, type Task } from "./task.ts";

const task = (more: Partial<Record<keyof Task, unknown>>): Task =>
  taskSchema.parse({
    format: TASK_FORMAT,
    id: "first-shoulder",
    kind: "make",
    words: { en: { title: "A", ask: "B", hints: ["1", "2", "3"] } },
    ...more,
  });

describe("the start of a task", () => {
  test("a cycle has only the given values", () => {
    const start = startOfTask(
      task({ start: { cycle: 811, values: { Q460: "1.7" }, tool: 3, at: { x: "83.4", z: "2.6" } } }),
    );
    expect(start).toMatchObject({
      kind: "job",
      job: {
        name: "FIRST-SHOULDER",
        cycle: 811,
        drafts: { 811: { Q460: "1.7" } },
        tool: 3,
        start: { x: "83.4", z: "2.6" },
        blank: { outside: "", bore: "", length: "", allowance: "" },
      },
    });
  });

  test("a contour becomes rows of its table, with corners between its lines", () => {
    const start = startOfTask(
      task({ start: { cycle: 810, contour: ["L X+21.3 Z+0", "RND R1.4", "L Z-17.9", "L X+44"] } }),
    );
    if (start.kind !== "job") throw new Error("no job");
    expect(start.job.contour.map(({ kind, x, z, r }) => [kind, x, z, r])).toEqual([
      ["L", "21.3", "0", ""],
      ["RND", "", "", "1.4"],
      ["L", "", "-17.9", ""],
      ["L", "44", "", ""],
    ]);
  });

  test("a program is unchanged and keeps its own name: the task's name might reveal the fault", () =>
    expect(startOfTask(task({ start: { program: ["0 BEGIN PGM A MM", "1 END PGM A MM"] } }))).toEqual({
      kind: "program",
      name: "A.h",
      text: "0 BEGIN PGM A MM\n1 END PGM A MM\n",
    }));

  test("its name has no lesson number, since lessons may move", () =>
    expect([
      startOfTask(task({ id: "l12-820-empty", start: { empty: true } })),
      startOfTask(task({ id: "l12-cap", start: { cycle: 812 } })),
    ]).toMatchObject([
      { name: "820-EMPTY.h", text: expect.stringContaining("BEGIN PGM 820-EMPTY MM") as string },
      {
        job: { name: "CAP" },
      },
    ]));

  test("an empty program has the blank of the part and runs to its end", () => {
    const start = startOfTask(
      task({ start: { empty: true }, part: { blank: ["BLK FORM CYLINDER Z D63.4 L71 DIST+0.8 DI12"] } }),
    );
    if (start.kind !== "program") throw new Error("no program");
    const ran = run(parse(start.text), { tools: shippedTools, rapid: 9000 });
    expect(ran.issues).toEqual([]);
    expect(Math.max(...ran.blank.flat().map(({ r }) => r))).toBeCloseTo(31.7, 6);
  });
});

test("a task offers the shipped tools that it allows", () => {
  const all = toolsOfTask(task({ start: { empty: true } }));
  expect(all.length).toBe(shippedTools.length);
  expect(
    toolsOfTask(task({ start: { empty: true }, rules: { tools: [3, 1, 9999] } })).map((entry) => entry.cells.T),
  ).toEqual(["1", "3"]);
});
