import type { Cycle } from "./define.ts";

/**
 * The values that a work begins with, by Q: those of the example of the list, but for the few that make nothing worth
 * beginning with.
 */
export const firstValues = ({ params, setup }: Pick<Cycle, "params" | "setup">): Readonly<Record<string, number>> => ({
  ...Object.fromEntries(Object.entries(params).map(([q, { example }]) => [q, example])),
  ...setup.values,
});
