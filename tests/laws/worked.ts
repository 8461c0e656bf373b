import type { Cycle } from "../../src/cycles/define.ts";
import type { Plan } from "../../src/kernel/plan/plan.ts";
import { part, type Ring } from "../../src/kernel/geometry/point.ts";
import type { Simulation } from "../../src/sim/simulation.ts";
import type { P } from "../judge/insert.ts";
import { gridOver, judge, type Verdict } from "../judge/judge.ts";
import { doing, type Situation } from "./situation.ts";
import { planOf, simulated, stepsOf } from "./worked-plans.ts";

const { flattenedChain } = part;

/** Width of the columns, mm. Both judges treat areas thinner than this and shallower than THIN as equal. */
export const WIDTH = 0.05;

/** A situation with everything that the laws need. */
export interface Worked {
  readonly cycle: Cycle;
  readonly situation: Situation;
  /** The plans in order; the last one is the operation in question. */
  readonly plans: readonly Plan[];
  readonly simulation: Simulation;
  readonly verdicts: readonly Verdict[];
}

/** The finished part as the contour alone defines it: the area behind the contour, away from its open side. */
function behind(plan: Plan): P[] {
  const line = flattenedChain(plan.contour, 0.0005);
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return [];
  const far = 1000;
  const away = (p: P): P => ({ z: p.z - plan.openSide.z * far, r: p.r - plan.openSide.r * far });
  return [...line, away(last), away(first)];
}

/** The area that no motion may cut: the part of the last operation. */
export function partOf(plans: readonly Plan[]): P[][] {
  const last = plans.at(-1);
  return last && last.contour.length > 0 ? [behind(last)] : [];
}

/** Plans, cuts and judges a situation. */
export function worked(cycle: Cycle, situation: Situation, width = WIDTH): Worked {
  const operation = situation.values["Q215"] ?? 0;
  const plans = (operation >= 2 ? [1, operation] : [operation]).map((o, i) =>
    planOf(cycle, doing(situation, o), i === 0),
  );
  const steps = stepsOf(plans, situation);
  const verdicts = (["z", "r"] as const).map((along) =>
    judge(situation.blank, steps, partOf(plans), gridOver(situation.blank, along, width)),
  );
  return { cycle, situation, plans, simulation: simulated(plans, situation), verdicts };
}

/** The loose pieces, wherever they were. */
export const looseOf = ({ simulation }: Worked): readonly Ring[] =>
  simulation.proof.loose.flatMap(({ rings }) => rings);
