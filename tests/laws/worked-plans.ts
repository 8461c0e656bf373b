import type { Cycle } from "../../src/cycles/define.ts";
import type { Plan, PlanContext } from "../../src/kernel/plan/plan.ts";
import type { Step } from "../../src/kernel/time/step.ts";
import { simulate } from "../../src/sim/simulate.ts";
import type { Situation } from "./situation.ts";

/** Plans a situation. `first`: nothing has cut the blank yet, so the stock is known. */
export function planOf(cycle: Cycle, s: Situation, first = true): Plan {
  const setting: PlanContext = {
    tool: s.tool,
    start: s.start,
    feedUnit: "mm/rev",
    autoFeed: null,
    stock: first ? s.blank : null,
  };
  return cycle.plan(s.values as never, setting, s.given);
}

/** The motions of consecutive plans from the same start point. */
export function stepsOf(plans: readonly Plan[], s: Situation): Step[] {
  return plans.flatMap((plan, operation) => {
    let from = s.start;
    return plan.moves.map((move): Step => {
      const step: Step = { from, move, tool: plan.tool ?? s.tool, block: 1, operation, seconds: 1 };
      from = move.to;
      return step;
    });
  });
}

/** Simulates consecutive plans in the blank of their situation. */
export function simulated(plans: readonly Plan[], s: Situation) {
  const steps = stepsOf(plans, s);
  let next = 0;
  const operations = plans.map((plan) => {
    const firstStep = next;
    next += plan.moves.length;
    return { plan, tool: plan.tool ?? s.tool, firstStep, lastStep: next - 1 };
  });
  return simulate({ blank: s.blank, steps, operations, unproved: [] });
}

/** Whether the plan reports that the start point is, or may be, in material. */
export const isStartInMaterial = (plan: Plan) =>
  plan.issues.some((i) =>
    ["startInArea", "startInMaterial", "startInsideEnvelope", "startBelowContour"].includes(i.code),
  );
