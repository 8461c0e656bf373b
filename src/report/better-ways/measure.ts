import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import { DEFLECTION } from "../advice/stability.ts";
import { bendingOf, isBent } from "./bending.ts";
import type { Attempt } from "./situation.ts";
import { usesOf } from "./uses.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/**
 * What a way is measured by: s, tools, tool changes, residual material in mm², and the greatest deflection of the
 * workpiece under a roughing pass, mm.
 */
export interface Measure {
  readonly seconds: number;
  readonly tools: number;
  readonly changes: number;
  readonly residual: number;
  readonly bending: number;
}

/** Residual material that no value asks for, mm². */
const residualArea = (residual: Simulation["proof"]["residual"]): number =>
  residual.reduce((sum, { area, isAsked }) => (isAsked ? sum : sum + area), 0);

/** What the run alone measures. */
export function measureOfRun(run: Run): Pick<Measure, "seconds" | "tools" | "changes"> {
  const { tools, changes } = usesOf(run);
  return { seconds: run.seconds, tools: tools.length, changes };
}

/** What a program measures in a material. */
export const measureOf = (attempt: Attempt, material: CutMaterial): Measure => ({
  ...measureOfRun(attempt.run),
  residual: residualArea(attempt.simulation.proof.residual),
  bending: bendingOf(attempt, material),
});

/** Gains in the order in which they are named: several may hold for one way. */
export const GAINS = ["verdict", "residual", "bending", "tools", "changes", "seconds"] as const;
export type Gain = (typeof GAINS)[number];

/**
 * Smaller differences are no gain: s and share of the running time, of a long program no more than some s; mm²; mm of
 * deflection.
 */
export const LEAST = { seconds: 1, share: 0.01, longSeconds: 5, residual: 0.05, bending: 0.01 } as const;

/** Whether a time is measurably shorter than another one, s. */
export const isShorter = (seconds: number, than: number): boolean =>
  than - seconds >= Math.max(LEAST.seconds, Math.min(LEAST.longSeconds, LEAST.share * than));

/** The gains of one measure over another. */
export function gainsOf(before: Measure, after: Measure): readonly Gain[] {
  const gained: Readonly<Record<Exclude<Gain, "verdict">, boolean>> = {
    residual: before.residual - after.residual >= LEAST.residual,
    bending: isBent(before.bending) && before.bending - after.bending >= LEAST.bending,
    tools: after.tools < before.tools,
    changes: after.changes < before.changes,
    seconds: isShorter(after.seconds, before.seconds),
  };
  return GAINS.filter((gain) => gain !== "verdict" && gained[gain]);
}

/**
 * What gains are worth, s: a better verdict, a mm² of residual material, as much less deflection as roughing may have, a
 * tool to set up, a tool change.
 */
export const WORTH = { verdict: 600, residual: 60, bending: 120, tool: 60, change: 10 } as const;

/** The worth of a way in seconds: offers are sorted by it, and one that is worth nothing is none. */
export const worthOf = (before: Measure, after: Measure, gains: readonly Gain[]): number =>
  (gains.includes("verdict") ? WORTH.verdict : 0) +
  (before.seconds - after.seconds) +
  WORTH.residual * (before.residual - after.residual) +
  (gains.includes("bending") ? (WORTH.bending * (before.bending - after.bending)) / DEFLECTION.rough : 0) +
  WORTH.tool * (before.tools - after.tools) +
  WORTH.change * (before.changes - after.changes);
