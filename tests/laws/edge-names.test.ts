import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../src/cycles/index.ts";
import { angleIssues } from "../../src/cycles/tool-issues.ts";
import { toFlat, toPart, type Frame } from "../../src/kernel/geometry/flat.ts";
import { tipDirection } from "../../src/kernel/cutter/insert.ts";
import { never } from "../../src/kernel/never.ts";
import { at, type Segment } from "../../src/kernel/geometry/point.ts";
import type { TipOrientation, Tool } from "../../src/kernel/plan/tool.ts";
import { degrees, length } from "../../src/kernel/units.ts";
import type { Situation } from "./situation.ts";
import { planOf, simulated } from "./worked-plans.ts";

/*
 * For any orientation of an insert and any neck, the warning about an element that cannot be followed and the reason of
 * the residual material there name the same edge, even at the end of an edge that is too short for the neck.
 */
const CASES = Number(process.env["LAW_CASES"] ?? 8);
const EVERY: readonly TipOrientation[] = [1, 2, 3, 4, 5, 6, 7, 8, 9];
const FRAMES = ([false, true] as const).flatMap((transverse) =>
  ([-1, 1] as const).flatMap((signU) => ([1, -1] as const).map((signV): Frame => ({ transverse, signU, signV }))),
);

/**
 * Orientations that are above the material and cut in this direction, and for which a contour behind the tool counts as
 * such.
 */
const fitting = (f: Frame) =>
  EVERY.filter((TO) => {
    const [tip, d] = [tipDirection(TO), toFlat(f, at(tipDirection(TO).u, tipDirection(TO).v))];
    return TO !== 9 && d.u >= 0 && d.v <= 0 && (!f.transverse || f.signV > 0 || tip.u > 0);
  });

const tenths = (min: number, max: number) => fc.integer({ min: min * 10, max: max * 10 }).map((n) => n / 10);

/** A neck with a flank on either side, in a cylinder, a bore or a face. */
const necks = fc.record({
  rim: tenths(3, 7),
  depth: tenths(1.5, 6),
  floor: tenths(1, 16),
  falling: tenths(8, 86),
  rising: tenths(8, 89),
  tAngle: tenths(80, 130),
  pAngle: tenths(30, 85),
  edge: tenths(3, 14),
  nose: fc.constantFrom(0, 0.2, 0.4, 0.8),
  oversize: fc.constantFrom(0, 0, 0.3),
});
type Neck = typeof necks extends fc.Arbitrary<infer N> ? N : never;

/** A neck under a blunt insert: no nose reaches it, and it is narrower than a corner that a nose may leave. */
const FOUND: [Neck][] = [
  [
    {
      rim: 6.3,
      depth: 1.5,
      floor: 1.3,
      falling: 60.1,
      rising: 82.6,
      tAngle: 89.3,
      pAngle: 82,
      edge: 10.2,
      nose: 0.8,
      oversize: 0,
    },
  ],
];

/** The lowest height of the rim in strategy space, and its start: always clear of the axis. */
const RIM = { cylinder: 30, bore: -24, front: 0 } as const;
const BEGINS = { inwards: -48, outwards: 12, along: 0 } as const;

function neckIn(frame: Frame, TO: TipOrientation, n: Neck): Situation & { readonly contour: readonly Segment[] } {
  const top = frame.transverse ? RIM.front : frame.signV > 0 ? RIM.cylinder : RIM.bore;
  const from = !frame.transverse ? BEGINS.along : frame.signU < 0 ? BEGINS.inwards : BEGINS.outwards;
  const leaning = (angle: number) => Math.min(7, n.depth / Math.tan((angle * Math.PI) / 180));
  const us = [0, n.rim, leaning(n.falling), n.floor * (frame.transverse ? 0.6 : 1), leaning(n.rising), 4];
  const vs = [top, top, top - n.depth, top - n.depth, top, top];
  const points = us.map((_, i) => ({
    u: from + us.slice(0, i + 1).reduce((sum, u) => sum + u, 0),
    v: vs[i] as number,
  }));
  const end = (points.at(-1)?.u ?? 0) + 0.001;
  const contour = points.slice(1).map((to, i): Segment => ({
    kind: "line",
    from: toPart(frame, points[i] as never),
    to: toPart(frame, to),
  }));
  const start = toPart(frame, { u: from - 2, v: top + 3 });
  const deep = top - n.depth - 5;
  const blank = [
    [from, deep],
    [end, deep],
    [end, top],
    [from, top],
  ].map(([u, v]) => toPart(frame, { u: u as number, v: v as number }));
  const tool: Tool = {
    T: 1,
    NAME: "DRAWN",
    TYPE: "ROUGH",
    TO,
    RS: length(n.nose),
    "T-ANGLE": degrees(n.tAngle),
    "P-ANGLE": degrees(Math.min(n.pAngle, 175 - n.tAngle)),
    CUTLENGTH: length(n.edge),
  };
  return {
    values: {
      Q215: 0,
      Q460: 2,
      Q499: 0,
      Q463: 1.7,
      Q478: 0.3,
      Q483: n.oversize,
      Q484: n.oversize / 2,
      Q505: 0.2,
      Q487: 1,
      Q488: 0,
      Q479: 0,
      Q480: 0,
      Q482: 0,
      Q506: 0,
    },
    given: { contour, start },
    tool,
    start,
    blank: [blank],
    contour,
  };
}

/** Smaller regions are in a corner and may be attributed to the nose, mm². */
const CLEAR = 0.4;
const EDGES: readonly string[] = ["mainEdge", "secondaryEdge"];

describe.each(FRAMES.flatMap((frame) => fitting(frame).map((TO) => ({ frame, TO, ...frame }))))(
  "transverse $transverse, along $signU, out $signV, orientation $TO",
  ({ frame, TO }) => {
    test("residue in a neck is attributed to the edges that cannot follow its flanks", () => {
      const cycle = cycleByNumber(frame.transverse ? 820 : 810) ?? never("no such cycle", frame);
      fc.assert(
        fc.property(necks, (n) => {
          const s = neckIn(frame, TO, n);
          const plan = planOf(cycle, s);
          if (plan.issues.some((i) => i.severity === "error")) return;
          const { proof } = simulated([plan], s);
          const stays = proof.residual.filter((r) => r.area > CLEAR).map((r) => r.reason);
          const named = new Set<string>(
            s.contour.flatMap((element) =>
              angleIssues({ contour: [element] }, s.tool, frame, (_q, direction) => direction).map((i) =>
                i.code === "angleNotFollowed" ? i.data.edge : "",
              ),
            ),
          );
          for (const reason of stays) if (EDGES.includes(reason)) expect([...named]).toContain(reason);
          const warning = plan.issues.find((i) => i.code === "angleNotFollowed");
          expect(warning === undefined).toBe(named.size === 0);
          if (warning && named.size === 1 && stays.length > 0) expect(stays).toContain(warning.data.edge);
        }),
        { numRuns: CASES, examples: FOUND },
      );
    });
  },
);

/* Under a wall that leans over the cut, a bar of any width leaves as much; in a narrow groove, its width is the cause. */
test.each([
  { width: 1, foot: -31.4, rim: -27.3, warned: ["behindContour"], reason: "behindContour" },
  { width: 3, foot: -31.4, rim: -27.3, warned: ["behindContour"], reason: "behindContour" },
  { width: 3, foot: -16.6, rim: -18.1, warned: [], reason: "toolWidth" },
])(
  "a bar of $width before a wall from $foot to $rim leaves material: $reason",
  ({ width, foot, rim, warned, reason }) => {
    const points = [at(-14.2, 37.5), at(-15.1, 29.3), at(foot, 29.3), at(rim, 37.5)];
    const contour = points.slice(1).map((to, i): Segment => ({ kind: "line", from: points[i] as never, to }));
    const start = at(-14.2, 40);
    const tool: Tool = {
      T: 1,
      NAME: "BAR",
      TYPE: "RECTURN",
      TO: 2,
      RS: length(0.2),
      CUTWIDTH: length(width),
      CUTLENGTH: length(20),
    };
    const values = {
      Q215: 0,
      Q460: 2,
      Q478: 0.3,
      Q488: 0,
      Q483: 0,
      Q484: 0,
      Q505: 0.2,
      Q479: 0,
      Q480: 0,
      Q482: 0,
      Q463: 2,
      Q507: 0,
      Q508: 0,
      Q509: 0,
      Q499: 0,
    };
    const blank = [[at(-50, 10), at(0, 10), at(0, 37.5), at(-50, 37.5)]];
    const s: Situation = { values, given: { contour, start }, tool, start, blank };
    const plan = planOf(cycleByNumber(840) ?? never("no such cycle", 840), s);
    expect(plan.issues.flatMap((i) => (i.code === "angleNotFollowed" ? [i.data.edge] : []))).toEqual(warned);
    const stays = simulated([plan], s).proof.residual.filter((r) => r.area > CLEAR);
    expect(new Set(stays.map((r) => r.reason))).toEqual(new Set([reason]));
  },
);
