import { expect, test } from "vitest";
import { roundValues } from "./round-values.ts";

test.each([
  [0.244, 1, 0.25],
  [0.437, -1, 0.43],
  [32.417, -1, 32],
  [999.999, -1, 990],
  [7.3001, 1, 7.5],
  [-0.579, -1, -0.6],
] as const)("%d rounded %d: %d is what a setter types", (value, way, expected) =>
  expect(roundValues(value, way)[0]).toBe(expected),
);

test("what is exact stays so: nothing is rounded by more than a twentieth", () => {
  expect(roundValues(0, 1)[0]).toBe(0);
  expect(roundValues(0.0123, 1)).toEqual([]);
});
