import { expect, test } from "vitest";
import { reachOfStep } from "./plunge-places.ts";

test("plunges are no farther apart than a step, nor than the level part of the edge where that is most of it", () => {
  const edge = { width: 3, level: 2.6, comb: false };
  expect(reachOfStep({ ...edge, step: 2.4 })).toBe(2.4);
  expect(reachOfStep({ ...edge, step: 3 })).toBe(2.6);
  // A round edge leaves crests anyway, which the cut along the wall takes.
  expect(reachOfStep({ ...edge, level: 1.2, step: 3 })).toBe(3);
  // A comb: half a web and half an edge.
  expect(reachOfStep({ ...edge, step: 2, comb: true })).toBe(2.5);
});
