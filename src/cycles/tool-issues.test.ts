import { expect, test } from "vitest";
import type { Frame } from "../kernel/geometry/flat.ts";
import { at, type Segment } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { length } from "../kernel/units.ts";
import { angleIssues } from "./tool-issues.ts";

/* A facing tool with an insert of 55°. */
const frame: Frame = { transverse: true, signU: -1, signV: 1 };
const tool = {
  T: 1,
  NAME: "FACE",
  TYPE: "ROUGH",
  TO: 8,
  RS: length(0.8),
  "T-ANGLE": 93,
  "P-ANGLE": 55,
  CUTLENGTH: length(9),
} as unknown as Tool;
const along = (...points: (readonly [z: number, r: number])[]): Segment[] =>
  points
    .slice(1)
    .map((p, i) => ({ kind: "line", from: at(...(points[i] as readonly [number, number])), to: at(...p) }));
const told = (contour: Segment[], elements: number[]) =>
  angleIssues({ contour, elements }, tool, frame, (_q, direction) => direction);

test("in a contour, the element that exceeds the limit most is reported, at its programmed place", () => {
  const contour = along([-20, 37.5], [-20, 25], [-31, 15], [-43, 7]);
  const [found, ...more] = told(contour, [3, 2, 1]);
  expect(more).toEqual([]);
  expect(found).toMatchObject({
    code: "angleNotFollowed",
    at: "contour",
    data: { element: 1, angle: expect.closeTo(-56.31, 2) },
  });
  expect(found?.data).not.toHaveProperty("nearest");
});

test("an element that turns back under the part is measured from the edge that falls, not the other way round", () => {
  const [found] = told(along([-20, 37.5], [-20, 25], [-25, 10], [-30, 35]), [1, 2, 3]);
  const { angle, max } = (found?.data ?? {}) as { angle: number; max: number };
  expect(angle).toBeCloseTo(-168.69, 2);
  expect(max).toBeLessThan(0);
  expect(max).toBeGreaterThan(-90);
});
