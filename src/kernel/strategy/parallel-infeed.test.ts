import { describe, expect, test } from "vitest";
import type { Issue } from "../plan/issue.ts";
import { divideAllowance } from "./parallel-infeed.ts";

const sum = (n: readonly number[] | null) => (n ?? []).reduce((a, b) => a + b, 0);
/** Area of each pass if the length changes linearly from the outside to the inside. */
function areas(infeeds: readonly number[], depth: number, outer: number, inner: number): number[] {
  let from = 0;
  return infeeds.map((infeed) => {
    const middle = from + infeed / 2;
    from += infeed;
    return infeed * (outer + ((inner - outer) * middle) / depth);
  });
}

describe("an allowance in passes along the contour", () => {
  test("passes of one length are of one infeed, and k infeeds are k passes", () => {
    expect(divideAllowance({ depth: 4.8, outer: 61, inner: 61 }, 1.6, [])).toEqual(
      [1.6, 1.6, 1.6].map((n) => expect.closeTo(n, 9)),
    );
    expect(divideAllowance({ depth: 4.8, outer: 1, inner: 1 }, 1.59, [])).toHaveLength(4);
  });

  test.each([
    [7.3, 120, 61.7],
    [7.3, 61.7, 120],
    [2.1, 30, 0],
    [1.9, 0, 7.1],
    [5, 44, 43],
  ])("%d mm from %d to %d mm long: one area each", (depth, outer, inner) => {
    const infeeds = divideAllowance({ depth, outer, inner }, 1.3, []) ?? [];
    expect(sum(infeeds)).toBeCloseTo(depth, 9);
    expect(Math.max(...infeeds)).toBeLessThanOrEqual(1.3001);
    const taken = areas(infeeds, depth, outer, inner);
    taken.forEach((a) => expect(a).toBeCloseTo(taken[0] as number, 6));
    expect(
      infeeds.every(
        (i, k) => k === 0 || (outer > inner ? i > (infeeds[k - 1] as number) : i < (infeeds[k - 1] as number)),
      ),
    ).toBe(true);
  });

  test("0 is one pass, no allowance is none, and too many passes are an error", () => {
    expect(divideAllowance({ depth: 3, outer: 9, inner: 5 }, 0, [])).toEqual([3]);
    expect(divideAllowance({ depth: 0.87, outer: 0, inner: 0 }, 0.3, [])).toEqual(
      [0.29, 0.29, 0.29].map((n) => expect.closeTo(n, 9)),
    );
    expect(divideAllowance({ depth: -0.2, outer: 9, inner: 5 }, 1, [])).toEqual([]);
    const issues: Issue[] = [];
    expect(divideAllowance({ depth: 3, outer: 9, inner: 5 }, 0.0001, issues)).toBeNull();
    expect(issues.map((i) => i.code)).toEqual(["tooManyPasses"]);
  });
});
