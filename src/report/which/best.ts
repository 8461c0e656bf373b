import type { Tried } from "./try-way.ts";

/** Smaller differences do not count, mm²: no operator sees them. */
const NO_DIFFERENCE = 0.05;

const apart = (a: Tried, b: Tried) => {
  const left = (a.stays ?? 0) - (b.stays ?? 0);
  return Math.abs(left) < NO_DIFFERENCE ? 0 : left;
};

/** Sorts best first: working options, then least residual material, then least time. */
export const bestFirst = (tried: readonly Tried[]): readonly Tried[] =>
  tried.toSorted((a, b) => Number(b.works) - Number(a.works) || apart(a, b) || a.seconds - b.seconds);

/** The best option and its advantages; null where none works. */
export function bestOf(
  tried: readonly Tried[],
): { readonly id: string; readonly because: "only" | "least" | "fast" } | null {
  const [best, second] = bestFirst(tried.filter((t) => t.works));
  if (!best) return null;
  if (!second) return { id: best.id, because: "only" };
  return { id: best.id, because: apart(best, second) < 0 ? "least" : "fast" };
}
