import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { brokenByPlan } from "./plan-laws.ts";
import { casesOf, situations } from "./situation.ts";

/* Every drawn set-up is planned and checked against the laws of plan-laws.ts. Planning is fast, so there are many. */
const CASES = 4 * Number(process.env["LAW_CASES"] ?? 6);

for (const operation of [0, 1, 2, 3])
  describe.each(situations(operation))(`cycle $cycle.number, Q215 = ${operation}`, ({ cycle, arbitrary }) => {
    test("has a path that is bounded, even and mirrored from the other side", () => {
      fc.assert(
        fc.property(arbitrary, (s) => {
          expect(brokenByPlan(cycle, s)).toEqual([]);
        }),
        { numRuns: casesOf(cycle, CASES) },
      );
    });
  });
