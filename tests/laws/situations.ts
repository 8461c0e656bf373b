import type fc from "fast-check";
import type { Cycle } from "../../src/cycles/define.ts";
import { catalogue } from "../../src/cycles/index.ts";
import type { Plan, Setting } from "../../src/kernel/plan.ts";
import type { Step } from "../../src/kernel/step.ts";
import { simulate } from "../../src/sim/simulate.ts";
import { contour } from "./contours.ts";
import { recess } from "./recesses.ts";
import { shoulder } from "./shoulders.ts";
import type { Situation } from "./situation.ts";

export type { Situation } from "./situation.ts";

/** Random situations by the group of a cycle: a new cycle of a known group is tested before anyone writes a test for it. */
const byGroup: Record<Cycle["group"], fc.Arbitrary<Situation>> = { shoulder, recessTurning: recess, contour };

/** The cycles of the catalogue, each with its random situations for one machining operation (Q215). */
export const situations = (operation: number): { cycle: Cycle; arbitrary: fc.Arbitrary<Situation> }[] =>
  catalogue.map((cycle) => ({ cycle, arbitrary: byGroup[cycle.group].map((s) => doing(s, operation)) }));

/** A situation with another machining operation. */
export const doing = (s: Situation, operation: number): Situation => ({ ...s, values: { ...s.values, Q215: operation } });

/** Plans a situation. `first`: nothing has cut the blank yet, so what stands there is known. */
export function planOf(cycle: Cycle, s: Situation, first = true): Plan {
  const setting: Setting = { tool: s.tool, start: s.start, feedUnit: "mm/rev", autoFeed: null, stock: first ? s.blank : null };
  return cycle.plan(s.values as never, setting, s.given);
}

/** The motions of plans that follow each other from the same start point. */
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

/** Simulates plans in the blank of their situation, one after the other. */
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

/** The plan says that it moves through the material because the start point stands there, or that it may. */
export const startsBadly = (plan: Plan) =>
  plan.issues.some((i) => ["startInArea", "startInMaterial", "startInsideEnvelope", "startBelowContour"].includes(i.code));
