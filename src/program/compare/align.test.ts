import * as fc from "fast-check";
import { expect, test } from "vitest";
import { aligned } from "./align.ts";

/** Length of the longest common subsequence, by the full table. */
function longest(a: readonly number[], b: readonly number[]): number {
  let row: readonly number[] = b.map(() => 0);
  for (const one of a) {
    const next: number[] = [];
    b.forEach((other, j) => next.push(one === other ? (row[j - 1] ?? 0) + 1 : Math.max(row[j] ?? 0, next[j - 1] ?? 0)));
    row = next;
  }
  return row.at(-1) ?? 0;
}

const list = fc.array(fc.nat(4), { maxLength: 14 });

test("what is paired is equal and in the order of both lists, and no common part is longer", () => {
  fc.assert(
    fc.property(list, list, (a, b) => {
      const pairs = aligned(Int32Array.from(a), Int32Array.from(b));
      pairs.forEach(([i, j], k) => {
        expect(a[i]).toBe(b[j]);
        const [before, above] = pairs[k - 1] ?? [-1, -1];
        expect(i > before && j > above).toBe(true);
      });
      expect(pairs).toHaveLength(longest(a, b));
    }),
    { numRuns: 1000 },
  );
});

test("long lists without anything in common end, and what they have at their ends is found", () => {
  const [a, b] = [0, 1].map((odd) => Int32Array.from({ length: 3001 }, (_, i) => (i === 3000 ? -1 : 2 * i + odd)));
  if (!a || !b) throw new Error("two lists");
  expect(aligned(a, b)).toEqual([[3000, 3000]]);
});
