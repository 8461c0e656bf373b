import { describe, expect, test } from "vitest";
import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { isWithin, measuredSegments, type MeasuredFeature } from "./measured-feature.ts";

const chain = (...points: readonly Pt[]) => points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
/** A face, a chamfer, a cylinder of 40 mm, a shoulder, a cone of 10°, a face. */
const CONE = 25 + 20 * Math.tan(Math.PI / 18);
const outline = chain(at(0, 0), at(0, 19), at(-1, 20), at(-30, 20), at(-30, 25), at(-50, CONE), at(-50, 35));
const diameter = (r: number, left: number, right: number, slack = 0): MeasuredFeature => ({
  kind: "diameter",
  r,
  left,
  right,
  limits: [r - slack, r + slack],
});
const length = (z: number, slack = 0): MeasuredFeature => ({ kind: "length", z, limits: [z - slack, z + slack] });

describe("the elements that a size of a drawing measures", () => {
  test.each<[string, MeasuredFeature, readonly number[]]>([
    ["a diameter on its stretch", diameter(20, -30, 0), [2]],
    ["another stretch of the same diameter", diameter(20, -60, -31), []],
    ["a diameter within its tolerance", diameter(20.03, -30, 0, 0.04), [2]],
    ["a diameter outside of its tolerance", diameter(20.03, -30, 0, 0.02), []],
    ["a length: the face there", length(-30), [3]],
    ["a length within its tolerance", length(-50.1, 0.2), [5]],
    ["a length where nothing is", length(-40), []],
    ["the end of a cone by its diameter: what ends there", diameter(25, -31, -29), [3, 4]],
    ["the sharp corner before its chamfer: what would meet there", diameter(20, -0.5, 0.5), [0, 2]],
    ["a corner by its middle", { kind: "corner", size: 1, places: [at(-0.5, 19.5)] }, [1]],
    ["a corner that is elsewhere", { kind: "corner", size: 1, places: [at(-0.5, 19.6)] }, []],
    [
      "the angle of a cone at its place",
      { kind: "angle", degrees: 10, places: [at(-40, 25 + 10 * Math.tan(Math.PI / 18))] },
      [4],
    ],
    ["another angle there", { kind: "angle", degrees: 11, places: [at(-40, 25 + 10 * Math.tan(Math.PI / 18))] }, []],
    ["the angle elsewhere", { kind: "angle", degrees: 10, places: [at(-10, 20)] }, []],
  ])("%s", (_, feature, segments) => expect(measuredSegments(feature, outline)).toEqual(segments));

  test("a limit is kept within rounding", () => {
    expect([9.994, 9.996, 10.5, 11.004, 11.006].map((value) => isWithin([10, 11], value))).toEqual([
      false,
      true,
      true,
      true,
      false,
    ]);
  });
});
