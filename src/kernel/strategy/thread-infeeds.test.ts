import { expect, test } from "vitest";
import { threadDepths } from "./thread-infeeds.ts";

const infeeds = (depths: readonly number[] | null) => (depths ?? []).map((d, i, all) => d - (all[i - 1] ?? 0));

test("the depth grows with the square root of the pass, as few passes as the first infeed allows", () => {
  expect(threadDepths(1.2, 0.6, false, [])).toEqual([
    expect.closeTo(0.6, 9),
    expect.closeTo(0.6 * Math.SQRT2, 9),
    expect.closeTo(0.6 * Math.sqrt(3), 9),
    expect.closeTo(1.2, 9),
  ]);
  expect(threadDepths(1.2, 0.5, true, [])).toEqual([0.4, 0.8, 1.2].map((d) => expect.closeTo(d, 9)));
});

test("no infeed is thinner than a twentieth of the first, however many there are", () => {
  const issues: [] = [];
  const [first = 0, ...more] = infeeds(threadDepths(2, 0.1, false, issues));
  expect(issues).toEqual([]);
  expect(first).toBeLessThanOrEqual(0.1);
  expect(more.length).toBeGreaterThan(200);
  expect(Math.min(...more)).toBeCloseTo(first / 20, 9);
});
