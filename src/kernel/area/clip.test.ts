import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf, areaOfRing } from "./area.ts";
import { difference, insideOf, intersection, offset, opened, packed, union, unpacked } from "./clip.ts";
import type { Ring } from "../geometry/point.ts";
import { axial, radius } from "../units.ts";

const ring = (...points: [number, number][]): Ring => points.map(([z, r]) => ({ z: axial(z), r: radius(r) }));
const box = (z0: number, r0: number, z1: number, r1: number) => ring([z0, r0], [z1, r0], [z1, r1], [z0, r1]);

describe("known faults of other ports", () => {
  test("an input point is not overwritten by an intersection", () => {
    const mm = (points: [number, number][]) => ring(...points.map(([x, y]): [number, number] => [x / 1e5, y / 1e5]));
    const triangle = mm([
      [-968021, 289005],
      [-943762, 302447],
      [-1000000, 237828],
    ]);
    const pentagon = mm([
      [-163353, 261701],
      [-163023, 262156],
      [-122651, 448734],
      [-968021, 289005],
      [-1021013, 204201],
    ]);
    expect(Math.abs(areaOf(difference([triangle], [pentagon])))).toBeCloseTo(66589013 / 1e10, 7);
  });
  test("a closed offset with round joins has the right area", () => {
    const exact = 100 * 40 + 2 * 0.8 * 140 + Math.PI * 0.8 ** 2;
    expect(areaOf(offset([box(0, 0, 100, 40)], 0.8))).toBeCloseTo(exact, 1);
  });
  test("cutting again and again leaves no empty rings and no double points", () => {
    let stock: Ring[] = [box(0, 0, 100, 40)];
    for (let i = 0; i < 300; i += 1) stock = difference(stock, [box(i / 3, 30, i / 3 + 2, 50)]);
    expect(stock).toHaveLength(1);
    expect(stock[0]!.length).toBeLessThan(12);
  });
});

test("a point in a hole, on an edge or beside an area is not inside it, one in an island of a hole is", () => {
  const isInside = insideOf([box(0, 0, 9, 9), [...box(1, 1, 8, 8)].reverse(), box(3, 3, 6, 6)]);
  const at = (z: number, r: number) => isInside({ z: axial(z), r: radius(r) });
  expect([at(0.5, 4), at(4, 4)]).toEqual([true, true]);
  expect([at(2, 4), at(10, 4), at(0, 4)]).toEqual([false, false, false]);
});

test("holes run the other way and count negative", () => {
  const frame = difference([box(0, 0, 10, 10)], [box(2, 2, 8, 8)]);
  expect(frame.map((r) => Math.sign(areaOfRing(r))).sort()).toEqual([-1, 1]);
  expect(areaOf(frame)).toBeCloseTo(64, 9);
});

test("a cut may part the stock", () => {
  expect(difference([box(0, 0, 10, 10)], [box(4, -1, 6, 11)])).toHaveLength(2);
});

test("a ring that is not finite is left out and nothing else is lost", () => {
  const broken = ring([0, 0], [NaN, 1], [1, Infinity]);
  expect(areaOf(difference([box(0, 0, 2, 2), broken], [broken]))).toBeCloseTo(4, 9);
  expect(offset([box(0, 0, 2, 2)], NaN)).toEqual([]);
  expect(areaOf(offset([broken, box(0, 0, 2, 2)], -0.5))).toBeCloseTo(1, 6);
});

test("opening drops thinner parts and keeps thicker ones", () => {
  const comb = union([box(0, 0, 10, 1)], [box(4, 0, 4.003, 5)]);
  expect(areaOf(opened(comb, 0.004))).toBeCloseTo(10, 3);
});

const coordinate = fc.integer({ min: -200_000, max: 200_000 }).map((n) => n / 1000);
const triangle = fc.tuple(coordinate, coordinate, coordinate, coordinate, coordinate, coordinate).map((c) => {
  const t = ring([c[0], c[1]], [c[2], c[3]], [c[4], c[5]]);
  return areaOfRing(t) < 0 ? [...t].reverse() : t;
});

test("area is preserved: the part cut off and the rest add up to the whole", () => {
  fc.assert(
    fc.property(triangle, triangle, (a, b) => {
      const together = areaOf(difference([a], [b])) + areaOf(intersection([a], [b]));
      expect(together).toBeCloseTo(areaOf([a]), 1);
      expect(Math.abs(together - areaOf([a]))).toBeLessThan(0.02);
    }),
    { numRuns: 500 },
  );
});

test("a stray ring of rounding does not turn an offset inside out", () => {
  const dust = ring([3, 5], [3.00001, 5.01], [3.00001, 5]);
  const turned = areaOfRing(dust) < 0 ? dust : [...dust].reverse();
  expect(areaOf(offset([turned, box(0, 0, 2, 2)], -0.5))).toBeCloseTo(1, 6);
  // One that reaches just as far, next to the outline: at equal height the engine takes the one on the left.
  const level = ring([-1, 2], [-0.999, 1.999], [-1, 1.999]);
  expect(areaOfRing(level)).toBeLessThan(0);
  for (const area of [
    [level, box(0, 0, 2, 2)],
    [box(0, 0, 2, 2), level],
  ]) {
    expect(areaOf(opened(area, 0.01))).toBeCloseTo(4, 2);
    expect(areaOf(offset(area, 0.5))).toBeCloseTo(8 + Math.PI / 4, 2);
  }
});

test("a blank larger than any lathe keeps its size when packed", () => {
  const huge = [box(-99999.999, 0, 0, 50000)];
  expect(unpacked(packed(huge))).toEqual(huge);
});

test("packing is exact for results of the engine", () => {
  fc.assert(
    fc.property(triangle, triangle, (a, b) => {
      const cut = difference([a], [b]);
      expect(unpacked(packed(cut))).toEqual(cut);
      expect(union(cut)).toHaveLength(union(union(cut)).length);
    }),
    { numRuns: 200 },
  );
});
