import * as fc from "fast-check";
import { expect, test } from "vitest";
import { spread, type OnLine } from "./spread.ts";

const GAP = 0.7;

test("labels with room stay where they are", () => {
  const [first, second] =
    spread(
      [
        { at: 4.3, size: 3.1 },
        { at: 11.9, size: 3.1 },
      ],
      0,
      20,
      GAP,
    ) ?? [];
  expect(first).toBeCloseTo(4.3, 9);
  expect(second).toBeCloseTo(11.9, 9);
});

test("two labels that push each other share the shift", () => {
  const [first = 0, second = 0] =
    spread(
      [
        { at: 10, size: 4 },
        { at: 11.2, size: 4 },
      ],
      0,
      30,
      GAP,
    ) ?? [];
  expect(second - first).toBeCloseTo(4 + GAP, 9);
  expect((first + second) / 2).toBeCloseTo(10.6, 9);
});

test("a label beyond the end is moved in", () => {
  expect(spread([{ at: 19.5, size: 4 }], 0, 20, GAP)).toEqual([18]);
  expect(spread([{ at: -3, size: 5 }], 0, 20, GAP)).toEqual([2.5]);
});

test("too little room gives null", () => {
  expect(
    spread(
      [
        { at: 3, size: 6 },
        { at: 5, size: 6 },
      ],
      0,
      12.6,
      GAP,
    ),
  ).toBe(null);
  expect(
    spread(
      [
        { at: 3, size: 6 },
        { at: 5, size: 6 },
      ],
      0,
      12.7,
      GAP,
    ),
  ).not.toBe(null);
  expect(spread([], 0, 1, GAP)).toEqual([]);
});

test("in any case labels are in order, whole, apart, and moved only if another label or the end is in the way", () => {
  const label = fc.record({
    at: fc.double({ min: -40, max: 240, noNaN: true }),
    size: fc.double({ min: 0.5, max: 19, noNaN: true }),
  });
  fc.assert(
    fc.property(fc.array(label, { maxLength: 30 }), fc.double({ min: 5, max: 400, noNaN: true }), (unsorted, high) => {
      const labels: readonly OnLine[] = unsorted.toSorted((a, b) => a.at - b.at);
      const middles = spread(labels, 0, high, GAP);
      const needed = labels.reduce((sum, { size }) => sum + size, 0) + GAP * Math.max(0, labels.length - 1);
      if (!middles) return needed > high;
      const near = 1e-6;
      return middles.every((middle, i) => {
        const [{ at, size }, next, before] = [labels[i]!, labels[i + 1], labels[i - 1]];
        const [low, top] = [middle - size / 2, middle + size / 2];
        const below = before ? middles[i - 1]! + before.size / 2 + GAP : 0;
        const above = next ? middles[i + 1]! - next.size / 2 - GAP : high;
        const isApart = low >= below - near && top <= above + near;
        const touches = low <= below + near || top >= above - near;
        return isApart && (touches || Math.abs(middle - at) < near);
      });
    }),
  );
});
