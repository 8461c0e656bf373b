import type { Program } from "../../../nc/program.ts";
import type { Statement } from "../../../nc/statement.ts";
import type { KnownParameters } from "../../../program/values/expression.ts";
import { formulaOf } from "../../../program/values/formula.ts";

/** Q parameter values before a block, read top to bottom without following calls. */
export function parametersBefore(program: Program, index: number): KnownParameters {
  const known = new Map<string, number>();
  for (const { statement: s } of program.blocks.slice(0, index)) {
    if (s.kind !== "assign") continue;
    const value = formulaOf(s.formula, known);
    if (typeof value === "number") known.set(s.target, value);
  }
  return Object.fromEntries(known);
}

const functionsOf = (s: Statement): readonly number[] =>
  "words" in s && "functions" in s.words ? s.words.functions : [];

/** True when feeds before a block are per revolution (M136). */
export function perRevolutionBefore(program: Program, index: number): boolean {
  for (let i = index; i >= 0; i -= 1) {
    const block = program.blocks[i];
    if (!block) continue;
    const last = functionsOf(block.statement).findLast((m) => m === 136 || m === 137);
    if (last !== undefined) return last === 136;
  }
  return false;
}
