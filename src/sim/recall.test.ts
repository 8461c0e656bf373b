import { expect, test } from "vitest";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { recalling } from "./recall.ts";

const ring = (...points: readonly (readonly [number, number])[]): Ring => points.map(([z, r]) => at(z, r));
const triangle = ring([0.1, 2.3], [4.7, 2.3], [0.1, 6.11]);

test("the same rings are asked about once, also in the simulation that follows", () => {
  const asked: (readonly Ring[])[] = [];
  const known = recalling((area) => asked.push(area));
  expect([known.of([triangle]), known.of([[...triangle]])]).toEqual([1, 1]);
  known.next();
  expect(known.of([triangle.map((p) => ({ ...p }))])).toBe(1);
  known.next();
  known.next();
  expect(known.of([triangle])).toBe(2);
});

test("another point, another order and another ring are another area", () => {
  const known = recalling((area) => area);
  const areas = [
    [triangle],
    [triangle, triangle],
    [[...triangle.slice(1), ...triangle.slice(0, 1)]],
    [ring([0.1, 2.3], [4.7, 2.3], [0.1, 6.1100001])],
    [],
  ];
  for (const area of areas) expect(known.of(area)).toBe(area);
  for (const area of areas) expect(known.of(area.map((each) => [...each]))).toBe(area);
});
