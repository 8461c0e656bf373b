import { describe, expect, test } from "vitest";
import { areaOf } from "../src/kernel/area/area.ts";
import { difference, offset, union } from "../src/kernel/area/clip.ts";
import type { Ring } from "../src/kernel/geometry/point.ts";
import { GRID } from "../src/kernel/tolerance.ts";
import { axial, radius } from "../src/kernel/units.ts";

/**
 * The cases that decided the choice of polygon engine (docs/decisions/0001): another port of the same library gets each
 * of them wrong. They apply to any engine of kernel/clip.ts.
 */
const ring = (...points: readonly (readonly [number, number])[]): Ring =>
  points.map(([z, r]) => ({ z: axial(z), r: radius(r) }));
const units = (...points: readonly (readonly [number, number])[]): Ring =>
  ring(...points.map(([x, y]) => [x * GRID, y * GRID] as const));
const box = (z: number, r: number, width: number, height: number) =>
  ring([z, r], [z + width, r], [z + width, r + height], [z, r + height]);

describe("the polygon engine", () => {
  test("keeps its input: a vertex of the triangle is not overwritten by an intersection", () => {
    const triangle = units([-968021, 289005], [-943762, 302447], [-1000000, 237828]);
    const pentagon = units(
      [-163353, 261701],
      [-163023, 262156],
      [-122651, 448734],
      [-968021, 289005],
      [-1021013, 204201],
    );
    const before = JSON.stringify([triangle, pentagon]);
    // The C++ reference implementation leaves 66 589 013 square units.
    expect(areaOf(difference([triangle], [pentagon])) / GRID / GRID).toBeCloseTo(66_589_013, -3);
    expect(JSON.stringify([triangle, pentagon])).toBe(before);
  });

  test("rounds all four corners of a grown rectangle", () => {
    const grown = offset([box(0, 0, 100, 40)], 0.8);
    const exact = 100 * 40 + 2 * 0.8 * (100 + 40) + Math.PI * 0.8 ** 2;
    expect(exact).toBeCloseTo(4226.01, 2);
    expect(areaOf(grown)).toBeCloseTo(exact, 1);
  });

  test("does not pile up points in a stock that is cut again and again", () => {
    const cuts = 500;
    let stock: Ring[] = [box(-100, 0, 100, 40)];
    for (let i = 0; i < cuts; i += 1) stock = difference(stock, [box(-i * 0.1 - 0.3, 39 - (i % 7) * 0.25, 0.4, 50)]);
    const points = stock.flat();
    const distinct = new Set(points.map((p) => `${p.z} ${p.r}`));
    expect(distinct.size).toBe(points.length);
    expect(stock.every((r) => r.length > 2 && areaOf([r]) !== 0)).toBe(true);
    // Every cut can leave at most two walls and the floor of its step.
    expect(points.length).toBeLessThan(4 * cuts);
    const swept = union(Array.from({ length: cuts }, (_, i) => box(-i * 0.1 - 0.3, 39 - (i % 7) * 0.25, 0.4, 50)));
    expect(areaOf(stock)).toBeCloseTo(areaOf(difference([box(-100, 0, 100, 40)], swept)), 4);
  });

  test("leaves out non-finite points, and keeps the rest", () => {
    const broken = ring([0, 0], [Number.NaN, 1], [1, 1]);
    expect(areaOf(union([broken, box(0, 0, 2, 2)]))).toBeCloseTo(4, 9);
    expect(offset([box(0, 0, 1, 1)], Number.POSITIVE_INFINITY)).toEqual([]);
  });
});
