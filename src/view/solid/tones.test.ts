import { expect, test } from "vitest";
import { at, type Segment } from "../../kernel/point.ts";
import { tonedSides } from "./tones.ts";

const way = (...points: readonly (readonly [z: number, r: number])[]): Segment[] =>
  points.slice(1).map(([z, r], i): Segment => ({ kind: "line", from: at(points[i]?.[0] ?? 0, points[i]?.[1] ?? 0), to: at(z, r) }));

test.each([
  ["pieces of one line are one side", [{ tone: 2, segments: way([0, 7.3], [-1.1, 7.3], [-2.9, 7.3], [-5.7, 7.3]) }], [[
    0,
    7.3,
    -5.7,
    7.3,
    2,
  ]]],
  ["also of a cone", [{ tone: 5, segments: way([0, 7], [-1.1, 7.22], [-3.3, 7.66]) }], [[0, 7, -3.3, 7.66, 5]]],
  ["a corner parts them", [{ tone: 5, segments: way([0, 7], [-1.1, 7], [-1.1, 9.4]) }], [[0, 7, -1.1, 7, 5], [-1.1, 7, -1.1, 9.4, 5]]],
  ["so does a gap", [{ tone: 1, segments: [...way([0, 7], [-1, 7]), ...way([-1.4, 7], [-2, 7])] }], [[0, 7, -1, 7, 1], [
    -1.4,
    7,
    -2,
    7,
    1,
  ]]],
  ["and what runs back", [{ tone: 1, segments: way([0, 7], [-1, 7], [-0.4, 7]) }], [[0, 7, -1, 7, 1], [-1, 7, -0.4, 7, 1]]],
  ["another tone", [{ tone: 1, segments: way([0, 7], [-1, 7]) }, { tone: 6, segments: way([-1, 7], [-2, 7]) }], [[0, 7, -1, 7, 1], [
    -1,
    7,
    -2,
    7,
    6,
  ]]],
  ["where no number is told there is none", [{ tone: null, segments: way([0, 7], [-1, 7]) }], []],
])("%s", (_, lines, sides) => {
  expect(tonedSides(lines).map(({ z0, r0, z1, r1, tone }) => [z0, r0, z1, r1, tone])).toEqual(sides);
});
