import type { Issue } from "../plan/issue.ts";
import { SAME } from "../tolerance.ts";
import { divide } from "./infeed.ts";

/** Allowance removed along a contour: its thickness, and the length of a pass at its outside and at its inside, mm. */
export interface Allowance {
  readonly depth: number;
  readonly outer: number;
  readonly inner: number;
}

/**
 * The infeeds of passes along a contour, from the outside, as few as the greatest infeed allows. Each removes the same
 * area (infeed × length of the pass, which changes linearly from outside to inside): passes of equal length have equal
 * infeeds. Null if there would be too many, with the issue that says so.
 */
export function divideAllowance(a: Allowance, most: number, issues: Issue[]): readonly number[] | null {
  const even = divide(a.depth, most, issues);
  if (!even) return null;
  if (even.passes === 0) return [];
  let infeeds = infeedsOf(a, even.passes);
  while (most > 0 && Math.max(...infeeds) > most * (1 + SAME / infeeds.length)) {
    if (!divide(a.depth, a.depth / (infeeds.length + 1), issues)) return null;
    infeeds = infeedsOf(a, infeeds.length + 1);
  }
  return infeeds;
}

/** Infeeds of equal area for a number of passes. */
function infeedsOf({ depth, outer, inner }: Allowance, passes: number): number[] {
  // A contour without length has no areas to divide.
  if (outer + inner <= SAME) return Array.from({ length: passes }, () => depth / passes);
  const area = (depth * (outer + inner)) / 2;
  const grows = (inner - outer) / depth;
  const behind = (share: number) =>
    (2 * share * area) / (outer + Math.sqrt(Math.max(0, outer * outer + 2 * grows * share * area)));
  const depths = Array.from({ length: passes + 1 }, (_, i) =>
    i === 0 ? 0 : i === passes ? depth : behind(i / passes),
  );
  return depths.slice(1).map((d, i) => d - (depths[i] ?? 0));
}
