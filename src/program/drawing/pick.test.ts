import { expect, test } from "vitest";
import { at, part, type Segment } from "../../kernel/geometry/point.ts";
import { contourOf } from "./formats.ts";
import type { ContourChoice, Drawing, DrawnCurve, LineRole } from "./drawing.ts";
import { backPlacingOf, placingOf } from "./halves.ts";
import { segmentsOnDrawing } from "./on-drawing.ts";
import { picked, stepped, type ArrowKey, type PickKind } from "./pick.ts";
import { nearestCurve, nextPosition, rowNear, snapped } from "./positions.ts";
import { PLAIN_CHOICE } from "./propose.ts";

type Place = readonly [number, number];
const line = ([a, b]: Place, [c, d]: Place, role: LineRole = "outline", layer = "0"): DrawnCurve => ({
  segment: part.line(at(a, b), at(c, d)),
  layer,
  kind: "LINE",
  role,
});
const closed = (places: readonly Place[]) =>
  places.map((place, i) => line(place, places[(i + 1) % places.length] as Place));

/**
 * A bush in full section about y = 50 with its face at x = 100, its axis as a centre line, a separate stepped pin below
 * it, and an inclined line.
 */
const bush = (side: number): Place[] => [
  [60, 50 + side * 10],
  [60, 50 + side * 20],
  [90, 50 + side * 20],
  [90, 50 + side * 26],
  [100, 50 + side * 26],
  [100, 50 + side * 10],
];
const DRAWING: Drawing = {
  curves: [
    ...closed(bush(1)),
    ...closed(bush(-1)),
    line([50, 50], [110, 50], "centre"),
    line([0, 90], [30, 90]),
    line([30, 90], [30, 98]),
    line([0, 0], [20, 10]),
    line([90, 76], [90, 84], "thin", "DIM"),
  ],
  unit: { unit: "mm", source: "file" },
  texts: [],
  tolerance: 0,
  notes: [],
};
const CHOICE: ContourChoice = { ...PLAIN_CHOICE, axisAt: 50, zero: 100 };
const read = (choice: ContourChoice) => contourOf(DRAWING, choice);
const tap = (of: PickKind, place: Place, choice: Partial<ContourChoice> = {}, within = 1) =>
  picked(of, DRAWING, { ...CHOICE, ...choice }, at(...place), within, read);

test.each<[string, Place, Partial<ContourChoice>, Partial<ContourChoice>]>([
  ["outside", [75, 70.4], { side: "bore" }, { half: "upper", piece: 0, side: "outside" }],
  ["the bore", [75, 60.3], {}, { half: "upper", piece: 0, side: "bore" }],
  ["outside of the other half", [75, 30], {}, { half: "lower", piece: 0, side: "outside" }],
  ["the bore of the other half", [75, 40], {}, { half: "lower", piece: 0, side: "bore" }],
  ["another piece", [10, 90], {}, { half: "upper", piece: 1 }],
  ["empty paper beyond the axis", [120, 30], {}, { half: "lower", piece: 0 }],
])("a tap on a line of the contour: %s", (_, place, now, change) => {
  expect(tap("contour", place, now)).toEqual({ change });
});

test.each<[string, PickKind, Place, string]>([
  ["empty paper of the half that is taken", "contour", [120, 90], "nothingHere"],
  ["an inclined line as axis", "axis", [10, 5], "notStraight"],
  ["no line as axis", "axis", [150, 150], "nothingHere"],
  ["no point as zero", "zero", [150, 150], "nothingHere"],
])("a tap that selects nothing: %s", (_, of, place, refused) => {
  expect(tap(of, place)).toEqual({ refused });
});

test("a centre line is the axis although an outline is as near, and all is proposed for it", () => {
  expect(tap("axis", [60, 54], {}, 7)).toMatchObject({ change: { axis: "x", axisAt: 50, zero: 100, half: "upper" } });
});

test.each<[Place, number, Partial<ContourChoice>]>([
  [[60, 70], 2, { axis: "x", axisAt: 70 }],
  [[90, 73], 2, { axis: "y", axisAt: 90 }],
])("a tap at %j makes a line the axis; tolerance and layers stay", (place, within, on) => {
  const kept = { gap: 0.3, withoutLayers: ["DIM"], thin: true };
  expect(tap("axis", place, kept, within)).toMatchObject({ change: { ...on, ...kept } });
});

test.each<[string, Place, number]>([
  ["an end point", [59.4, 70.2], 60],
  ["a line across the axis", [90.4, 73], 90],
])("a tap on %s sets Z0", (_, place, zero) => {
  expect(tap("zero", place)).toEqual({ change: { zero } });
});

test("thin lines and lines of layers left out are no contour, unless they are asked for", () => {
  expect(tap("contour", [90, 82], {}, 0.5)).toEqual({ refused: "nothingHere" });
  expect(tap("contour", [90, 82], { thin: true }, 0.5)).toMatchObject({ change: { half: "upper" } });
  expect(tap("contour", [90, 82], { thin: true, withoutLayers: ["DIM"] }, 0.5)).toEqual({ refused: "nothingHere" });
});

test.each<[PickKind, ArrowKey, Partial<ContourChoice>, Partial<ContourChoice> | null]>([
  ["contour", "ArrowDown", {}, { half: "lower", piece: 0 }],
  ["contour", "ArrowUp", {}, null],
  ["contour", "ArrowRight", {}, { piece: 1 }],
  ["contour", "ArrowLeft", {}, null],
  ["contour", "ArrowRight", { axis: "y", axisAt: 0, half: "lower" }, { half: "upper", piece: 0 }],
  ["zero", "ArrowLeft", {}, { zero: 90 }],
  ["zero", "ArrowRight", {}, null],
  ["zero", "ArrowUp", {}, null],
  ["axis", "ArrowUp", {}, { axis: "x", axisAt: 60 }],
  ["axis", "ArrowDown", {}, { axis: "x", axisAt: 40 }],
  ["axis", "ArrowRight", {}, { axis: "y" }],
])("%s by %s from %j", (of, key, now, change) => {
  const next = stepped(of, key, DRAWING, { ...CHOICE, ...now }, read);
  if (change) expect(next).toMatchObject(change);
  else expect(next).toBeNull();
});

const both = <T>(values: readonly [T, T]) => values;
const PLACINGS = both(["x", "y"] as const).flatMap((axis) =>
  both([false, true]).flatMap((mirrored) =>
    both(["upper", "lower"] as const).flatMap((half) =>
      both([false, true]).map((diameters) => ({ ...CHOICE, axis, mirrored, half, diameters })),
    ),
  ),
);
test.each(PLACINGS)(
  "the contour lies where it was drawn: $axis $half mirrored $mirrored diameters $diameters",
  (choice) => {
    const arc: Segment = { kind: "arc", from: at(-5, 12), to: at(-9, 16), centre: at(-5, 16), turn: "cw" };
    const on = segmentsOnDrawing(choice, [part.line(at(0, 12), at(-5, 12)), arc]);
    const put = placingOf(choice);
    for (const [i, fraction] of [
      [0, 0.3],
      [1, 0.5],
    ] as const) {
      const s = i === 0 ? part.line(at(0, 12), at(-5, 12)) : arc;
      const place = backPlacingOf(choice)(part.pointOn(s, fraction));
      expect(Math.min(...(on[i] ?? []).map((drawn) => part.distanceTo(drawn, place)))).toBeLessThan(0.1);
      expect(put(place).r).toBeCloseTo(part.pointOn(s, fraction).r, 9);
    }
  },
);

test("positions snap to the nearest one in reach, and else to whole micrometres", () => {
  expect([snapped([10, 20], 19.4, 1), snapped([10, 20], 15.12345, 1), snapped([], 3.00049, 1)]).toEqual([
    20, 15.123, 3,
  ]);
  expect([nextPosition([1, 2, 3], 2, 1), nextPosition([1, 2, 3], 2, -1), nextPosition([1, 2, 3], 3, 1)]).toEqual([
    3, 1, 3,
  ]);
});

test("the nearest curve, and the nearest row of a note", () => {
  expect(nearestCurve(DRAWING.curves, at(95, 76.4), 1)).toBe(3);
  expect(nearestCurve(DRAWING.curves, at(95, 80), 1)).toBeNull();
  expect(rowNear(CHOICE, [at(0, 0), null, at(-10, 26)], at(89, 75))).toBe(2);
  expect(rowNear(CHOICE, [], at(0, 0))).toBeNull();
});
