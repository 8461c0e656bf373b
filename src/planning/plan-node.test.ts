import { expect, test } from "vitest";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { workIn } from "./open-regions.ts";
import { Ends, type PlanNode } from "./plan-node.ts";

/** An end that leaves some mm² and costs some seconds. */
const end = (left: number, cost: number): PlanNode => ({
  stock: [],
  done: [],
  threads: new Set(),
  before: null,
  tried: null,
  cost,
  seconds: cost,
  left,
  volume: 0,
  skin: 0,
  open: [],
});

test("what an end leaves counts from the least of all, not from the one before", () => {
  const ends = new Ends();
  const [least, little, more] = [end(0, 30), end(0.04, 20), end(0.08, 10)];
  expect(ends.isBetter(little, least)).toBe(true);
  expect(ends.isBetter(more, little)).toBe(false);
});

test.each([
  ["much more is left", end(1, 10), end(0, 20), false],
  ["as much is left in less time", end(1, 10), end(1.04, 20), true],
  ["as much is left in the same time", end(1, 10), end(1, 10), false],
])("an end is compared with another: %s", (_, a, b, isBetter) => {
  expect(new Ends().isBetter(a, b)).toBe(isBetter);
});

test("pieces that are no work do not add up to some", () => {
  const square = (size: number, z: number): Ring => [at(z, 0), at(z + size, 0), at(z + size, size), at(z, size)];
  const corners = Array.from({ length: 9 }, (_, i) => square(0.2, i));
  expect(workIn(corners)).toBe(0);
  expect(workIn([...corners, square(1, 20)])).toBeCloseTo(1);
});
