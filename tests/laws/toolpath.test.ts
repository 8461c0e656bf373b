import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf, difference, intersection, offset } from "../../src/kernel/clip.ts";
import { SAME } from "../../src/kernel/tolerance.ts";
import { situations, type Situation } from "./situation.ts";
import { planOf, simulated, startsBadly } from "./worked-plans.ts";

/**
 * What a toolpath has to achieve: a cycle that does nothing keeps the laws of cut.test.ts, one that cuts everything away
 * keeps these.
 */
/** Cases per law: with the stock cut by every move, and of the plan alone. */
const CUT = Number(process.env["LAW_CASES"] ?? 30);
const PLANNED = 6 * CUT;

const law = (arbitrary: fc.Arbitrary<Situation>, holds: (s: Situation) => void, runs: number) =>
  fc.assert(fc.property(arbitrary, holds), { numRuns: runs });

describe.each(situations(0))("cycle $cycle.number, roughing and finishing", ({ cycle, arbitrary }) => {
  test("leaves nothing that the tool could reach", () =>
    law(arbitrary, (s) => {
      const plan = planOf(cycle, s);
      if (plan.passes === 0 || s.values["Q479"] === 1 || startsBadly(plan)) return;
      const left = simulated([plan], s).proof.residual.filter((r) => r.reason === "oversize");
      expect(left.filter((r) => r.area > 0.05)).toEqual([]);
    }, CUT));
  test("infeeds are even, never more than Q463, and no fewer passes would do", () =>
    law(arbitrary, (s) => {
      const plan = planOf(cycle, s);
      const most = Math.min(s.values["Q463"] ?? 0, s.tool.CUTLENGTH || Infinity);
      expect(plan.infeed).toBeLessThanOrEqual(most + SAME);
      if (plan.passes > 1) expect((plan.passes * plan.infeed) / (plan.passes - 1)).toBeGreaterThan(most - SAME * most);
      const levels = new Set(plan.moves.flatMap((m) => (m.phase === "rough" && m.pass !== undefined ? [m.pass] : [])));
      expect([...levels].every((p) => p >= 1 && p <= plan.passes)).toBe(true);
    }, PLANNED));
  test("stays under a bound on moves, all of them finite, none needlessly past the axis, arcs on their circles", () =>
    law(arbitrary, (s) => {
      const plan = planOf(cycle, s);
      const elements = plan.contour.length + 4;
      expect(plan.moves.length).toBeLessThanOrEqual((plan.passes + 3) * (12 + 6 * elements));
      // Over the axis only as far as the contour goes, and by the nose that faces it clean.
      const lowest = Math.min(0, ...plan.contour.map((e) => e.to.r)) - s.tool.RS - SAME;
      let from = s.start;
      for (const m of plan.moves) {
        expect(Number.isFinite(m.to.z) && Number.isFinite(m.to.r)).toBe(true);
        expect(m.to.r).toBeGreaterThanOrEqual(lowest);
        if (m.kind === "rapid") expect(Math.abs(m.to.z - from.z) < SAME || Math.abs(m.to.r - from.r) < SAME).toBe(true);
        if (m.kind === "arc") {
          const [a, b] = [from, m.to].map((p) => Math.hypot(p.z - m.centre.z, p.r - m.centre.r)) as [number, number];
          expect(Math.abs(a - b)).toBeLessThan(SAME);
        }
        from = m.to;
      }
    }, PLANNED));
});

describe.each(situations(1))("cycle $cycle.number, roughing alone", ({ cycle, arbitrary }) => {
  test("keeps the oversize: nothing of the part grown by it is cut", () =>
    law(arbitrary, (s) => {
      const plan = planOf(cycle, s);
      if (plan.part.length === 0 || startsBadly(plan)) return;
      const cut = difference(s.blank, simulated([plan], s).final);
      const [dz, dr] = [s.values["Q484"] ?? 0, (s.values["Q483"] ?? 0) / 2];
      // A rectangle of oversize holds the part moved to each of its corners.
      for (const [z, r] of [[dz, 0], [-dz, 0], [0, dr], [0, -dr]] as const) {
        const moved = offset([plan.part.map((p) => ({ z: p.z + z, r: p.r + r }) as (typeof plan.part)[number])], -0.004);
        const inArea = intersection(intersection(cut, moved), offset([plan.area], -0.004));
        expect(areaOf(inArea)).toBeLessThan(0.02);
      }
    }, CUT));
});

describe("exact divisions", () => {
  test.each(situations(1))("cycle $cycle.number: k infeeds of exactly Q463 are k passes", ({ cycle, arbitrary }) =>
    law(arbitrary, (s) => {
      const plan = planOf(cycle, s);
      if (plan.passes === 0 || plan.passes > 200) return;
      const depth = plan.passes * plan.infeed;
      for (const k of [1, 2, 3, 7]) {
        if (depth / k < 0.3 || depth / k > (s.tool.CUTLENGTH ?? Infinity)) continue;
        const again = planOf(cycle, { ...s, values: { ...s.values, Q463: depth / k } });
        // A start point that had to be moved makes another depth.
        if (Math.abs(again.passes * again.infeed - depth) < SAME) expect(again.passes).toBe(k);
      }
    }, PLANNED));
});
