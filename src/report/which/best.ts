import type { TriedOption } from "./try-way.ts";

/** Smaller differences do not count, mm²: no operator sees them. */
const NO_DIFFERENCE = 0.05;

const apart = (a: TriedOption, b: TriedOption) => {
  const left = (a.residualArea ?? 0) - (b.residualArea ?? 0);
  return Math.abs(left) < NO_DIFFERENCE ? 0 : left;
};

/** Sorts best first: working options, then least residual material, then least time. */
export const bestFirst = (tried: readonly TriedOption[]): readonly TriedOption[] =>
  tried.toSorted((a, b) => Number(b.works) - Number(a.works) || apart(a, b) || a.seconds - b.seconds);

/** The best option and its advantages; null where none works. */
export function bestOf(
  tried: readonly TriedOption[],
): { readonly id: string; readonly because: "only" | "least" | "fast" } | null {
  const [best, second] = bestFirst(tried.filter((t) => t.works));
  if (!best) return null;
  if (!second) return { id: best.id, because: "only" };
  return { id: best.id, because: apart(best, second) < 0 ? "least" : "fast" };
}
