import { describe, expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import type { Move, Phase } from "../kernel/plan/move.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { TipOrientation, Tool } from "../kernel/plan/tool.ts";
import { axial, degrees, feed, length, radius } from "../kernel/units.ts";
import { stockIssues } from "./issues.ts";
import { producedParts } from "./produced-parts.ts";
import { simulate } from "./simulate.ts";
import { playerOf } from "./stock.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const rapid = (z: number, r: number): Move => ({
  kind: "rapid",
  to: at(z, r),
  phase: "position",
  run: "rough",
  step: 1,
});
const cut = (z: number, r: number, phase: Phase = "rough", pass?: number): Move => ({
  kind: "feed",
  to: at(z, r),
  feed: feed(0.3),
  feedUnit: "mm/rev",
  phase,
  run: "rough",
  step: 1,
  ...(pass !== undefined && { pass }),
});
const rougher: Tool = {
  T: 1,
  NAME: "CNMG",
  TYPE: "ROUGH",
  TO: 1,
  RS: length(0.8),
  "T-ANGLE": degrees(95),
  "P-ANGLE": degrees(80),
  CUTLENGTH: length(12),
};
const bar: Tool = {
  T: 9,
  NAME: "BAR-3",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0.2),
  CUTWIDTH: length(3),
  CUTLENGTH: length(30),
};
const blank = [box(-50, 0, 0, 30)];

const empty: Plan = {
  moves: [],
  issues: [],
  contour: [],
  passes: 1,
  infeed: length(2),
  area: [],
  part: [],
  openSide: at(0, 1),
  reach: [],
  oversizeReach: [],
  maxInfeed: length(2),
  oversize: { r: 0.2, z: 0.1 },
};
function run(tool: Tool, start: Pt, moves: readonly Move[], plan: Partial<Plan> = {}) {
  let from = start;
  const steps = moves.map((move, i): Step => {
    const step: Step = { from, move, tool, block: 10 + i, operation: 0, seconds: 1 };
    from = move.to;
    return step;
  });
  const operation = { plan: { ...empty, moves, ...plan }, tool, firstStep: 0, lastStep: steps.length - 1 };
  return simulate({ blank, steps, operations: [operation], unproved: [] });
}
const codes = (s: ReturnType<typeof run>) => stockIssues(s).map((i) => i.issue.code);

describe("the real depth of a roughing pass", () => {
  test("is the stock above it, not the cycle's nominal infeed", () => {
    const s = run(rougher, at(2, 25.3), [
      cut(-30, 25.3, "rough", 1),
      cut(-30, 31, "rough", 1),
      rapid(2, 31),
      rapid(2, 23.4),
      cut(-30, 23.4, "rough", 2),
    ]);
    expect(s.proof.deepest).toMatchObject({ allowed: 2, pass: 1, step: 0, block: 10 });
    expect(s.proof.deepest?.depth).toBeCloseTo(4.7, 2);
    const told = stockIssues(s).find((i) => i.issue.code === "deeperThanInfeed");
    expect(told).toMatchObject({
      operation: 0,
      block: 10,
      issue: { severity: "warning", data: { allowed: 2, pass: 1 } },
    });
  });
  test("a hair more than allowed is not reported, nor any depth without a limit", () => {
    expect(codes(run(rougher, at(2, 27.96), [cut(-30, 27.96, "rough", 1)]))).not.toContain("deeperThanInfeed");
    expect(codes(run(rougher, at(2, 27.9), [cut(-30, 27.9, "rough", 1)]))).toContain("deeperThanInfeed");
    expect(codes(run(rougher, at(2, 20), [cut(-30, 20, "rough", 1)], { maxInfeed: length(0) }))).not.toContain(
      "deeperThanInfeed",
    );
  });
  test("is measured along the axis in a transverse cycle", () => {
    const s = run(bar, at(-1.5, 32), [cut(-1.5, 10, "rough", 1)], { openSide: at(1, 0), maxInfeed: length(2.5) });
    expect(s.proof.deepest?.depth).toBeCloseTo(3, 2);
    expect(codes(s)).toContain("deeperThanInfeed");
  });
  test("of contour-parallel passes is square to the contour; a sixth more in a right angle is no fault", () => {
    const bend = [cut(-20, 27, "rough", 1), cut(-20, 33, "rough", 1)];
    const along = (allowed: number) => run(bar, at(2, 27), bend, { isParallel: true, maxInfeed: length(allowed) });
    expect(along(3).proof.deepest).toBeNull();
    expect(along(2.4).proof.deepest).toMatchObject({ allowed: 2.4, pass: 1 });
    expect(codes(along(2.4))).toContain("deeperThanInfeed");
    // Up a face, the infeed direction measures the whole face.
    const face = (isParallel: boolean) =>
      run(bar, at(-2, 10), [cut(-2, 31, "rough", 1)], { isParallel, maxInfeed: length(3) });
    expect(codes(face(true))).not.toContain("deeperThanInfeed");
    expect(codes(face(false))).toContain("deeperThanInfeed");
  });
  test("a plunge is measured in its own direction", () => {
    expect(run(bar, at(-20, 31), [cut(-20, 27.4, "rough", 1)]).proof.deepest?.depth).toBeCloseTo(2.6, 2);
  });
});

describe("smoothing and finishing", () => {
  test("may cut the oversize plus one infeed, square to the path", () => {
    expect(codes(run(rougher, at(2, 27.85), [cut(-30, 27.85, "finish")]))).not.toContain("deeperThanInfeed");
    const s = run(rougher, at(2, 27.1), [cut(-30, 27.1, "finish")]);
    expect(s.proof.operations[0]?.thickest).toMatchObject({ allowed: 2.2, step: 0 });
    expect(s.proof.operations[0]?.thickest?.depth).toBeCloseTo(2.9, 1);
    expect(s.proof.deepest).toBeNull();
  });
  test("a cut down a face is as thick as the layer it removes", () => {
    const face = [cut(-0.4, 32, "finish"), cut(-0.4, 2, "finish")];
    expect(codes(run(bar, at(1, 32), face))).not.toContain("deeperThanInfeed");
  });
});

test("passes in the air are counted once, however many moves they have; a pass of two cuts is one pass", () => {
  const s = run(rougher, at(2, 33), [
    cut(-30, 33, "rough", 1),
    cut(-30, 34, "rough", 1),
    rapid(2, 34),
    rapid(2, 31),
    cut(-10, 31, "rough", 2),
    rapid(-10, 34),
    rapid(-20, 34),
    cut(-20, 29, "rough", 2),
    rapid(-20, 34),
    rapid(2, 34),
    rapid(2, 32),
    cut(-30, 32, "rough", 3),
  ]);
  expect(s.proof.airPasses).toBe(2);
  expect(stockIssues(s)).toContainEqual(
    expect.objectContaining({ issue: { code: "airPasses", severity: "info", data: { count: 2 } } }),
  );
});

test("the cut area is that of feed moves, without rapids and repeated paths", () => {
  const s = run(bar, at(-20, 32), [
    cut(-20, 25, "rough", 1),
    cut(-20, 32, "rough", 1),
    cut(-20, 25, "rough", 2),
    cut(-20, 32),
    rapid(-30, 32),
    rapid(-30, 27),
  ]);
  const corners = 2 * (1 - Math.PI / 4) * 0.04;
  expect(s.proof.cut).toBeCloseTo(15 - corners, 2);
  expect(s.proof.operations[0]?.cut).toBeCloseTo(15 - corners, 2);
  expect(s.proof.rapidInStock).toBeCloseTo(9 - corners, 1);
  expect(s.proof.airPasses).toBe(1);
});

test("an operation that cut nothing says so, unless an error kept it from cutting", () => {
  expect(codes(run(rougher, at(2, 40), [cut(-30, 40, "rough", 1)]))).toContain("nothingCut");
  expect(codes(run(rougher, at(2, 40), [cut(-30, 40, "rough", 1)]))).not.toContain("airPasses");
});

test("a start point in the stock is reported, one that touches it is not", () => {
  expect(codes(run(rougher, at(-20, 29), [cut(-20, 35)]))).toContain("startInMaterial");
  expect(codes(run(rougher, at(-20, 30), [cut(-20, 35)]))).not.toContain("startInMaterial");
  expect(codes(run(bar, at(-20, -29), [cut(-20, -35)]))).toContain("startInMaterial");
  // Clear of the work on this side, inside it on the other: the bar reaches from −33 to −3.
  expect(codes(run(bar, at(-20, -33), [cut(-20, -40)]))).toContain("startInMaterial");
});

describe("material behind a machining limit", () => {
  const plane = { at: "Q482", axis: "z", value: -21.3, behind: -1 } as const;
  const cylinder = { at: "Q480", axis: "r", value: 26.4, behind: 1 } as const;
  const behind = (s: ReturnType<typeof run>) => s.proof.operations[0]?.behindLimits ?? [];
  const along = (to: number, phase: Phase, then: "rough" | "finish" = "rough"): Move[] => [
    { ...rapid(2, 27.7), run: then },
    { ...cut(to, 27.7, phase, 1), run: then },
    { ...rapid(to, 33), run: then },
    {
      ...rapid(2, 33),
      run: then,
    },
  ];
  test("is reported at its limit, with the place and the move", () => {
    const s = run(rougher, at(2, 33), [...along(-11.2, "rough"), ...along(-24.8, "rough")], { limits: [plane] });
    const [b] = behind(s);
    // Less the residue of nose and main edge in the corner.
    expect(b?.area).toBeGreaterThan(3.5 * 2.3 - 0.3);
    expect(b?.area).toBeLessThan(3.5 * 2.3 - 0.2);
    expect(b).toMatchObject({ step: 5, block: 15, finishing: false, limit: { at: "Q482" } });
    expect(b?.place.z).toBeLessThan(-21.3);
    expect(stockIssues(s)).toContainEqual(
      expect.objectContaining({
        block: 15,
        issue: expect.objectContaining({ code: "cutBehindLimit", severity: "warning", at: "Q482" }) as unknown,
      }),
    );
  });
  test("is not reported where the cut ends at the limit, or where there was no stock", () => {
    expect(behind(run(rougher, at(2, 33), along(-21.3, "rough"), { limits: [plane] }))).toEqual([]);
    expect(behind(run(rougher, at(2, 33), along(-24.8, "rough")))).toEqual([]);
    expect(
      behind(run(rougher, at(2, 33), [rapid(2, 30.1), cut(-24.8, 30.1, "rough", 1)], { limits: [plane, cylinder] })),
    ).toEqual([]);
  });
  test("is not reported up to a tenth of a millimetre, whatever its length", () => {
    const to = (z: number) => behind(run(rougher, at(2, 33), along(z, "rough"), { limits: [plane] }));
    expect(to(-21.393)).toEqual([]);
    expect(to(-21.407)).toMatchObject([{ limit: { at: "Q482" } }]);
    const cylinderAt = (value: number) =>
      behind(
        run(rougher, at(2, 33), along(-24.8, "rough"), { limits: [{ at: "Q480", axis: "r", value, behind: -1 }] }),
      );
    expect(cylinderAt(27.78)).toEqual([]);
    expect(cylinderAt(27.82)[0]?.area).toBeGreaterThan(24 * 0.1);
  });
  test("is reported for every crossed limit, and whether roughing alone would leave it", () => {
    const both = run(rougher, at(2, 33), along(-24.8, "rough"), { limits: [plane, cylinder] });
    expect(behind(both).map((b) => [b.limit.at, b.finishing])).toEqual([
      ["Q482", false],
      ["Q480", false],
    ]);
    const finished = run(rougher, at(2, 33), [...along(-11.2, "rough"), ...along(-24.8, "finish", "finish")], {
      limits: [plane],
    });
    expect(behind(finished).map((b) => b.finishing)).toEqual([true]);
    const alone = run(rougher, at(2, 33), along(-24.8, "finish", "finish"), { limits: [plane] });
    expect(behind(alone).map((b) => b.finishing)).toEqual([false]);
  });
});

describe("the other side of the axis", () => {
  const flipped = (m: Move): Move =>
    ({ ...m, to: at(m.to.z, -m.to.r), ...(m.kind === "arc" && { centre: at(m.centre.z, -m.centre.r) }) }) as Move;
  const other = (TO: TipOrientation): TipOrientation =>
    ({ 1: 7, 2: 6, 3: 5, 4: 4, 5: 3, 6: 2, 7: 1, 8: 8, 9: 9 } as const)[TO];
  const moves = [
    rapid(-20, 27),
    rapid(-20, 33),
    rapid(-31, 33),
    cut(-31, 26, "rough", 1),
    cut(-12, 26, "rough", 1),
    rapid(-12, 40),
  ];
  const plan = { part: box(-50, 0, 0, 26.5), area: box(-50, 26.5, 0, 40) };
  test.each([rougher, bar])("sweeps the same as its mirror image: $NAME", (tool) => {
    const here = run(tool, at(-20, 35), moves, plan);
    const there = run({ ...tool, TO: other(tool.TO) }, at(-20, -35), moves.map(flipped), {
      ...plan,
      openSide: at(0, -1),
    });
    expect(areaOf(there.final)).toBeCloseTo(areaOf(here.final), 4);
    expect(here.findings.map((f) => f.kind)).toEqual(expect.arrayContaining(["rapidInStock", "gouge"]));
    expect(there.findings.map((f) => [f.kind, f.step, f.moves])).toEqual(
      here.findings.map((f) => [f.kind, f.step, f.moves]),
    );
    for (const what of ["gouge", "rapidInStock", "cut"] as const)
      expect(there.proof[what]).toBeCloseTo(here.proof[what], 3);
    expect(there.proof.deepest?.depth).toBeCloseTo(here.proof.deepest?.depth ?? 0, 3);
    for (const step of [0, 3, 4])
      expect(areaOf(playerOf(there).at({ step, fraction: 0.6 }))).toBeCloseTo(
        areaOf(playerOf(here).at({ step, fraction: 0.6 })),
        4,
      );
  });
  test("a tool that crosses the axis clears both sides of its width, and no stock is below the axis", () => {
    const s = run(bar, at(-20, 32), [cut(-20, -12)]);
    expect(areaOf(producedParts(s))).toBeCloseTo(50 * 30 - 3 * 30, 4);
    const stub = simulate({
      blank: [box(-50, 5, 0, 30)],
      operations: [],
      unproved: [],
      steps: [
        {
          from: at(-20, 0),
          move: cut(-20, -8),
          tool: { ...bar, CUTLENGTH: length(6) },
          block: 1,
          operation: null,
          seconds: 1,
        },
      ],
    });
    expect(areaOf(producedParts(stub))).toBeCloseTo(50 * 25 - 3 * 3 + 2 * (1 - Math.PI / 4) * 0.04, 2);
    expect(stub.final.flat().every((p) => p.r >= 5)).toBe(true);
  });
});

describe("one cause is one finding", () => {
  const part = { part: box(-50, 0, 0, 25), area: box(-50, 25, 0, 40) };
  const steps = Array.from({ length: 10 }, (_, i) => cut(-5 - i, 24.5, "rough", 1));
  test("moves that damage the part in one place are one finding, with the sum and the first step", () => {
    const s = run(bar, at(-5, 24.5), steps, part);
    expect(s.findings).toHaveLength(1);
    expect(s.findings[0]).toMatchObject({ kind: "gouge", moves: 10, step: 0 });
    expect(s.proof.gouge).toBeCloseTo((3 + 9) * 0.5, 0);
    expect(areaOf(s.findings[0]?.rings ?? [])).toBeCloseTo(s.proof.gouge, 1);
  });
  test("places apart stay apart", () => {
    const s = run(bar, at(-5, 33), [cut(-5, 24.5), cut(-5, 33), rapid(-30, 33), cut(-30, 24)], part);
    expect(s.findings.map((f) => f.step)).toEqual([0, 3]);
  });
  test("a holder that leans on the same stock in many moves is counted once", () => {
    const wide: Tool = {
      ...bar,
      holder: { width: length(14), length: length(80), offsetZ: length(2), offsetX: length(4) },
    };
    const s = run(
      wide,
      at(-20, 34),
      Array.from({ length: 12 }, (_, i) => cut(-20, 24 - i * 0.01, "rough", 1)),
    );
    expect(s.findings.map((f) => f.kind)).toEqual(["holderContact"]);
    expect(s.findings[0]?.moves).toBe(12);
    expect(s.findings[0]?.area).toBeLessThan(14 * 3);
  });
  test("hundreds of places give few findings with complete sums", () => {
    const many = Array.from({ length: 1200 }, (_, i) => [
      rapid(-0.04 * i - 1, 33),
      rapid(-0.04 * i - 1, 30 - 0.01 * (i % 7)),
    ]).flat();
    const s = run({ ...bar, CUTWIDTH: length(0.5) }, at(5, 33), many);
    expect(s.findings.length).toBeLessThan(501);
    expect(s.findings.reduce((sum, f) => sum + f.area, 0)).toBeCloseTo(s.proof.rapidInStock, 6);
  });
});
