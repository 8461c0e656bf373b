import type { CycleParameter, Value } from "../../nc/statement.ts";
import { parameterOf } from "../../nc/value.ts";
import { readExpression } from "../../program/expression.ts";

/** A value of NC text as one types it: no plus sign. */
export const typedValue = (value: Value): string =>
  typeof value === "number" ? String(value) : `${value.negative ? "-" : ""}${value.parameter}`;

/** Typed text as a value of NC text: a number with point or comma, a sum, a Q parameter; null when it is none of them. */
export function readValue(typed: string, decimals = 4): Value | null {
  const read = readExpression(typed);
  return parameterOf(typed) ?? (read.kind === "number" ? Number(read.value.toFixed(decimals)) || 0 : null);
}

/** What stands behind a Q of a cycle, as one types it. */
export const typedParameter = (value: CycleParameter["value"] | undefined): string =>
  value === null || value === undefined ? "" : value === "auto" ? "FAUTO" : value === "max" ? "FMAX" : typedValue(value);
