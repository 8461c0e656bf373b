import fc from "fast-check";
import { expect, test } from "vitest";
import type { Pt } from "../../kernel/geometry/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import { fieldValueOf, measure, rulerValueFor, nudged } from "./distance.ts";

const point = fc.record({
  z: fc.double({ min: -200, max: 200, noNaN: true }).map(axial),
  r: fc.double({ min: 0, max: 200, noNaN: true }).map(radius),
});
const at = (r: number, z: number): Pt => ({ z: axial(z), r: radius(r) });

test("ΔX is a diameter, the distance is not", () => {
  expect(measure(at(10, 0), at(14, -3))).toEqual({ dx: 8, dz: -3, distance: 5 });
});

test("measured back, the differences change their sign only", () => {
  fc.assert(
    fc.property(point, point, (a, b) => {
      const there = measure(a, b),
        back = measure(b, a);
      expect(back.dx).toBeCloseTo(-there.dx, 9);
      expect(back.dz).toBeCloseTo(-there.dz, 9);
      expect(back.distance).toBe(there.distance);
    }),
  );
});

test("nudging stays on whole thousandths", () => {
  expect(nudged(at(10.00004, -0.12345), 0.1, 0)).toEqual(at(10, -0.023));
});

test("a ruler reads places for positions and distances for sizes", () => {
  const [first, second] = [at(12.46, -41.37), at(30.11, -3.17)];
  const between = measure(first, second);
  expect(rulerValueFor("diameter", first, null)).toBe(24.92);
  expect(rulerValueFor("axial", second, between)).toBe(-3.17);
  expect(rulerValueFor("radial", second, between)).toBe(17.65);
  expect(rulerValueFor("oversizeDiameter", second, between)).toBe(35.3);
  expect(rulerValueFor("axialDepth", second, between)).toBe(38.2);
  expect(rulerValueFor("length", second, between)).toBeCloseTo(Math.hypot(38.2, 17.65), 3);
  expect(rulerValueFor("radial", first, null)).toBeNull();
  expect(rulerValueFor("feed", first, between)).toBeNull();
});

test("a measured value fits values of its kind, on the grid of the control", () => {
  expect(fieldValueOf("diameter", "diameter", 41.23456)).toBe(41.235);
  expect(fieldValueOf("diameter", "length", 41.23456)).toBeNull();
  expect(fieldValueOf("radial", "depth", 3.0004)).toBe(3);
  expect(fieldValueOf("length", "radius", 1.5999)).toBe(1.6);
  expect(fieldValueOf("length", "diameter", 1.5999)).toBeNull();
  expect(fieldValueOf("angle", "angle", 12.34567)).toBe(12.3457);
  expect(fieldValueOf("length", "angle", 12.3)).toBeNull();
  expect(fieldValueOf("feed", "length", 12.3)).toBeNull();
});
