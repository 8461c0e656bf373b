import fc from "fast-check";
import { expect, test } from "vitest";
import { labelsOverlap, type LabelBox } from "../dimensions/labels.ts";
import { namePlace } from "./name-place.ts";

const size = { width: 640, height: 480 };

test("above on the right; left of a place at the right edge, below one at the upper edge", () => {
  expect(namePlace({ x: 300, y: 200 }, 90, size, [])).toEqual({ x: 310, y: 174, width: 90, height: 16 });
  expect(namePlace({ x: 600, y: 200 }, 90, size, []).x).toBe(500);
  expect(namePlace({ x: 300, y: 4 }, 90, size, []).y).toBe(14);
});

test("covers no kept box where one of its places is free", () => {
  const box = fc.record({
    x: fc.integer({ min: 46, max: 600 }),
    y: fc.integer({ min: 0, max: 420 }),
    width: fc.integer({ min: 10, max: 120 }),
    height: fc.integer({ min: 10, max: 40 }),
  });
  fc.assert(
    fc.property(fc.integer({ min: 200, max: 450 }), fc.integer({ min: 90, max: 370 }), box, (x, y, kept: LabelBox) => {
      expect(labelsOverlap(namePlace({ x, y }, 90, size, [kept]), kept)).toBe(false);
    }),
  );
});
