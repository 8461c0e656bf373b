import { expect, test } from "vitest";
import { linePiece, upperEnvelope } from "../reach/envelope.ts";
import { basinsOf } from "./basins.ts";

const NOSE = { feature: "nose", on: "contour", corner: false } as const;
/** An envelope through points, from left to right. */
const through = (...points: readonly (readonly [u: number, v: number])[]) =>
  upperEnvelope(
    points.slice(1).flatMap(([u, v], i) => {
      const [before, under] = points[i] as readonly [number, number];
      return linePiece({ u: before, v: under }, { u, v }, NOSE) ?? [];
    }),
  );
const sections = (crest: number) =>
  basinsOf(through([0, 0], [2, -3], [4, crest], [6, -3], [8, 0]), { from: 0, to: 8 }, 0).map(({ from, to, bottom }) => [
    from,
    to,
    bottom,
  ]);

test("a crest separates two sections, however low it is; one within the tolerance does not", () => {
  const apart = [
    [expect.closeTo(0, 3), 4, -3],
    [4, expect.closeTo(8, 3), -3],
  ];
  expect(sections(-1)).toEqual(apart);
  expect(sections(-2.7)).toEqual(apart);
  expect(sections(-2.995)).toEqual([[expect.closeTo(0, 3), expect.closeTo(8, 3), -3]]);
});
