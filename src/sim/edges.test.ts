import fc from "fast-check";
import { expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import { intersection, isInside, offset, union } from "../kernel/area/clip.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { axial, radius } from "../kernel/units.ts";
import { inBox } from "../kernel/area/box.ts";
import { sidesOf } from "./edges.ts";
import { convexPieceOf } from "./piece.ts";
import { placeIn, regionsOf } from "./region.ts";
import { hullAlong } from "./sweep.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const boxPiece = (z0: number, r0: number, z1: number, r1: number) => convexPieceOf(box(z0, r0, z1, r1));
const mm = fc.integer({ min: -20_000, max: 20_000 }).map((n) => n / 1000);
const spot = fc.tuple(mm, mm).map(([z, r]) => at(z, r));
const areas = fc.array(spot, { minLength: 3, maxLength: 40 }).map((ring) => union([ring]));
/** A regular convex polygon, counter-clockwise. */
const convex = fc
  .tuple(mm, mm, fc.integer({ min: 3, max: 12 }), fc.integer({ min: 100, max: 8000 }))
  .map(([z, r, count, size]): Ring =>
    Array.from({ length: count }, (_, i) => {
      const a = (2 * Math.PI * (i + 0.3)) / count;
      return at(z + (size / 1000) * Math.cos(a), r + (size / 1000) * Math.sin(a));
    }),
  );

test("a piece that overlaps an area meets it, and one clear of it does not", () => {
  fc.assert(
    fc.property(areas, convex, (area, piece) => {
      const common = areaOf(intersection(area, [piece]));
      const meets = sidesOf(area).meets(convexPieceOf(piece));
      if (common > 0.01) expect(meets).toBe(true);
      if (!meets) expect(common).toBeLessThan(0.01);
      // A needle that ends in the piece overlaps it by less than the polygon grid: only a piece at a distance is clear.
      if (areaOf(intersection(offset(area, 0.01), [piece])) === 0) expect(meets).toBe(false);
    }),
    { numRuns: 1500 },
  );
});

test("touching an edge is not meeting", () => {
  const edges = sidesOf([box(0, 0, 10, 10)]);
  expect(edges.meets(boxPiece(10, 0, 20, 10))).toBe(false);
  expect(edges.meets(boxPiece(-5, 10, 20, 20))).toBe(false);
  expect(edges.meets(boxPiece(9.9, 0, 20, 10))).toBe(true);
  expect(edges.meets(boxPiece(4, 4, 5, 5))).toBe(true);
  expect(edges.meets(boxPiece(-5, -5, 15, 15))).toBe(true);
  expect(sidesOf([]).meets(boxPiece(0, 0, 1, 1))).toBe(false);
});

test("clipping to a box keeps the area under the non-zero rule", () => {
  fc.assert(
    fc.property(areas, spot, spot, (area, a, b) => {
      const [left, right, low, high] = [
        Math.min(a.z, b.z),
        Math.max(a.z, b.z) + 0.1,
        Math.min(a.r, b.r),
        Math.max(a.r, b.r) + 0.1,
      ];
      const ring = box(left, low, right, high);
      const [fast, exact] = [union(inBox(area, { left, right, low, high })), intersection(area, [ring])];
      expect(Math.abs(areaOf(fast) - areaOf(exact))).toBeLessThan(0.01);
    }),
    { numRuns: 500 },
  );
});

test("the hull along a path is the convex hull of both ends", () => {
  fc.assert(
    fc.property(convex, spot, spot, (outline, from, to) => {
      const hull = hullAlong(outline, from, to);
      const moved = (p: Pt): Ring => outline.map((q) => at(q.z + p.z, q.r + p.r));
      const middle = moved(at((from.z + to.z) / 2, (from.r + to.r) / 2));
      for (const part of [moved(from), moved(to), middle])
        expect(Math.abs(areaOf(intersection([hull], [part])) - areaOf([part]))).toBeLessThan(0.01);
      hull.forEach((p, i) => {
        const [q, s] = [hull[(i + 1) % hull.length]!, hull[(i + 2) % hull.length]!];
        expect((q.z - p.z) * (s.r - q.r) - (q.r - p.r) * (s.z - q.z)).toBeGreaterThan(-1e-9);
      });
    }),
    { numRuns: 500 },
  );
});

test("the place of a region lies inside it", () => {
  fc.assert(
    fc.property(areas, (area) => {
      for (const region of regionsOf(area, 0.05)) expect(isInside(region.outline, placeIn(region.outline))).toBe(true);
    }),
    { numRuns: 500 },
  );
});

test("regions know their holes", () => {
  const [frame, ...more] = regionsOf([box(0, 0, 10, 10), [...box(2, 2, 8, 8)].reverse(), box(20, 0, 20.1, 0.05)], 0.01);
  expect(more).toEqual([]);
  expect(frame!.area).toBeCloseTo(64, 9);
  expect(frame!.holes).toHaveLength(1);
});
