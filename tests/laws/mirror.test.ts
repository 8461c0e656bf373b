import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { Move } from "../../src/kernel/move.ts";
import { at, type Pt, type Ring } from "../../src/kernel/point.ts";
import type { TipOrientation } from "../../src/kernel/tool.ts";
import { situations, type Situation } from "./situation.ts";
import { planOf } from "./worked-plans.ts";

/* A set-up turned round in Z, tool and all, is the same work seen from the other side. */
const CASES = 4 * Number(process.env["LAW_CASES"] ?? 25);
const OTHER: Record<TipOrientation, TipOrientation> = { 1: 3, 2: 2, 3: 1, 4: 8, 5: 7, 6: 6, 7: 5, 8: 4, 9: 9 };

const point = (p: Pt): Pt => at(-p.z, p.r);
const ring = (r: Ring): Ring => r.map(point).reverse();
const mirrored = (s: Situation): Situation => ({
  ...s,
  values: { ...s.values, Q492: -(s.values["Q492"] ?? 0), Q494: -(s.values["Q494"] ?? 0) },
  tool: { ...s.tool, TO: OTHER[s.tool.TO] },
  start: point(s.start),
  blank: s.blank.map(ring),
});
/** What a move does, to the tenth of a micron. */
const told = (m: Move, to: (p: Pt) => Pt) => {
  const places = m.kind === "arc" ? [m.to, m.centre] : [m.to];
  return [m.kind, m.phase, m.pass, m.run, m.step, ...places.map(to).flatMap((p) => [p.z, p.r].map((n) => Math.round(n * 1e4) / 1e4 + 0))];
};

// A free contour across the axis is open towards +Z whatever the tool (decision 0010), so only the cycles with their own
// contour turn round.
describe.each(situations(0).filter((s) => s.cycle.contour === "own"))("cycle $cycle.number", ({ cycle, arbitrary }) => {
  test("turned round in Z it runs the same path, turned round", () => {
    fc.assert(fc.property(arbitrary, (s) => {
      // An insert that points straight at the axis leans to one side all the same: there is no other tool that is its mirror image.
      if (s.tool["T-ANGLE"] !== undefined && [2, 6].includes(s.tool.TO)) return;
      const [one, other] = [planOf(cycle, s), planOf(cycle, mirrored(s))];
      expect(other.moves.map((m) => told(m, point))).toEqual(one.moves.map((m) => told(m, (p) => p)));
      expect(other.issues.map((i) => i.code)).toEqual(one.issues.map((i) => i.code));
    }), { numRuns: CASES });
  });
});
