/// <reference types="node" />
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, test } from "vitest";
import { drawnTask } from "../../../course/drawn-task.ts";
import { taskSchema, type Task } from "../../../course/task.ts";
import { TASK_RAPID } from "../../../course/judge/shop.ts";
import { courseDrawing } from "../../../i18n/en/course-drawing.ts";
import { parse } from "../../../nc/parse.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { forMaker } from "../../../view/drawing/maker.ts";
import { partDrawing } from "../../../view/drawing/part-drawing.ts";
import { printWords } from "./print-words.ts";
import { sourceOfSize } from "./size-source.ts";

const folder = fileURLToPath(new URL("../../../course/tasks/", import.meta.url));
const tasks = readdirSync(folder)
  .map((file) => taskSchema.parse(JSON.parse(readFileSync(folder + file, "utf8"))))
  .filter(({ part, solution }) => part && solution);
const taskOf = (id: string): Task => {
  const found = tasks.find((task) => task.id === id);
  if (!found) throw new Error(id);
  return found;
};

/** The measured sizes of a task's drawing, each with what makes it in a program. */
function sourcesIn(task: Task, lines: readonly string[] = task.solution ?? []) {
  const drawn = drawnTask(task);
  const print = drawn && partDrawing(forMaker(drawn, printWords(courseDrawing, "en")), { width: 150, height: 128 });
  const done = run(parse(lines.join("\n")), { tools: shippedTools, rapid: TASK_RAPID });
  return (print?.list ?? []).flatMap(({ size, measures }) =>
    measures ? [{ size: size.text, source: sourceOfSize(done, measures) }] : [],
  );
}
describe("what makes a size of a drawing", () => {
  test("a value of a cycle: two positions, and a corner at the right end", () => {
    const shoulder = sourcesIn(taskOf("l03-first-shoulder"));
    expect(shoulder.map(({ size, source }) => [size, source?.q])).toEqual([
      ["⌀48.2±0.03", "Q493"],
      ["27.4±0.05", "Q494"],
    ]);
  });

  test("nothing, while the program has another value", () => {
    const task = taskOf("l03-first-shoulder");
    const half = task.solution?.map((line) => line.replace("Q493=+48.2", "Q493=+24.1"));
    expect(sourcesIn(task, half).map(({ source }) => source?.q ?? null)).toEqual([null, "Q494"]);
  });

  test.each([
    ["27.99", "L Z-48"],
    ["28", "L Z-48"],
    ["27.96", null],
  ])("⌀28 0/-0.021 is made by ⌀%s in: %s", (value, block) => {
    const task = taskOf("l26-valve-spindle");
    const lines = (task.solution ?? []).map((line) => line.replace("X+27.99 ", `X+${value} `));
    const source = sourcesIn(task, lines).find(({ size }) => size === "⌀28")?.source ?? null;
    expect(source && "line" in source.at ? lines[source.at.line - 1]?.replace(/^\d+ /, "") : null).toBe(block);
  });

  test("the end of a cone follows from several values: the cycle as a whole", () => {
    const made = sourcesIn(taskOf("l06-taper-one-to-twelve")).find(({ size }) => size.startsWith("⌀48.625"))?.source;
    expect(made?.q).toBeNull();
    expect(made && "line" in made.at && taskOf("l06-taper-one-to-twelve").solution?.[made.at.line - 1]).toMatch(
      /CYCL DEF/,
    );
  });

  /** Sizes that the blank has already, where an outline runs out, or that only the tip path of hand-written blocks makes. */
  const UNMADE: Readonly<Record<string, readonly string[]>> = {
    "l10-clamp-limit": ["7.4"],
    "l14-842-oil-groove": ["50"],
    "l15-bent-blade": ["50"],
    "l15-jammed-chip": ["30"],
    "l15-retaining-ring": ["45"],
    "l16-into-the-collar": ["⌀24.7", "23.5", "1.5×45°"],
    "l17-way-out": ["1×45°"],
    "l18-finish-neck": ["R1"],
    "l18-ps-behind-the-collar": ["R1"],
    "l19-another-size": ["2× R0.8"],
  };
  test.each(tasks.map((task) => [task.id, task] as const))(
    "each size of %s has its source in the solution",
    (id, task) => {
      const without = sourcesIn(task).filter(({ source }) => source === null);
      expect(without.map(({ size }) => size)).toEqual(UNMADE[id] ?? []);
    },
  );
});
