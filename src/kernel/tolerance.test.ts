import { expect, test } from "vitest";
import * as tolerance from "./tolerance.ts";

test("tolerances keep their order, from rounding to what an older control prints", () => {
  const { NOTHING, ROUND, JOINED, GRID, SAME, CHORD, SLIVER, INCH_ROUNDED, ARC_END } = tolerance;
  const order = [NOTHING, ROUND, JOINED, GRID, SAME, CHORD, SLIVER, INCH_ROUNDED, ARC_END];
  expect([...order].sort((a, b) => a - b)).toEqual(order);
  expect(new Set(order).size).toBe(order.length);
});

test("every length has its place in that order; the others are no lengths", () => {
  const others = ["SAME_STEP"];
  expect(
    Object.keys(tolerance)
      .filter((name) => !others.includes(name))
      .sort(),
  ).toEqual(["ARC_END", "CHORD", "GRID", "INCH_ROUNDED", "JOINED", "NOTHING", "ROUND", "SAME", "SLIVER"]);
});

test("two chords and one unit of the polygon engine fit into a sliver", () => {
  expect(2 * tolerance.CHORD + tolerance.GRID).toBeLessThan(tolerance.SLIVER);
});
