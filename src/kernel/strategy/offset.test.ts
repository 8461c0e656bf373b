import { expect, test } from "vitest";
import type { Issue } from "../plan/issue.ts";
import { offsetPerPass } from "./offset.ts";

/*
 * The sum may reach 80 % of a width of 2.6 mm, 2.08 mm. The first of nine passes is whole; the other eight are
 * shortened on one side if all run the same way, four on either side if they alternate.
 */
test.each([
  [0.26, true, 0.26, []],
  [0.261, true, 0.26, [["offsetReduced", 0.26]]],
  [0.52, false, 0.52, []],
  [0.53, false, 0.52, [["offsetReduced", 0.52]]],
  [0, true, 0.1, []],
  [0, false, 0.1, []],
] as const)("nine passes, Q508 = %f, one way %s: %f", (programmed, oneWay, kept, said) => {
  const issues: Issue[] = [];
  expect(offsetPerPass(programmed, 9, oneWay, 2.6, issues)).toBeCloseTo(kept, 9);
  expect(issues.map((i) => [i.code, (i.data as { nearest: number }).nearest])).toEqual(said);
});

test.each([
  [true, 22, 0.0990476],
  [false, 42, 0.0990476],
  [true, 21, 0.1],
  [false, 41, 0.1],
] as const)("the control's own 0.1 mm is not lowered: one way %s, %i passes", (oneWay, passes, planned) => {
  const issues: Issue[] = [];
  expect(offsetPerPass(0, passes, oneWay, 2.6, issues)).toBeCloseTo(planned, 6);
  expect(issues.map((i) => i.code)).toEqual(planned < 0.1 ? ["offsetOverLimit"] : []);
});

test("a single pass is not shortened", () => expect(offsetPerPass(0.3, 1, true, 2.6, [])).toBe(0));
