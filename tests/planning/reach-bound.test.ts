import { expect, test } from "vitest";
import { areaOf } from "../../src/kernel/area/area.ts";
import { at, type Ring } from "../../src/kernel/geometry/point.ts";
import type { Tool } from "../../src/kernel/plan/tool.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { touched } from "./reach-bound.ts";

const box = (rear: number, front: number, low: number, high: number): Ring => [
  at(rear, low),
  at(front, low),
  at(front, high),
  at(rear, high),
];
const tool = (T: number): Tool => {
  const found = shippedTools.find((each) => each.T === T);
  if (!found) throw new Error(`no T${T}`);
  return found;
};

/** A shaft of ⌀40 with a groove, and a hollow one. */
const GROOVED = (width: number) => [box(-30, 0, 0, 20), box(-60, -30 - width, 0, 20), box(-60, 0, 0, 15)];
const TUBE = [box(-60, 0, 12, 30)];

test.each([
  ["a blade of 3 mm goes into a groove of 4 mm", 9, GROOVED(4), box(-34, -30, 15, 20), 19.9, 20],
  ["it does not go into one of 2.5 mm", 9, GROOVED(2.5), box(-32.5, -30, 15, 20), 0, 0.1],
  ["an insert of 80° does not reach the ground of a groove", 1, GROOVED(4), box(-34, -30, 15, 16), 0, 0],
  ["a tool for the outside does not reach the wall of a bore", 1, TUBE, box(-40, -30, 11, 12), 0, 0],
  ["a ring above a shaft is reached from outside", 1, [box(-60, 0, 0, 20)], box(-40, -10, 20, 22), 59.9, 60],
] as const)("%s", (_, T, stays, area, least, most) => {
  const found = areaOf(touched([area], stays, tool(T)));
  expect(found).toBeGreaterThanOrEqual(least);
  expect(found).toBeLessThanOrEqual(most + 0.01);
});
