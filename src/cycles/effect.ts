import type { Param } from "./params.ts";

/** The known values of a cycle, by Q. */
export type SomeValues = Readonly<Record<string, number | "auto" | undefined>>;

/**
 * Whether a value has no effect with the other known values: it is reserved, or its condition is not met. While the
 * condition is unknown, it has an effect.
 */
export function hasNoEffect(
  { reserved, condition }: Pick<Param, "reserved" | "condition">,
  known: SomeValues,
): boolean {
  const decides = condition === null ? undefined : known[condition.q];
  return reserved || (typeof decides === "number" && condition?.among.includes(decides) === false);
}

/** The value that the program contains in place of one without effect: 0, or the nearest allowed value. */
export function neutralValueOf({ range: [min, max], choices }: Pick<Param, "range" | "choices">): number {
  if (choices) return choices.includes(0) ? 0 : (choices[0] as number);
  return Math.min(max, Math.max(min, 0));
}
