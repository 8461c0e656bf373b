import fc from "fast-check";
import { expect, test } from "vitest";
import { difference, offset } from "../kernel/area/clip.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { axial, radius } from "../kernel/units.ts";
import { deepestAlong, hasRoomFor, thicknessOf } from "./extent.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const mm = (min: number, max: number) => fc.integer({ min: min * 1000, max: max * 1000 }).map((n) => n / 1000);
const circle = (size: number): Ring =>
  Array.from({ length: 400 }, (_, i) =>
    at(3 + size * Math.cos((i * Math.PI) / 200), 9 + size * Math.sin((i * Math.PI) / 200)),
  );

test("a box is as deep as its extent along the axis, and as thick as its narrow side", () => {
  fc.assert(
    fc.property(mm(-50, 50), mm(1, 60), mm(0.1, 40), mm(0.1, 40), (z, r, w, h) => {
      const area = [box(z, r, z + w, r + h)];
      expect(deepestAlong(area, at(0, 1))).toBeCloseTo(h, 4);
      expect(deepestAlong(area, at(-1, 0))).toBeCloseTo(w, 4);
      expect(Math.abs(thicknessOf(area) / Math.min(w, h) - 1)).toBeLessThan(0.03);
    }),
    { numRuns: 60 },
  );
});

test("two layers count separately, but not with only a hairline between them", () => {
  expect(deepestAlong([box(0, 0, 10, 2), box(0, 5, 10, 8.3)], at(0, 1))).toBeCloseTo(3.3, 6);
  expect(deepestAlong([box(0, 0, 10, 2), box(0, 2.001, 10, 3.3)], at(0, 1))).toBeCloseTo(3.3, 6);
});

test("a slanted band is as thick as it is square to itself, however deep it is", () => {
  const band = [at(0, 0), at(40, 40), at(38.6, 41.4), at(-1.4, 1.4)];
  expect(thicknessOf([band])).toBeCloseTo(1.4 * Math.SQRT2, 1);
  expect(deepestAlong([band], at(0, 1))).toBeCloseTo(2.8, 3);
});

test("an area around a hole is as thick as the distance from hole to outline; a circle as its diameter", () => {
  const ring = difference([box(0, 0, 30, 30)], [box(4, 4, 27, 27)]);
  expect(Math.abs(thicknessOf(ring) - (4 * 2) / (1 + Math.SQRT1_2))).toBeLessThan(0.7);
  expect(thicknessOf([circle(2.7)])).toBeCloseTo(5.4, 1);
  expect(thicknessOf([])).toBe(0);
});

test("a circle of that thickness fits in, a larger one does not", () => {
  const spots = fc.array(fc.tuple(mm(-20, 20), mm(0, 30)), { minLength: 3, maxLength: 9 });
  fc.assert(
    fc.property(spots, mm(0.2, 3), (points, width) => {
      const area = offset(
        points.map(([z, r]) => box(z, r, z + width, r + 5)),
        0.3,
      );
      const thickness = thicknessOf(area);
      expect(offset(area, -thickness * 0.48)).not.toEqual([]);
      expect(offset(area, -thickness * 0.52)).toEqual([]);
    }),
    { numRuns: 60 },
  );
});

test("room for a circle is never denied where one fits, and is where a band is far thinner, however long and bent", () => {
  const spots = fc.array(fc.tuple(mm(-20, 20), mm(0, 30)), { minLength: 3, maxLength: 9 });
  fc.assert(
    fc.property(spots, mm(0.2, 3), mm(0.2, 1), (points, width, part) => {
      const area = offset(
        points.map(([z, r]) => box(z, r, z + width, r + 5)),
        0.3,
      );
      expect(hasRoomFor(area, 0.96 * part * thicknessOf(area))).toBe(true);
    }),
    { numRuns: 100 },
  );
  const bent = difference([box(-40, 5, 0, 30)], [box(-39.4, 0, 1, 29.5)]);
  expect(hasRoomFor(bent, 0.6)).toBe(true);
  expect(hasRoomFor(bent, 2.4)).toBe(false);
  expect(hasRoomFor([], 1)).toBe(false);
});
