import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { Cycle } from "../../src/cycles/define.ts";
import type { Ring } from "../../src/kernel/geometry/point.ts";
import { areaOutside } from "../../src/kernel/area/real-area.ts";
import { casesOf, situations, type Situation } from "./situation.ts";
import { simulated, isStartInMaterial } from "./worked-plans.ts";

/*
 * A traced blank: roughing without air cuts cuts the same stock as full roughing, in the blank and in the stock of an
 * earlier call, and its rapids stay free.
 */
const CASES = Number(process.env["LAW_CASES"] ?? 5);

function roughed(cycle: Cycle, s: Situation, blank: readonly Ring[], skipsAirPasses: boolean) {
  const setting = {
    tool: s.tool,
    start: s.start,
    feedUnit: "mm/rev" as const,
    autoFeed: null,
    stock: blank,
    skipsAirPasses,
  };
  const plan = cycle.plan(s.values as never, setting, s.given);
  return { plan, simulation: simulated([plan], { ...s, blank }) };
}
const same = (a: readonly Ring[], b: readonly Ring[]) => areaOutside(a, b) + areaOutside(b, a);

/**
 * Roughs a blank with and without air cuts and returns both stocks; null where there is nothing to compare: full
 * roughing is refused where an insert reaches across the axis in air cuts only.
 */
function bothWays(cycle: Cycle, s: Situation, blank: readonly Ring[]): readonly Ring[] | null {
  const [full, short] = [roughed(cycle, s, blank, false), roughed(cycle, s, blank, true)];
  if (full.plan.issues.some((i) => i.code === "insertAcrossAxis")) return null;
  expect(short.simulation.proof.gouge).toBe(0);
  // Called from a height inside the material, full roughing returns through the material at rapid, which is no valid
  // cut.
  if (full.simulation.proof.rapidInStock > 0) return null;
  expect(same(full.simulation.final, short.simulation.final)).toBeLessThan(0.05);
  if (!isStartInMaterial(full.plan)) expect(short.simulation.proof.rapidInStock).toBe(0);
  expect(short.plan.passes).toBeLessThanOrEqual(full.plan.passes);
  const counted = new Set(short.plan.moves.flatMap((m) => m.pass ?? []));
  expect([...counted].sort((a, b) => a - b)).toEqual(Array.from({ length: counted.size }, (_, i) => i + 1));
  return full.simulation.final;
}

/** Groups that rough by levels. */
const LEVELLED: readonly string[] = ["longitudinal", "transverse"];

describe.each(situations(1).filter(({ cycle }) => LEVELLED.includes(cycle.group)))(
  "cycle $cycle.number",
  ({ cycle, arbitrary }) => {
    test("cuts the same without air cuts, and again in the remaining stock", () => {
      fc.assert(
        fc.property(arbitrary, (s) => {
          const left = bothWays(cycle, s, s.blank);
          if (left) bothWays(cycle, s, left);
        }),
        { numRuns: casesOf(cycle, CASES) },
      );
    });
  },
);
