import type { Run } from "../../program/state/run-types.ts";

/** What runs at a moment: cycle and roughing pass (0 while positioning, -1 while finishing), out of how many. */
export interface RunningPass {
  readonly cycle: number;
  readonly pass: number;
  readonly passes: number;
}

/** The pass at a step of a run; between two cycles, the positioning for the next one. */
export function runningPass({ steps, operations }: Run, index: number): RunningPass {
  const step = steps[Math.min(index, steps.length - 1)];
  const own = step?.operation ?? null;
  const operation = own === null ? operations.find(({ firstStep }) => firstStep >= index) : operations[own];
  const of = operation ?? operations.at(-1);
  const cuts = own !== null && step !== undefined && step.move.kind !== "rapid";
  const pass = !cuts ? 0 : step.move.run === "finish" ? -1 : (step.move.pass ?? 0);
  return { cycle: of?.cycle ?? 0, pass, passes: Math.max(pass, of?.plan.passes ?? 0) };
}
