import fc from "fast-check";
import { expect, test } from "vitest";
import { ticks } from "./ticks.ts";

test("marks lie in their range, on steps of 1, 2 or 5, and not too close", () => {
  fc.assert(
    fc.property(
      fc.double({ min: -1e4, max: 1e4, noNaN: true }),
      fc.double({ min: 0.01, max: 1e3, noNaN: true }),
      fc.double({ min: 0.001, max: 100, noNaN: true }),
      (from, span, apart) => {
        const t = ticks(from, from + span, apart);
        expect(t.step).toBeGreaterThanOrEqual(apart * 0.999);
        expect(t.values.length).toBeLessThan(203);
        for (const v of t.values) {
          expect(v).toBeGreaterThanOrEqual(from - t.step * 1e-6);
          expect(v).toBeLessThanOrEqual(from + span + t.step * 1e-6);
          expect(Number(v.toFixed(t.decimals))).toBe(v);
        }
        expect([1, 2, 5]).toContain(Math.round(t.step / 10 ** Math.floor(Math.log10(t.step * 1.0001))));
      },
    ),
  );
});

test("nothing to measure gives no marks", () => {
  expect(ticks(0, Number.NaN, 1).values).toEqual([]);
  expect(ticks(0, 10, 0).values).toEqual([]);
});
