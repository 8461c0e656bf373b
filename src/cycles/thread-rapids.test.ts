import { describe, expect, test } from "vitest";
import { at, type Pt, type Ring } from "../kernel/geometry/point.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { length } from "../kernel/units.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { c831 } from "./c831.ts";

const box = (z0: number, z1: number, r0: number, r1: number): Ring => [at(z0, r0), at(z0, r1), at(z1, r1), at(z1, r0)];

interface Given {
  readonly values?: Readonly<Record<string, number>>;
  readonly stock: readonly Ring[];
  readonly start: Pt;
  readonly isInside?: boolean;
  /** Height of the tooth, mm. */
  readonly tooth?: number;
}

/** A thread from Z0 to Z−30 in passes along the flank; outside on a shaft of 40 mm. */
function planOf({ values = {}, stock, start, isInside = false, tooth = 2.5 }: Given): Plan {
  const example = Object.fromEntries(Object.entries(c831.params).map(([q, p]) => [q, p.example]));
  const own = { Q471: isInside ? 1 : 0, Q475: 1, Q476: 0, Q460: 8, Q491: 40, Q492: 0, Q494: -30, Q467: 29, Q473: 1.2 };
  const shipped = shippedTools.find(({ T }) => T === (isInside ? 13 : 12)) as Tool;
  return c831.plan(
    { ...example, ...own, Q463: 0.3, ...values } as never,
    { tool: { ...shipped, CUTLENGTH: length(tooth) }, start, feedUnit: "mm/rev", autoFeed: null, stock },
    { contour: null, start },
  );
}

/** Rapids along the axis: from, to, and their radius. */
function alongAxis({ moves }: Plan, start: Pt): readonly (readonly [number, number, number])[] {
  let from = start;
  return moves.flatMap((m) => {
    const before = from;
    from = m.to;
    return m.kind === "rapid" && m.to.z !== before.z ? [[before.z, m.to.z, Number(m.to.r)] as const] : [];
  });
}

const shaft = box(0, -100, 0, 20);

describe("rapids beside a thread", () => {
  test.each<[string, readonly Ring[], Pt]>([
    ["over a shaft as high as its crest", [shaft], at(20, 30)],
    ["over a shaft that stands over its crest", [box(0, -100, 0, 20.9)], at(20, 30)],
    ["over a collar in front of the run-in", [shaft, box(16, 12, 0, 27)], at(25, 22)],
    ["over a shoulder behind the overrun", [shaft, box(-44, -50, 0, 31)], at(-60, 22)],
  ])("keep the set-up clearance %s", (_, stock, start) => {
    const plan = planOf({ stock, start });
    expect(plan.issues.filter((i) => i.severity === "error")).toEqual([]);
    const rapids = alongAxis(plan, start);
    expect(rapids.length).toBeGreaterThan(plan.passes);
    const highest = (a: number, b: number) =>
      Math.max(
        0,
        ...stock.flat().flatMap(({ z, r }) => (z >= Math.min(a, b) - 1e-9 && z <= Math.max(a, b) + 1e-9 ? [r] : [])),
        // The shaft has no corner in the middle of the thread.
        ...(Math.min(a, b) < -30 && stock[0] ? [Number(stock[0][1]?.r)] : []),
      );
    for (const [a, b, r] of rapids) expect([a, b, r >= highest(a, b) + 8 - 1e-6]).toEqual([a, b, true]);
    // And no more than is needed for the highest of them.
    const tops = [30, ...rapids.map(([a, b]) => highest(a, b) + 8)];
    expect(Math.max(...rapids.map(([, , r]) => r))).toBeLessThan(Math.max(...tops, Number(start.r)) + 0.01);
  });

  test.each([
    ["in a bore that is wider than the clearance", 15, 2.5, 7],
    // Half the bore, then what the tooth leaves.
    ["in a narrow bore stay on their side of the axis", 5, 2.5, 0],
    ["and the back of a high tooth does not touch the other side", 3, 4.2, 1.2],
  ])("%s", (_, crest, tooth, r) => {
    const stock = [box(0, -100, crest, 30)];
    const start = at(20, Math.max(r, 2));
    const plan = planOf({ stock, start, isInside: true, tooth, values: { Q491: 2 * (crest + 1.2) } });
    expect(plan.issues.filter((i) => i.severity === "error")).toEqual([]);
    expect(Math.min(...alongAxis(plan, start).map(([, , each]) => each))).toBeCloseTo(r, 6);
  });

  test("every pass has to begin in the air, not only the deepest: the tooth of a higher one meets a high wall", () => {
    const codes = (wall: number) =>
      planOf({ stock: [shaft, box(wall + 3, wall, 0, 45)], start: at(9, 50) })
        .issues.filter((i) => i.severity === "error")
        .map((i) => i.code);
    // Half a tooth of 2.5 mm is 1.443 mm wide; the first of the passes is set back by 0.9 mm · tan 29°.
    expect(codes(8 + 1.4)).toEqual(["runInBlocked"]);
    expect(codes(8 + 1.6)).toEqual(["runInBlocked"]);
    expect(codes(8 + 2.1)).toEqual([]);
  });
});
