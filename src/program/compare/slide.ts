import type { Pair } from "./align.ts";

/** How far a run can slide: the members that enter it equal those that leave it. */
function reach(a: Int32Array, pairs: readonly Pair[], k: number, by: 1 | -1, length: number): number {
  let far = 0;
  for (;;) {
    const at = pairs[by > 0 ? k + far : k - 1 - far];
    const last = far === 0 ? undefined : pairs[by > 0 ? k + far - 1 : k - far];
    // Only past neighbours in both lists: a further run in between would change its place.
    if (!at || (last && (at[0] !== last[0] + by || at[1] !== last[1] + by))) return far;
    if (a[at[0]] !== a[at[0] - by * length]) return far;
    far += 1;
  }
}

/**
 * Slides each run that only the first list has to the best start among its equal places. A removed operation begins
 * with its first block then, and not with the end of the operation before. All pairs stay equal.
 */
export function slid(
  pairs: readonly Pair[],
  a: Int32Array,
  m: number,
  rank: (start: number) => number,
): readonly Pair[] {
  const all: Pair[] = [...pairs];
  for (let k = 0; k <= all.length; k += 1) {
    const [[beforeA, beforeB], [behindA, behindB]] = [all[k - 1] ?? [-1, -1], all[k] ?? [a.length, m]];
    const [start, length] = [beforeA + 1, behindA - beforeA - 1];
    if (length === 0 || behindB !== beforeB + 1) continue;
    const [up, down] = [reach(a, all, k, -1, length), reach(a, all, k, 1, length)];
    let best = 0;
    for (let by = -up; by <= down; by += 1) if (rank(start + by) > rank(start + best)) best = by;
    for (let i = k + best; i < k; i += 1) all[i] = [(all[i]?.[0] ?? 0) + length, all[i]?.[1] ?? 0];
    for (let i = k; i < k + best; i += 1) all[i] = [(all[i]?.[0] ?? 0) - length, all[i]?.[1] ?? 0];
    k = Math.max(k, k + best);
  }
  return all;
}
