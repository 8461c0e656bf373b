import { expect, test } from "vitest";
import type { Flat, Frame } from "../geometry/flat.ts";
import type { Tool } from "../plan/tool.ts";
import { heightAt } from "../reach/envelope.ts";
import { length } from "../units.ts";
import { tipEnvelopeOver } from "./tip-envelope.ts";

const disc: Tool = { T: 1, NAME: "DISC", TYPE: "BUTTON", TO: 8, RS: length(3), CUTLENGTH: length(3) };
const along: Frame = { transverse: false, signU: -1, signV: 1 };
const inwards: Frame = { transverse: true, signU: -1, signV: 1 };
const outwards: Frame = { transverse: true, signU: 1, signV: 1 };

/**
 * Heights of the tip over a contour of lines, every 0.5 mm of 16 mm around the place where it leaves the axis; across
 * the axis also where the path begins and ends.
 */
function tipsOver(points: string, frame: Frame, place: number) {
  const corners = points
    .trim()
    .split(" ")
    .map((point): Flat => {
      const [u = NaN, v = NaN] = point.split("/").map(Number);
      return { u, v };
    });
  const bounds = corners.slice(1).map((to, i) => {
    const from = corners[i] as Flat;
    return { segment: { kind: "line", from, to }, on: "contour" } as const;
  });
  const over = { wall: null, front: "free", frontWall: null, floors: [] } as const;
  const { envelope, start, end } = tipEnvelopeOver(bounds, disc, frame, { u: 0, v: 0 }, over);
  const heights = Array.from({ length: 33 }, (_, i) => Number(heightAt(envelope, place - 8 + i / 2).toFixed(6)));
  return { heights, ends: frame.transverse && { start, end } };
}

/** The cylinder comes before the contour or behind it. Corners as u/v. */
test.each([
  ["in front of a face", along, 10, "-2/0", "10/0 10/20 30/20", ""],
  ["in front of a cone", along, 10, "0/0", "10/0 25/20 40/20", ""],
  ["behind a face towards the axis", inwards, 0, "", "-20/0 0/0", "0/5"],
  ["in front of a face away from the axis", outwards, 0, "0/5", "0/0 20/0", ""],
])("a cylinder without a radius %s is no obstacle", (_, frame, place, before, contour, behind) => {
  expect(tipsOver(`${before} ${contour} ${behind}`, frame, place)).toEqual(tipsOver(contour, frame, place));
});
