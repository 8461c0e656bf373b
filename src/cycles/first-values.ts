import type { Cycle } from "./define.ts";

/**
 * The values with which a new program starts, by Q: those of the list's example, except for the few that make nothing
 * useful.
 */
export const firstValues = ({ params, setup }: Pick<Cycle, "params" | "setup">): Readonly<Record<string, number>> => ({
  ...Object.fromEntries(Object.entries(params).map(([q, { example }]) => [q, example])),
  ...setup.values,
});
