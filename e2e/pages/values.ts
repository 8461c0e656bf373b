import { hasNoEffect } from "../../src/cycles/effect.ts";
import { cycleByNumber } from "../../src/cycles/index.ts";

/** A value for each prompt of a cycle, in the order of the prompts. */
export type Answers = Readonly<Record<string, string>>;

/** The printed example values of a cycle, with overrides; without prompts that have no effect, which ENT skips. */
export function answers(cycle: number, own: Answers = {}): Answers {
  const params = Object.entries(cycleByNumber(cycle)?.params ?? {});
  const all = params.map(([q, p]) => [q, p, own[q] ?? String(p.example)] as const);
  const values = Object.fromEntries(all.map(([q, , typed]) => [q, Number(typed)]));
  return Object.fromEntries(all.filter(([, p]) => !hasNoEffect(p, values)).map(([q, , typed]) => [q, typed]));
}
