import type { Statement } from "../../nc/statement.ts";
import type { FileName } from "../../nc/words.ts";
import { formulaOf, textOf, type EvaluationError } from "../values/formula.ts";
import type { Machine } from "../state/machine.ts";

/** A Q parameter takes the value of a formula. */
export function assign(machine: Machine, s: Extract<Statement, { kind: "assign" }>, index: number): void {
  if (s.formula.kind === "undefined") return machine.known.unset(s.target);
  keep(machine, s.target, formulaOf(s.formula, machine.parameters, machine.known.texts), index);
}

/** A QS parameter takes a text. */
export function assignText(machine: Machine, s: Extract<Statement, { kind: "assignText" }>, index: number): void {
  keep(machine, s.target, textOf(s.text, machine.parameters, machine.known.texts), index);
}

/** Stores a result. A parameter computed from an unknown value is unknown too. */
function keep(machine: Machine, target: string, result: number | string | EvaluationError, index: number): void {
  const { known } = machine;
  if (typeof result === "string") return known.setText(target, result);
  const passedOn = typeof result !== "number" && result.kind === "unset" ? known.reasonOf(result.name) : null;
  const n = passedOn ? null : machine.resolveNumber(result, index);
  if (n === null) known.markUnknown(target, passedOn ?? "told");
  else known.set(target, n);
}

/** File name in a block; null where it depends on a parameter without a value. */
export const writtenFile = (machine: Machine, file: FileName, index: number): string | null =>
  typeof file === "object" ? machine.text(file.parameter, index) : file;
