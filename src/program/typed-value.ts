import type { AxisWord, Value, Words } from "../nc/statement.ts";
import { parameterOf } from "../nc/value.ts";
import { type KnownParameters, readExpression } from "./expression.ts";

/** Decimals a control keeps of a position. */
export const POSITION_DECIMALS = 3;
/** A block without words. */
export const noWords: Words = { axes: [], linear: [], functions: [], extra: [] };

/** A number rounded to what a control keeps; never −0. */
export const kept = (n: number, decimals: number) => Number(n.toFixed(decimals)) || 0;

/**
 * A typed number as a value of NC text, rounded to what the control keeps; null when it is none. A Q parameter stays
 * one; a sum with Q parameters is worked out with the known values, since NC text takes no sums there.
 */
export function typedValue(typed: string, decimals = POSITION_DECIMALS, known: KnownParameters = {}): Value | null {
  const read = readExpression(typed, known);
  return parameterOf(typed) ?? (read.kind === "number" ? kept(read.value, decimals) : null);
}

/** The word of an axis, when a number is typed for it. */
export const typedAxis = (name: "X" | "Y" | "Z", typed: string, incremental = false): AxisWord[] => {
  const read = typedValue(typed);
  return read === null ? [] : [{ axis: name, value: read, incremental }];
};
