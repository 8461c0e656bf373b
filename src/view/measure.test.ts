import fc from "fast-check";
import { expect, test } from "vitest";
import type { Pt } from "../kernel/point.ts";
import { axial, radius } from "../kernel/units.ts";
import { measure, measuredFor, nudged, snapPoints, snappedPoint } from "./measure.ts";

const point = fc.record({
  z: fc.double({ min: -200, max: 200, noNaN: true }).map(axial),
  r: fc.double({ min: 0, max: 200, noNaN: true }).map(radius),
});
const at = (r: number, z: number): Pt => ({ z: axial(z), r: radius(r) });

test("ΔX is a diameter, the distance is not", () => {
  expect(measure(at(10, 0), at(14, -3))).toEqual({ dx: 8, dz: -3, distance: 5 });
});

test("measured back, the differences change their sign only", () => {
  fc.assert(fc.property(point, point, (a, b) => {
    const there = measure(a, b), back = measure(b, a);
    expect(back.dx).toBeCloseTo(-there.dx, 9);
    expect(back.dz).toBeCloseTo(-there.dz, 9);
    expect(back.distance).toBe(there.distance);
  }));
});

test("the ruler takes the nearest point within its reach, else the place itself", () => {
  const points = [at(10, 0), at(10, -5), at(12, -5)];
  expect(snappedPoint(at(10.4, -4.8), points, 1)).toEqual(at(10, -5));
  expect(snappedPoint(at(30, -4.8), points, 1)).toEqual(at(30, -4.8));
});

test("a corner shared by two elements is one snap point; the centre of an arc is one too", () => {
  const points = snapPoints([[{ kind: "line", from: at(10, 0), to: at(10, -5) }, {
    kind: "arc",
    from: at(10, -5),
    to: at(12, -7),
    centre: at(12, -5),
    turn: "cw",
  }]], []);
  expect(points).toEqual([at(10, 0), at(10, -5), at(12, -7), at(12, -5)]);
});

test("nudging stays on whole thousandths", () => {
  expect(nudged(at(10.00004, -0.12345), 0.1, 0)).toEqual(at(10, -0.023));
});

test("what a ruler reads for a value: places for positions, ways for sizes", () => {
  const [first, second] = [at(12.46, -41.37), at(30.11, -3.17)];
  const between = measure(first, second);
  expect(measuredFor("diameter", first, null)).toBe(24.92);
  expect(measuredFor("axial", second, between)).toBe(-3.17);
  expect(measuredFor("radial", second, between)).toBe(17.65);
  expect(measuredFor("oversizeDiameter", second, between)).toBe(35.3);
  expect(measuredFor("axialDepth", second, between)).toBe(38.2);
  expect(measuredFor("length", second, between)).toBeCloseTo(Math.hypot(38.2, 17.65), 3);
  expect(measuredFor("radial", first, null)).toBeNull();
  expect(measuredFor("feed", first, between)).toBeNull();
});
