import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../src/cycles/index.ts";
import { brokenBy } from "./cut-laws.ts";
import type { FoundCase } from "./found-case.ts";
import { brokenByPlan } from "./plan-laws.ts";
import { casesOf, situations, type Situation } from "./situation.ts";

/*
 * Every drawn set-up is cut twice and checked against the laws of cut-laws.ts, from any start point. `npm run laws`
 * draws many more; the cases that it finds are in found/ and are always tried here.
 */
const CASES = Number(process.env["LAW_CASES"] ?? 6);
/** Finishing alone cuts the roughing of the same set-up first, which is a case of its own. */
const casesFor = (operation: number) => (operation < 2 ? CASES : Math.ceil(CASES / 2));

for (const operation of [0, 1, 2, 3])
  describe.each(situations(operation))(`cycle $cycle.number, Q215 = ${operation}`, ({ cycle, arbitrary }) => {
    test("keeps the part whole and its rapids free, and both simulations agree", () => {
      fc.assert(
        fc.property(arbitrary, (s) => {
          expect(brokenBy(cycle, s)).toEqual([]);
        }),
        { numRuns: casesOf(cycle, casesFor(operation)) },
      );
    });
  });

/** Number of set-ups drawn to find some on the axis, and number of those tried. */
const [DRAWN, ON_AXIS] = [60 + CASES, Math.ceil(CASES / 4)];

describe("on the axis and beyond it", () => {
  const turning = situations(0).filter(({ cycle: { group } }) => group === "longitudinal" || group === "transverse");
  test.each(turning)("cycle $cycle.number leaves no pip and cuts into nothing", ({ cycle, arbitrary }) => {
    const isThere = (s: Situation) =>
      cycle.outline(s.values as never, s.given).contour.some(({ from, to }) => Math.min(from.r, to.r) <= 0);
    for (const s of fc.sample(arbitrary, DRAWN).filter(isThere).slice(0, ON_AXIS))
      expect(brokenBy(cycle, s), JSON.stringify(s)).toEqual([]);
  });
});

describe("set-ups that broke a law once", () => {
  const found = Object.entries(import.meta.glob<FoundCase>("./found/*.json", { import: "default", eager: true }));
  for (const [path, { cycle, situation }] of found)
    test(path, () => {
      const known = cycleByNumber(cycle);
      expect(known && [...brokenByPlan(known, situation), ...brokenBy(known, situation)]).toEqual([]);
    });
  test("are in a folder of their own", () => expect(found.every(([path]) => path.startsWith("./found"))).toBe(true));
});
