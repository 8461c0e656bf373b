import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import { hasFreeEdge, surfacesOf } from "./stock-surface.ts";

const point = ([z, r]: readonly [number, number]) => at(axial(z), radius(r));

/** A bored shaft: a groove behind its front cylinder, then a step up; a groove in the bore. */
const SHAFT = [
  (
    [
      [0, 20],
      [0, 35],
      [-12, 35],
      [-12, 33],
      [-15, 33],
      [-15, 40],
      [-60, 40],
      [-60, 20],
      [-33, 20],
      [-33, 22],
      [-30, 22],
      [-30, 20],
    ] as const
  ).map(point),
];

test.each([
  ["outside", [true, false, true]],
  ["inside", [true, false, true]],
] as const)("an edge %s is free where nothing stands in front of it", (site, free) => {
  const surfaces = surfacesOf(SHAFT, site);
  expect(surfaces.map((each) => hasFreeEdge(each, SHAFT))).toEqual(free);
});
