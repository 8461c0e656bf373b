import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import { toScreen, type Camera } from "../camera.ts";
import { isWholeIn, labelsOverlap, middleOf, runsThrough } from "./labels.ts";
import { measuredOnPaper } from "../drawing/measured.ts";
import type { Dimension } from "./dimension.ts";
import { placedDimensions, type DimensionPaper, type DimensionRequest } from "./placed-dimensions.ts";

const camera: Camera = { scale: 4.37, zero: { x: 613.5, y: 387.25 }, xUp: true };
const paper: DimensionPaper = {
  camera,
  unit: 1,
  size: { width: 817, height: 463 },
  room: { x: 52, y: 6, width: 817 - 58, height: 463 - 34 },
  kept: [{ x: 54, y: 8, width: 250, height: 86 }],
};
const asked = (key: string, measured: Dimension, text: string): DimensionRequest => ({
  key,
  measured,
  text,
  needed: true,
});
const some: readonly DimensionRequest[] = [
  asked("1", { form: "diameter", at: at(-27.77, 8.5) }, "⌀17.000"),
  asked("2", { form: "diameter", at: at(-28.1, 21.03) }, "⌀42.060"),
  asked("3", { form: "z", from: at(-54.87, 23.1), to: at(-1.15, 8.5) }, "53.72"),
  asked("4", { form: "r", from: at(-14.87, 10.1), to: at(-14.87, 21.01) }, "10.91"),
  asked("5", { form: "radius", at: at(-14.4, 8.97), centre: at(-13.27, 10.1) }, "R1.6"),
  asked("6", { form: "angle", vertex: at(-1.15, 8.5), from: at(-1.149, 8.5), to: at(28.736, 11.116) }, "5°"),
  asked("7", { form: "along", from: at(-41.3, 3.3), to: at(-9.9, 17.2) }, "34.34"),
  asked("8", { form: "circle", at: at(-33.1, 14.2), centre: at(-33.1, 9.7) }, "⌀9.000"),
];

/** All pairs of numbers of path data. */
const numbers = (d: string): number[] => (d.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);
/** Both ends of the straight lines of path data. */
const ends = (d: string) =>
  [...d.matchAll(/M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)/g)].map((m) => m.slice(1).map(Number));

describe("dimensions over the picture", () => {
  const standing = placedDimensions(paper, some);

  test("all dimensions are on the picture, in their order, clear of each other and of kept boxes", () => {
    expect(standing.map(({ key }) => key)).toEqual(some.map(({ key }) => key));
    const boxes = [...paper.kept, ...standing.map(({ box }) => box)];
    for (const [i, a] of boxes.entries()) for (const b of boxes.slice(i + 1)) expect(labelsOverlap(a, b)).toBe(false);
    for (const { box } of standing) {
      expect(isWholeIn(box, paper.room)).toBe(true);
    }
  });

  test("while there is room no line crosses a text, neither of a measurement nor of the drawing", () => {
    const through = ({ key, pieces }: (typeof standing)[number]) =>
      standing
        .filter((other) => other.key !== key && pieces.some((piece) => runsThrough(piece, other.box)))
        .map((other) => `${key} through ${other.key}`);
    expect(standing.flatMap(through)).toEqual([]);
    // The first place of a length is in line with a text of the drawing, which its line would cross.
    const length = asked("1", { form: "z", from: at(-54.87, 23.1), to: at(-1.15, 8.5) }, "53.720");
    const [plain] = placedDimensions({ ...paper, kept: [] }, [length]),
      y = plain ? middleOf(plain.box).y : 0;
    const kept = [{ x: 420, y: y - 8, width: 30, height: 16 }],
      [clear] = placedDimensions({ ...paper, kept }, [length]);
    expect(Math.abs((clear ? middleOf(clear.box).y : y) - y)).toBeGreaterThan(8);
  });

  test("a text placed by hand stays there, whatever it covers, and its dimension follows", () => {
    const put = at(-37.3, 31.9),
      [one] = placedDimensions(paper, [{ ...some[2]!, put }]);
    expect(one && middleOf(one.box)).toEqual(toScreen(camera, put));
    const level = ends(one?.lines ?? "").filter(([, y, , y2]) => y === y2);
    // The dimension line runs at the height of the text, between what is measured.
    expect(level).toHaveLength(1);
    expect(level[0]?.[1]).toBeCloseTo(387.25 - 31.9 * 4.37, 1);
    expect(level[0]?.[0]).toBeCloseTo(613.5 - 54.87 * 4.37, 1);
    expect(level[0]?.[2]).toBeCloseTo(613.5 - 1.15 * 4.37, 1);
  });

  test("a diameter goes right across, with both its ends on the part", () => {
    const [drawn] = placedDimensions(paper, [{ ...some[1]!, put: at(-28.1, 11.2) }]);
    const heights = ends(drawn?.lines ?? "").flatMap(([, y = 0, , y2 = 0]) => [y, y2]);
    expect(Math.max(...heights)).toBeCloseTo(387.25 + 21.03 * 4.37, 1);
    expect(Math.min(...heights)).toBeCloseTo(387.25 - 21.03 * 4.37, 1);
  });

  test("arrows stand outside where a length is too short for them", () => {
    const short = { form: "z", from: at(-3.31, 9.1), to: at(-1.15, 9.1) } as const,
      [one] = placedDimensions(paper, [asked("1", short, "2.16")]);
    const tips = [...(one?.arrows ?? "").matchAll(/M([-\d.]+) [-\d.]+L([-\d.]+)/g)].map(([, tip, back]) => [
      Number(tip),
      Number(back),
    ]);
    const [left, right] = [613.5 - 3.31 * 4.37, 613.5 - 1.15 * 4.37];
    expect(tips[0]?.[0]).toBeCloseTo(left, 1);
    expect(tips[0]?.[1]).toBeLessThan(left);
    expect(tips[1]?.[0]).toBeCloseTo(right, 1);
    expect(tips[1]?.[1]).toBeGreaterThan(right);
  });

  test("whatever is measured and wherever its text is put, all lines are drawn with numbers", () =>
    fc.assert(
      fc.property(
        fc.constantFrom(...some),
        fc.double({ min: -200, max: 200, noNaN: true }),
        fc.double({ min: -200, max: 200, noNaN: true }),
        fc.constantFrom(0.05, 3.1, 1999),
        fc.boolean(),
        (one, z, r, scale, xUp) => {
          const [drawn] = placedDimensions({ ...paper, camera: { ...camera, scale, xUp } }, [
            { ...one, put: at(z, r) },
          ]);
          const all = numbers(`${drawn?.lines}${drawn?.arrows}`);
          expect(all.length).toBeGreaterThan(3);
          expect(`${drawn?.lines}${drawn?.arrows}`).not.toMatch(/NaN|Infinity|undefined/);
        },
      ),
    ));
});

test("on the sheet they are as large as its figures, in frames with round ends, clear of the sheet's own dimensions", () => {
  const kept = [{ x: 80, y: 20, width: 20, height: 60 }];
  const camera = { scale: 0.83, zero: { x: 71.3, y: 44.1 }, xUp: true };
  const made = measuredOnPaper(some, camera, { width: 124, height: 96 }, kept);
  expect(made.omitted).toBe(0);
  expect(made.texts.map(({ text }) => text)).toEqual(some.map(({ text }) => text));
  const frames = made.shapes.filter(({ role }) => role === "measured").map(({ d }) => d);
  expect(frames).toHaveLength(some.length);
  for (const [i, frame] of frames.entries()) {
    const [x = 0, y = 0, long = 0, r = 0] = frame.match(/-?[\d.]+/g)?.map(Number) ?? [];
    const box = { x: x - r, y, width: long + 2 * r, height: 2 * r };
    expect(box.height).toBeCloseTo((20 * 3) / 13, 1);
    expect(kept.some((each) => labelsOverlap(each, box))).toBe(false);
    expect(frame).toMatch(/^M.*a.*a.*Z$/);
    expect(box.x).toBeGreaterThanOrEqual(1);
    expect(box.x + box.width).toBeLessThanOrEqual(123.02);
    expect(made.texts[i]?.at.y).toBeCloseTo(y + r, 1);
  }
});
