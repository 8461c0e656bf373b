import type { Ring } from "../../../kernel/geometry/point.ts";
import type { Program } from "../../../nc/program.ts";
import { startLines } from "../../../nc/program.ts";
import { operationsOf } from "../../../program/edits/operations.ts";
import type { Operation, Run } from "../../../program/state/run-types.ts";
import { playerOf } from "../../../sim/stock.ts";
import type { SpindleDraft } from "../../../program/job/job.ts";
import type { Outcome } from "../../../app/calculation/outcome.ts";

/** The state of a program before an inserted operation. */
export interface StateBefore {
  readonly stock: readonly Ring[];
  readonly operations: readonly Operation[];
}

/** A spindle with the surface speed of the operations before. */
export function spindleLike(spindle: SpindleDraft, operations: readonly Operation[]): SpindleDraft {
  const last = operations.findLast(({ spindle: of }) => of?.kind === "surface")?.spindle;
  return last?.kind === "surface"
    ? { ...spindle, cuttingSpeed: String(last.cuttingSpeed), limit: String(last.limit) }
    : spindle;
}

/** Index of the first step of the main program at or behind a block. */
function firstStepFrom({ stepBlocks, steps }: Run, block: number, end: number): number {
  const found = stepBlocks.findIndex((b) => b >= block && b < end);
  return found < 0 ? steps.length : found;
}

/** Stock and operations before a new operation behind another one; null inserts before all others. */
export function stateBefore({ run, simulation }: Outcome, program: Program, behind: number | null): StateBefore {
  const all = operationsOf(program);
  const until = behind === null ? all.from : (all.units[behind]?.to ?? all.to);
  const line = startLines(program)[until] ?? Infinity;
  const step = firstStepFrom(run, until, all.to);
  return {
    stock: run.steps.length === 0 ? run.blank : playerOf(simulation).at({ step, fraction: 0 }),
    operations: run.operations.filter(({ definedLine }) => definedLine < line),
  };
}
