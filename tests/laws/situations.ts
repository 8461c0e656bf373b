import fc from "fast-check";
import type { Cycle, Given } from "../../src/cycles/define.ts";
import { catalogue } from "../../src/cycles/index.ts";
import { contourFrom, type ContourElement } from "../../src/kernel/contour.ts";
import type { Plan, Setting } from "../../src/kernel/plan.ts";
import type { Pt, Ring } from "../../src/kernel/point.ts";
import type { Step } from "../../src/kernel/step.ts";
import type { TipOrientation, Tool } from "../../src/kernel/tool.ts";
import { axial, radius } from "../../src/kernel/units.ts";
import { shippedTools } from "../../src/program/shipped-tools.ts";
import { simulate } from "../../src/sim/simulate.ts";

/** One random set-up of a cycle: values, contour, tool, start point and the blank that fits them. */
export interface Situation {
  readonly values: Record<string, number>;
  readonly given: Given;
  readonly tool: Tool;
  readonly start: Pt;
  readonly blank: readonly Ring[];
}

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, z1: number, r0: number, r1: number): Ring =>
  [at(Math.min(z0, z1), Math.min(r0, r1)), at(Math.max(z0, z1), Math.min(r0, r1)), at(Math.max(z0, z1), Math.max(r0, r1)), at(Math.min(z0, z1), Math.max(r0, r1))];

/** A length on the control's grid. */
const mm = (min: number, max: number) => fc.integer({ min: Math.round(min * 1000), max: Math.round(max * 1000) }).map((n) => n / 1000);
const deg = (max: number) => fc.integer({ min: 0, max: max * 1e4 }).map((n) => n / 1e4);
const tool = (t: number): Tool => shippedTools.find((x) => x.T === t) as Tool;
const turned = (t: Tool, TO: TipOrientation): Tool => ({ ...t, TO });
const sign = fc.constantFrom(1, -1);

const common = {
  Q460: mm(0.5, 4), Q478: fc.constant(0.3), Q483: mm(0, 1.5), Q484: mm(0, 0.7), Q505: fc.constant(0.1), Q463: mm(0.3, 5),
};
const elements = { Q501: fc.constantFrom(0, 1, 2), Q502: mm(0, 2), Q500: fc.oneof(fc.constant(0), mm(0, 3)), Q503: fc.constantFrom(0, 1, 2), Q504: mm(0, 2) };

const shoulder = fc.record({
  ...common, ...elements, Q495: fc.oneof(fc.constant(0), deg(20)), Q496: fc.oneof(fc.constant(0), deg(30)), Q506: fc.constantFrom(0, 1, 2),
  out: sign, along: sign, d1: mm(40, 100), height: mm(2, 30), z1: mm(-5, 5), length: mm(3, 70), t: fc.constantFrom(1, 2, 4, 11),
  before: mm(0, 8), over: mm(-2, 6), level: fc.boolean(),
}).map(({ out, along, d1, height, z1, length, t, before, over, level, ...q }): Situation => {
  const z2 = round(z1 - along * length);
  const base = tool(t);
  const side: TipOrientation = out > 0 ? (along > 0 ? 1 : 3) : along > 0 ? 7 : 5;
  const r1 = d1 / 2;
  return {
    values: { ...q, Q491: d1, Q492: z1, Q493: round(d1 - out * height), Q494: z2 },
    given: { contour: null, start: null },
    tool: turned(base, base.TYPE === "BUTTON" ? (out > 0 ? 2 : 6) : side),
    start: at(z1 + along * before, Math.max(0.5, level ? r1 : r1 + out * over)),
    blank: [box(z1, z2 - along * 30, r1, out > 0 ? 0 : r1 + 60)],
  };
});

const recess = fc.record({
  ...common, ...elements, Q495: fc.oneof(fc.constant(0), deg(10)), Q496: fc.oneof(fc.constant(0), deg(10)),
  Q507: fc.constantFrom(0, 1), Q508: fc.oneof(fc.constant(0), mm(0, 1)), Q509: fc.constant(0), Q488: fc.constantFrom(0, 0.05),
  out: sign, along: sign, d1: mm(40, 100), width: mm(3, 18), z1: mm(-20, 5), depth: mm(2, 28), before: mm(0, 6), across: mm(-5, 5),
  CUTWIDTH: fc.constantFrom(2, 3, 4), RS: fc.constantFrom(0, 0.2, 0.4),
}).map(({ out, along, d1, width, z1, depth, before, across, CUTWIDTH, RS, ...q }): Situation => ({
  values: { ...q, Q491: d1, Q492: z1, Q493: round(d1 - out * 2 * width), Q494: round(z1 - along * depth) },
  given: { contour: null, start: null },
  tool: { ...turned(tool(8), along > 0 ? 8 : 4), CUTWIDTH, RS } as Tool,
  start: at(z1 + along * before, Math.max(0.5, d1 / 2 + across)),
  blank: [box(z1, z1 - along * 60, 0, 110)],
}));

const stretch = fc.record({
  across: fc.oneof({ weight: 2, arbitrary: mm(0.5, 6) }, { weight: 1, arbitrary: fc.constant(0) }), along: mm(-6, 6),
  corner: fc.constantFrom("none", "round", "chamfer"), size: mm(0.2, 1.5),
});
const contour = fc.record({
  ...common, Q499: fc.constant(0), Q487: fc.constantFrom(0, 1), Q488: fc.constantFrom(0, 0.1), Q506: fc.constantFrom(0, 1, 2),
  Q479: fc.constantFrom(0, 0, 1), Q480: mm(4, 90), Q482: mm(-30, 5),
  out: sign, r: mm(26, 45), z: mm(-25, -5), stretches: fc.array(stretch, { minLength: 2, maxLength: 6 }), t: fc.constantFrom(15, 1, 2, 11),
  before: fc.oneof(fc.constant(0), mm(0, 3)), over: mm(0, 3),
}).map(({ out, r, z, stretches, t, before, over, ...q }): Situation => {
  const first = out > 0 ? r : r - 18;
  const points: ContourElement[] = [{ kind: "line", to: at(z, first) }];
  let here = at(z, first);
  stretches.forEach((s, i) => {
    const rise = s.across === 0 ? Math.abs(s.along) + 0.5 : s.along;
    here = at(round(here.z + rise), Math.max(0.5, round(here.r - out * s.across)));
    points.push({ kind: "line", to: here });
    if (s.corner !== "none" && i + 1 < stretches.length) points.push({ kind: s.corner as "round" | "chamfer", size: s.size });
  });
  const built = contourFrom(points).segments;
  const top = Math.max(...built.flatMap((s) => [s.from.z, s.to.z]), z);
  const base = tool(t);
  return {
    values: q, given: { contour: built, start: null }, tool: turned(base, base.TYPE === "BUTTON" ? 8 : out > 0 ? 1 : 7),
    start: at(top + over, Math.max(0.5, first + out * before)), blank: [box(top, -90, first, out > 0 ? 0 : first + 80)],
  };
});

const round = (n: number) => Math.round(n * 1000) / 1000;

/** Random situations by the group of a cycle: a new cycle of a known group is tested before anyone writes a test for it. */
const byGroup: Record<Cycle["group"], fc.Arbitrary<Situation>> = { shoulder, recessTurning: recess, contour };

/** The cycles of the catalogue, each with its random situations for one machining operation (Q215). */
export const situations = (operation: number): { cycle: Cycle; arbitrary: fc.Arbitrary<Situation> }[] =>
  catalogue.map((cycle) => ({
    cycle, arbitrary: byGroup[cycle.group].map((s) => ({ ...s, values: { ...s.values, Q215: operation } })),
  }));

/** Plans a situation; the feed of the tool call is 0.25 mm/rev. */
export function planOf(cycle: Cycle, s: Situation): Plan {
  const setting: Setting = { tool: s.tool, start: s.start, feedUnit: "mm/rev", autoFeed: null, stock: s.blank };
  return cycle.plan(s.values as never, setting, s.given);
}

/** Simulates a plan in the blank of its situation. */
export function simulated(plan: Plan, s: Situation) {
  let from = s.start;
  const used = plan.tool ?? s.tool;
  const steps = plan.moves.map((move): Step => {
    const step: Step = { from, move, tool: used, block: 1, operation: 0, seconds: 1 };
    from = move.to;
    return step;
  });
  return simulate({ blank: s.blank, steps, operations: [{ plan, tool: used, firstStep: 0, lastStep: steps.length - 1 }], unproved: [] });
}

/** The plan says that it moves through the material because the start point stands there, or that it may. */
export const startsBadly = (plan: Plan) =>
  plan.issues.some((i) => ["startInArea", "startInMaterial", "startInsideEnvelope", "startBelowContour"].includes(i.code));
