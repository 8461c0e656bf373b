import { pathOf, travelOf } from "../../kernel/time/time.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** Rapid rate for the times of tasks, mm/min. */
export const TASK_RAPID = 10_000;

/** Running time of an answer, s, always with the rapid rate of tasks and not with that of the learner's machine. */
export const secondsOfAnswer = ({ simulation }: Answer): number =>
  simulation.steps.reduce(
    (sum, { from, move, seconds }) =>
      sum + (move.kind === "rapid" ? (60 * travelOf(pathOf(from, move))) / TASK_RAPID : seconds),
    0,
  );

/** The columns that distinguish one insert from another. */
const COLUMNS = [
  "RS",
  "DRS",
  "DXL",
  "DZL",
  "T-ANGLE",
  "P-ANGLE",
  "CUTLENGTH",
  "CUTWIDTH",
  "DCW",
] as const satisfies readonly (keyof Tool)[];

/** Tools other than the default ones: their residual material would not match the task. */
export function foreignToolMarks({ run }: Answer): TaskMark[] {
  const found = new Map<number, number>();
  for (const { tool, block } of [...run.operations, ...run.steps.filter((step) => step.operation === null)]) {
    if (found.has(tool.T)) continue;
    const shipped = shippedTools.find(({ T }) => T === tool.T);
    if (!shipped || shipped.TO !== tool.TO || COLUMNS.some((column) => (shipped[column] ?? 0) !== (tool[column] ?? 0)))
      found.set(tool.T, block);
  }
  return [...found].map(([about, block]) => ({ rule: "tools", passed: false, about, block }));
}
