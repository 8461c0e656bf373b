import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/** The tools of a run in the order of their first use, and the number of tool changes, the first tool included. */
export interface Uses {
  readonly tools: readonly number[];
  readonly changes: number;
}

export function usesOf({ steps }: Pick<Run, "steps">): Uses {
  const tools = new Set<number>();
  let [changes, last] = [0, NaN];
  for (const { tool } of steps) {
    if (tool.T !== last) changes += 1;
    last = tool.T;
    tools.add(last);
  }
  return { tools: [...tools], changes };
}

/** What a way is measured by: s, tools, tool changes, residual material in mm². */
export interface Measure {
  readonly seconds: number;
  readonly tools: number;
  readonly changes: number;
  readonly residual: number;
}

/** Residual material that no value asks for, mm². */
const residualArea = (residual: Simulation["proof"]["residual"]): number =>
  residual.reduce((sum, { area, isAsked }) => (isAsked ? sum : sum + area), 0);

/** What a run measures with the residual material that it leaves. */
export function measureOf(run: Run, residual: Simulation["proof"]["residual"]): Measure {
  const { tools, changes } = usesOf(run);
  return { seconds: run.seconds, tools: tools.length, changes, residual: residualArea(residual) };
}

/** Gains in the order in which they are named: several may hold for one way. */
export const GAINS = ["verdict", "residual", "tools", "changes", "seconds"] as const;
export type Gain = (typeof GAINS)[number];

/** Smaller differences are no gain: s and share of the running time, of a long program no more than some s; mm². */
export const LEAST = { seconds: 1, share: 0.01, longSeconds: 5, residual: 0.05 } as const;

/** Whether a time is measurably shorter than another one, s. */
export const isShorter = (seconds: number, than: number): boolean =>
  than - seconds >= Math.max(LEAST.seconds, Math.min(LEAST.longSeconds, LEAST.share * than));

/** The gains of one measure over another. */
export function gainsOf(before: Measure, after: Measure): readonly Gain[] {
  const gained: Readonly<Record<Exclude<Gain, "verdict">, boolean>> = {
    residual: before.residual - after.residual >= LEAST.residual,
    tools: after.tools < before.tools,
    changes: after.changes < before.changes,
    seconds: isShorter(after.seconds, before.seconds),
  };
  return GAINS.filter((gain) => gain !== "verdict" && gained[gain]);
}

/** What gains are worth, s: a better verdict, a mm² of residual material, a tool to set up, a tool change. */
const WORTH = { verdict: 600, residual: 60, tool: 60, change: 10 } as const;

/** The worth of a way in seconds: offers are sorted by it, and one that is worth nothing is none. */
export const worthOf = (before: Measure, after: Measure, gains: readonly Gain[]): number =>
  (gains.includes("verdict") ? WORTH.verdict : 0) +
  (before.seconds - after.seconds) +
  WORTH.residual * (before.residual - after.residual) +
  WORTH.tool * (before.tools - after.tools) +
  WORTH.change * (before.changes - after.changes);
