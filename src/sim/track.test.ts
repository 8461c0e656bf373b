import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import { difference, union } from "../kernel/area/clip.ts";
import { hullOf } from "../kernel/cutter/hull.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { axial, radius } from "../kernel/units.ts";
import { hullAlong } from "./sweep.ts";
import { trackAlong } from "./track.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const mm = (least: number, most: number) => fc.integer({ min: least * 1000, max: most * 1000 }).map((n) => n / 1000);
const spot = fc.tuple(mm(-6, 6), mm(-6, 6));
const outlines = fc
  .array(spot, { minLength: 3, maxLength: 12 })
  .map((spots) => hullOf(spots).map(([z, r]) => at(z, r)))
  .filter((ring) => ring.length > 2 && areaOf([ring]) > 0.1);

/** The area in which the track and the union of the hulls along its chords differ, mm². */
function apart(outline: Ring, way: readonly Pt[]): number {
  const hulls = union(way.slice(1).map((to, i) => hullAlong(outline, way[i] as Pt, to)));
  const track = union([trackAlong(outline, way)]);
  return areaOf(difference(hulls, track)) + areaOf(difference(track, hulls));
}
/** Rounding of the polygon engine along outlines of some hundred mm. */
const ROUNDING = 0.005;

describe("the track of an outline is the union of the hulls along its chords", () => {
  test("along any zigzag", () => {
    fc.assert(
      fc.property(outlines, fc.array(spot, { minLength: 2, maxLength: 8 }), (outline, spots) => {
        const way = spots.map(([z, r]) => at(10 + 3 * z, 30 + 3 * r));
        fc.pre(way.some((p) => p.z !== way[0]?.z || p.r !== way[0].r));
        expect(apart(outline, way)).toBeLessThan(ROUNDING);
      }),
      { numRuns: 300 },
    );
  });
  test("along arcs, tighter than the outline and wider, to either side", () => {
    fc.assert(
      fc.property(outlines, mm(0.2, 25), mm(-4, 4), mm(0.3, 4), (outline, size, turn, begin) => {
        const way = Array.from({ length: 25 }, (_, i) =>
          at(size * Math.cos(begin + (turn * i) / 24), 50 + size * Math.sin(begin + (turn * i) / 24)),
        );
        expect(apart(outline, way)).toBeLessThan(ROUNDING);
      }),
      { numRuns: 200 },
    );
  });
  test("back along its own path, along the edges of the outline, and without any path", () => {
    const square = [at(0, 0), at(2, 0), at(2, 2), at(0, 2)];
    expect(apart(square, [at(0, 0), at(10, 0), at(0, 0), at(0, 7), at(0, 3)])).toBeLessThan(ROUNDING);
    expect(areaOf(union([trackAlong(square, [at(0, 0), at(10, 0), at(10, 8), at(3, 8), at(3, 0)])]))).toBeCloseTo(
      12 * 10 - 5 * 6 - 3 * 8,
      4,
    );
    expect(trackAlong(square, [at(5, 5), at(5, 5)])).toEqual([at(5, 5), at(7, 5), at(7, 7), at(5, 7)]);
  });
});
