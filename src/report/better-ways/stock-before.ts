import { intersection } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { simulate } from "../../sim/simulate.ts";
import type { ProgramSituation, TurningUnit } from "./situation.ts";

/** The stock at the call of an operation: the whole of it, and the part that lies in its area. */
export interface StockBefore {
  readonly whole: readonly Ring[];
  readonly inArea: readonly Ring[];
}

/** Cuts the stock again up to an operation. */
export function stockBefore(
  { run }: ProgramSituation,
  { index, operation: { firstStep, plan } }: TurningUnit,
): StockBefore {
  const before = { ...run, steps: run.steps.slice(0, firstStep), operations: run.operations.slice(0, index) };
  const whole = simulate(before).final;
  return { whole, inArea: intersection(whole, [plan.area]) };
}

/** True for a roughing operation whose passes partly touch no stock. */
export const cutsAir = ({ simulation }: ProgramSituation, { index, cycle }: TurningUnit): boolean =>
  cycle.group !== "thread" && (simulation.proof.operations[index]?.airPasses ?? 0) > 0;
