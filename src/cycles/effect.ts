import type { Param } from "./params.ts";

/** A few values of a cycle, by Q: those that are known. */
export type SomeValues = Readonly<Record<string, number | "auto" | undefined>>;

/**
 * Whether a value says nothing beside the others that are known: it is reserved, or what it belongs to is not there. As
 * long as that is not known, it says something.
 */
export function saysNothing({ reserved, counts }: Pick<Param, "reserved" | "counts">, known: SomeValues): boolean {
  const decides = counts === null ? undefined : known[counts.q];
  return reserved || (typeof decides === "number" && counts?.among.includes(decides) === false);
}

/**
 * What stands in the program where a value that says nothing is left out: 0, or what is next to it among those that may
 * be entered.
 */
export function neutralOf({ range: [min, max], choices }: Pick<Param, "range" | "choices">): number {
  if (choices) return choices.includes(0) ? 0 : (choices[0] as number);
  return Math.min(max, Math.max(min, 0));
}
