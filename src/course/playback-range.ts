import type { Step } from "../kernel/time/step.ts";
import type { Operation } from "../program/state/run-types.ts";

/** A stretch of steps, both included. */
export interface StepRange {
  readonly first: number;
  readonly last: number;
}

/** The steps of some blocks of a program, inclusive; all steps where no block is given, or none of them moves. */
export function stepsPlayed(
  steps: readonly Pick<Step, "block">[],
  blocks?: { readonly from: number; readonly to: number },
): StepRange {
  const all = { first: 0, last: steps.length - 1 };
  if (!blocks) return all;
  const isPlayed = ({ block }: Pick<Step, "block">) => block >= blocks.from && block <= blocks.to;
  const first = steps.findIndex(isPlayed);
  return first < 0 ? all : { first, last: steps.findLastIndex(isPlayed) };
}

/** The cycle calls within the played steps. */
export const operationsPlayed = <O extends Pick<Operation, "firstStep" | "lastStep">>(
  operations: readonly O[],
  { first, last }: StepRange,
) => operations.filter(({ firstStep, lastStep }) => lastStep >= firstStep && lastStep >= first && firstStep <= last);

/** A value as a control writes it: signed, without trailing zeros. */
const written = (value: number): string => `${value < 0 ? "" : "+"}${Number(value.toFixed(4))}`;

/** Lines of a program with another value at each place that sets a parameter. */
export const withParameterValue = (lines: readonly string[], q: string, value: number): readonly string[] =>
  lines.map((line) => line.replace(new RegExp(`^(\\s*${q}=)[+-]?[\\d.]+`), `$1${written(value)}`));

/** The first value of a parameter in the lines of a program; null without one. */
export function parameterValueIn(lines: readonly string[], q: string): number | null {
  for (const line of lines) {
    const found = new RegExp(`^\\s*${q}=([+-]?[\\d.]+)`).exec(line)?.[1];
    if (found !== undefined && Number.isFinite(Number(found))) return Number(found);
  }
  return null;
}

/** The number of the cycle that first sets a parameter in the lines of a program; null without one. */
export function cycleOfParameter(lines: readonly string[], q: string): number | null {
  let cycle: number | null = null;
  for (const line of lines) {
    const defined = /^\s*(?:\d+\s+)?CYCL DEF (\d+)/.exec(line)?.[1];
    if (defined !== undefined) cycle = Number(defined);
    if (cycle !== null && parameterValueIn([line], q) !== null) return cycle;
  }
  return null;
}
