import { readFileSync } from "node:fs";
import { join } from "node:path";
import { drawnProgram } from "../../src/course/drawn-program.ts";
import { drawnTask } from "../../src/course/drawn-task.ts";
import { answerOf } from "../../src/course/judge/answer.ts";
import { partOfDrawn } from "../../src/course/part-of-drawn.ts";
import { taskSchema } from "../../src/course/task.ts";
import type { HandValues } from "../../src/planning/types.ts";
import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { finishedBody } from "../../src/view/solid/bodies.ts";

/** Parts of the course and of the examples with the machining time of the program that was written by hand, s, without tool changes. */
export const PROGRAMMED_BY_HAND = [
  { source: "tasks", name: "l22-pin", seconds: 68.1 },
  { source: "tasks", name: "l22-clamp-shaft", seconds: 148.1 },
  { source: "tasks", name: "l22-hub-flange", seconds: 199.3 },
  { source: "tasks", name: "l26-valve-spindle", seconds: 78.4 },
  { source: "tasks", name: "l26-bearing-flange", seconds: 194 },
  { source: "tasks", name: "l26-seal-axle", seconds: 191.3 },
  { source: "tasks", name: "l07-second-tool", seconds: 41.8 },
  { source: "tasks", name: "l11-undercut", seconds: 61.2 },
  { source: "tasks", name: "l12-820-contour", seconds: 55.9 },
  { source: "tasks", name: "l13-seal-groove", seconds: 33.6 },
  { source: "tasks", name: "l17-bush", seconds: 59.6 },
  { source: "tasks", name: "l19-another-size", seconds: 39.8 },
  { source: "examples", name: "shaft", seconds: 581.6 },
  { source: "examples", name: "flange", seconds: 282.9 },
] as const;
export type ByHand = (typeof PROGRAMMED_BY_HAND)[number];

const file = (path: string) => readFileSync(join("src", path), "utf8");

const taskOf = (name: string) => taskSchema.parse(JSON.parse(file(`course/tasks/${name}.json`)));

/** The program that was written by hand. */
export const programByHand = ({ source, name }: ByHand): string =>
  source === "examples" ? file(`examples/${name}.h`) : `${(taskOf(name).solution ?? []).join("\n")}\n`;

/** The part that it makes, as its drawing or its contours state it. */
export function partByHand(made: ByHand): FinishedPart {
  const answer = answerOf(programByHand(made)),
    task = made.source === "tasks" ? taskOf(made.name) : null;
  const drawn = task ? drawnTask(task) : drawnProgram(answer, finishedBody(answer.simulation, answer.run.operations));
  const part = drawn && partOfDrawn(drawn, { name: made.name, ...(task?.material && { material: task.material }) });
  if (!part) throw new Error(made.name);
  return part;
}

/** Parameters of a cycle that are cutting values: infeed, feeds, oversizes. */
const CUTTING = ["Q463", "Q478", "Q483", "Q484", "Q505"] as const;

/** The cutting values of a program with constant cutting speed by the number of their tool, the first of each. */
export function valuesByHand(made: ByHand): Readonly<Record<number, HandValues>> {
  const found: Record<number, Record<string, number>> = {};
  let values: Record<string, number> = {};
  for (const line of programByHand(made).split("\n")) {
    const numberIn = (pattern: RegExp) => Number(pattern.exec(line)?.[1]);
    const stated: Readonly<Record<string, number>> = {
      speed: numberIn(/ VC:([\d.]+)/),
      limit: numberIn(/ SMAX([\d.]+)/),
      ...Object.fromEntries(CUTTING.map((q) => [q, numberIn(new RegExp(`${q}=([+\\d.]+)`))])),
    };
    const tool = numberIn(/TOOL CALL (\d+)/);
    if (Number.isFinite(tool)) values = found[tool] ??= {};
    for (const [q, value] of Object.entries(stated)) if (Number.isFinite(value)) values[q] ??= value;
  }
  return found;
}
