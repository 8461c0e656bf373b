import { cycleByNumber } from "../../src/cycles/index.ts";

/** A value to answer each prompt of a cycle with, in the order of the prompts. */
export type Answers = Readonly<Record<string, string>>;

/** The printed example values of a cycle, with some of one's own. */
export function answers(cycle: number, own: Answers = {}): Answers {
  const params = Object.entries(cycleByNumber(cycle)?.params ?? {});
  return Object.fromEntries(params.map(([q, p]) => [q, own[q] ?? String(p.example)]));
}
