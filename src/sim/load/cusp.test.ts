import { expect, test } from "vitest";
import { flat } from "../../kernel/geometry/flat.ts";
import { insertShape } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { degrees, length, radians } from "../../kernel/units.ts";
import { cuspOf, rzByRule, rzOfCircle } from "./cusp.ts";

const insert = (RS: number, T: number, P: number): Tool => ({
  T: 3,
  NAME: "INSERT",
  TYPE: "FINISH",
  TO: 1,
  RS: length(RS),
  "T-ANGLE": degrees(T),
  "P-ANGLE": degrees(P),
  CUTLENGTH: length(12),
});
const bar: Tool = {
  T: 9,
  NAME: "BAR-3",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0.2),
  CUTWIDTH: length(3),
  CUTLENGTH: length(30),
};
const outwards = flat.heading(Math.PI / 2);
const microns = (tool: Tool, feed: number, out = outwards) =>
  1000 * (cuspOf(insertShape(tool), out, feed)?.height ?? NaN);

test("rule of thumb and circle: f²/8r and its error", () => {
  expect(rzByRule(0.23, 0.8)).toBeCloseTo(8.265625, 9);
  expect(rzOfCircle(0.23, 0.8)).toBeCloseTo(8.3089, 3);
  expect(rzOfCircle(0.799, 0.4)).toBeGreaterThan(rzByRule(0.799, 0.4) * 1.9);
  expect(rzOfCircle(0.81, 0.4)).toBeNaN();
});

test.each([
  [0.08, 0.4],
  [0.137, 0.4],
  [0.31, 1.2],
])("feed %f with a nose of %f: the outline of the insert leaves the cusp of its circle", (feed, nose) => {
  const cusp = cuspOf(insertShape(insert(nose, 93, 35)), outwards, feed);
  expect(cusp?.by).toBe("nose");
  expect(cusp?.nose).toBe(nose);
  expect(1000 * (cusp?.height ?? 0)).toBeCloseTo(rzOfCircle(feed, nose), 6);
});

test("a sharp insert leaves a saw tooth: f / (cot κ + cot κ')", () => {
  const cot = (angle: number) => 1 / Math.tan(radians(angle));
  const cusp = cuspOf(insertShape(insert(0, 75, 62)), outwards, 0.37);
  expect(cusp?.by).toBe("partly");
  expect(cusp?.height).toBeCloseTo(0.37 / (cot(75) + cot(180 - 75 - 62)), 8);
});

test("an edge next to the nose takes part once the feed reaches it, and leaves less than the rule", () => {
  // At five degrees to the surface the nose forms it alone up to f = 2·r·sin 5°, 0.139 mm.
  const tool = insert(0.8, 95, 80);
  expect(cuspOf(insertShape(tool), outwards, 0.138)?.by).toBe("nose");
  expect(cuspOf(insertShape(tool), outwards, 0.141)?.by).toBe("partly");
  expect(microns(tool, 0.41)).toBeLessThan(0.8 * rzByRule(0.41, 0.8));
  expect(microns(tool, 0.41)).toBeGreaterThan(0.4 * rzByRule(0.41, 0.8));
});

test("a straight edge along the surface leaves no cusp, but at an angle the corner does", () => {
  expect(cuspOf(insertShape(bar), outwards, 0.17)).toEqual({ height: 0, by: "edge", nose: null });
  expect(cuspOf(insertShape(bar), flat.heading(radians(52)), 0.03)?.by).toBe("nose");
  expect(cuspOf(insertShape(bar), flat.heading(radians(52)), 0.03)?.nose).toBe(0.2);
});

test("no cusp without a feed, or with a feed wider than the tool", () => {
  for (const feed of [0, NaN, Infinity, 40]) expect(cuspOf(insertShape(bar), outwards, feed)).toBeNull();
});
