import { issue, type Issue } from "../plan/issue.ts";
import { SAME } from "../tolerance.ts";
import { roundedUpTo } from "../units.ts";
import { MOST_PASSES } from "./infeed.ts";

/** The last infeed is never thinner than this part of the first: an insert that only rubs wears out. */
const THINNEST = 1 / 20;

/** Additional depth of pass k over the previous one, in first infeeds. */
const share = (k: number, constant: boolean) => (constant ? 1 : Math.max(Math.sqrt(k) - Math.sqrt(k - 1), THINNEST));

/** Most passes of an offered infeed, and the step of values that an operator types, mm. */
const OFFERED = { passes: 60, step: 0.05 } as const;

/**
 * Depth of each pass of a thread, mm, the last one `depth`: as few as a first cut of at most `most` allows. With a
 * constant chip cross-section the depth grows with the square root of the pass, because the area of a wedge grows with
 * the square of its depth. Null if there would be too many, with the issue that says so.
 */
export function threadDepths(depth: number, most: number, constant: boolean, issues: Issue[]): number[] | null {
  const sums = [1];
  const enough = most > 0 ? depth / most - SAME : 0;
  while ((sums.at(-1) as number) < enough && sums.length <= MOST_PASSES)
    sums.push((sums.at(-1) as number) + share(sums.length + 1, constant));
  const whole = sums.at(-1) as number;
  if (sums.length <= MOST_PASSES) return sums.map((s) => (depth * s) / whole);
  const nearest = roundedUpTo(OFFERED.step, depth / (sums[OFFERED.passes - 1] as number));
  issues.push(issue("tooManyPasses", "error", { passes: sums.length, most: MOST_PASSES, nearest }, "infeed"));
  return null;
}
