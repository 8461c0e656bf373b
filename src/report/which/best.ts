import type { TriedOption } from "./try-way.ts";

/** Smaller differences do not count, mm²: no operator sees them. */
const NO_DIFFERENCE = 0.05;
/** Shorter differences in time do not count, as a share. */
const NO_TIME = 0.01;

/** The advantage of the best option over the next one. */
export type Advantage = "only" | "tool" | "least" | "fast" | "passes" | "equal";

/** Differences between two options in the order in which a turner looks at them; negative: the first is better. */
function differences(a: TriedOption, b: TriedOption): readonly (readonly [Advantage, number])[] {
  const left = a.unreached - b.unreached;
  const time = a.seconds - b.seconds;
  return [
    ["tool", Number(b.suitsDepth) - Number(a.suitsDepth)],
    ["least", Math.abs(left) < NO_DIFFERENCE ? 0 : left],
    ["fast", Math.abs(time) < NO_TIME * Math.max(a.seconds, b.seconds) ? 0 : time],
    ["passes", a.passes - b.passes],
  ];
}

const compared = (a: TriedOption, b: TriedOption): number =>
  differences(a, b).find(([, difference]) => difference !== 0)?.[1] ?? 0;

/** Sorts best first: working options, then suitable tools, then least residual material, then least time. */
export const bestFirst = (tried: readonly TriedOption[]): readonly TriedOption[] =>
  tried.toSorted((a, b) => Number(b.works) - Number(a.works) || compared(a, b));

/** The best option and its advantage over the next one; null where none works. */
export function bestOf(tried: readonly TriedOption[]): { readonly id: string; readonly because: Advantage } | null {
  const [best, second] = bestFirst(tried.filter((t) => t.works));
  if (!best) return null;
  if (!second) return { id: best.id, because: "only" };
  const [because = "equal"] = differences(best, second).find(([, difference]) => difference < 0) ?? [];
  return { id: best.id, because };
}
