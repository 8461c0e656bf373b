import { expect, test } from "vitest";
import { part } from "../../kernel/geometry/point.ts";
import { outerOutlineData } from "./outer-outline.ts";

const ring = (...places: readonly (readonly [z: number, r: number])[]) => places.map(([z, r]) => part.point(z, r));

const CASES = [
  ["nothing", [], ""],
  ["a bored blank", [ring([-40, 6], [0, 6], [0, 20], [-40, 20])], "M-40 0L-40 20L0 20L0 0"],
  [
    "a shoulder, a groove in its face and a bore behind it",
    [
      ring(
        [-40, 0],
        [-12, 0],
        [-12, 5],
        [0, 5],
        [0, 8],
        [-3, 8],
        [-3, 11],
        [0, 11],
        [0, 15],
        [-25.5, 15],
        [-25.5, 20],
        [-40, 20],
      ),
    ],
    "M-40 0L-40 20L-25.5 20L-25.5 15L0 15L0 0",
  ],
  [
    "two parts",
    [ring([-40, 0], [-20, 0], [-20, 10], [-40, 10]), ring([-16, 0], [0, 0], [0, 8], [-16, 8])],
    "M-40 0L-40 10L-20 10L-20 0M-16 0L-16 8L0 8L0 0",
  ],
] as const;

test.each(CASES)("the outside view of %s", (_, rings, wanted) => {
  expect(outerOutlineData(rings)).toBe(wanted);
});
