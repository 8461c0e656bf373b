import { describe, expect, test } from "vitest";
import { holderOutlines } from "./holder.ts";
import { hullOf } from "./hull.ts";
import type { Ring } from "../geometry/point.ts";
import type { Holder, TipOrientation, Tool } from "../plan/tool.ts";
import { length } from "../units.ts";

const box = { width: length(20), length: length(100), offsetZ: length(3), offsetX: length(-7) };
const held = (TO: TipOrientation, holder: Holder): Tool => ({
  T: 1,
  NAME: "",
  TYPE: "BUTTON",
  TO,
  RS: length(2),
  holder,
});
const sides = (ring: Ring | undefined) => {
  const [z, r] = [(ring ?? []).map((p) => p.z), (ring ?? []).map((p) => p.r)];
  return [Math.min(...z), Math.max(...z), Math.min(...r), Math.max(...r)];
};

describe("the shank", () => {
  test.each<[TipOrientation, "X" | "Z" | undefined, number[]]>([
    [1, undefined, [3, 23, -7, 93]],
    [2, undefined, [3, 23, -7, 93]],
    [3, undefined, [-17, 3, -7, 93]],
    [9, undefined, [3, 23, -7, 93]],
    [4, undefined, [-97, 3, -7, 13]],
    [8, undefined, [3, 103, -7, 13]],
    [5, undefined, [-97, 3, -27, -7]],
    [6, undefined, [3, 103, -27, -7]],
    [7, undefined, [3, 103, -27, -7]],
    [1, "Z", [3, 103, -7, 13]],
    [7, "X", [3, 23, -107, -7]],
    [8, "X", [3, 23, -7, 93]],
  ])("TO %i along %s lies away from the tip", (to, axis, expected) =>
    expect(sides(holderOutlines(held(to, { ...box, ...(axis && { axis }) }))[0])).toEqual(expected),
  );
});

test("a correction moves the holder with the insert", () => {
  const tool = { ...held(1, box), correction: { z: length(0.25), r: length(-0.5) } };
  expect(sides(holderOutlines(tool)[0])).toEqual([3.25, 23.25, -7.5, 92.5]);
});

test("a concave part is replaced by its convex hull, counter-clockwise", () =>
  expect(
    hullOf([
      [0, 0],
      [0, 4],
      [1, 1],
      [4, 0],
      [2, 0],
    ]),
  ).toEqual([
    [0, 0],
    [4, 0],
    [0, 4],
  ]));
