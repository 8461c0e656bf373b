import { describe, expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import type { Move, Phase } from "../kernel/plan/move.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import type { Pt, Ring, Segment } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { axial, degrees, feed, length, radius } from "../kernel/units.ts";
import { stockIssues } from "./issues.ts";
import { simulate } from "./simulate.ts";
import { playerOf, stockAt } from "./stock.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const purpose = (phase: Phase) => ({ phase, run: "rough", step: 1 }) as const;
const rapid = (z: number, r: number): Move => ({ kind: "rapid", to: at(z, r), ...purpose("position") });
const cut = (z: number, r: number): Move => ({
  kind: "feed",
  to: at(z, r),
  feed: feed(0.3),
  feedUnit: "mm/rev",
  ...purpose("rough"),
});

const bar: Tool = {
  T: 9,
  NAME: "BAR-3",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0.2),
  CUTWIDTH: length(3),
  CUTLENGTH: length(30),
};
const button: Tool = { T: 11, NAME: "BUTTON-3", TYPE: "BUTTON", TO: 2, RS: length(3) };
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
const blank = [box(-50, 0, 0, 30)];
const blankArea = 50 * 30;

function steps(tool: Tool, start: Pt, moves: readonly Move[]): Step[] {
  let from = start;
  return moves.map((move, i) => {
    const step: Step = { from, move, tool, block: 10 + i, operation: 0, seconds: 1 };
    from = move.to;
    return step;
  });
}
const run = (tool: Tool, start: Pt, moves: readonly Move[], plan?: Partial<Plan>) => {
  const list = steps(tool, start, moves);
  const whole: Plan = {
    moves,
    issues: [],
    contour: [],
    passes: 1,
    infeed: length(1),
    area: [],
    part: [],
    openSide: at(0, 1),
    reach: [],
    oversizeReach: [],
    maxInfeed: length(0),
    ...plan,
  };
  return simulate({
    blank,
    steps: list,
    operations: plan ? [{ plan: whole, tool, firstStep: 0, lastStep: list.length - 1 }] : [],
    unproved: [],
  });
};
const line = (from: Pt, to: Pt): Segment => ({ kind: "line", from, to });

describe("removed areas follow the formulas", () => {
  test("a plunge with a bar: its width times its depth, less two corners", () => {
    const s = run(bar, at(-20, 32), [cut(-20, 25)]);
    expect(blankArea - areaOf(s.final)).toBeCloseTo(3 * 5 - 2 * (1 - Math.PI / 4) * 0.2 ** 2, 3);
  });
  test("facing to the axis stops there: nothing is cut below it", () => {
    const s = run(bar, at(-1.5, 32), [cut(-1.5, -2)]);
    expect(areaOf(s.final)).toBeCloseTo(blankArea - 3 * 30, 6);
    expect(s.final.flat().every((p) => p.r >= 0)).toBe(true);
  });
  test("a button along Z: a band and half a circle segment at the end", () => {
    const s = run(button, at(5, 27), [cut(-20, 27)]);
    expect(blankArea - areaOf(s.final)).toBeCloseTo(20 * 3 + (Math.PI * 9) / 4, 1);
  });
  test("a button round an arc: the band between two circles", () => {
    const arc: Move = {
      kind: "arc",
      to: at(-25, 15),
      centre: at(-25, 27),
      turn: "ccw",
      feed: feed(0.2),
      feedUnit: "mm/rev",
      ...purpose("finish"),
    };
    const s = run(button, at(-37, 27), [arc]);
    expect(blankArea - areaOf(s.final)).toBeCloseTo((Math.PI / 4) * (15 ** 2 - 9 ** 2) + (Math.PI * 9) / 2, 1);
  });
  test("parting leaves the held piece and reports the other", () => {
    const { final, proof } = run(bar, at(-20, 32), [cut(-20, -1)]);
    expect(final).toHaveLength(1);
    expect(proof.loose).toMatchObject([{ shape: "piece", isPartedOff: true, block: 10 }]);
  });
});

describe("rapid moves", () => {
  test("returning along a surface just cut is no contact", () => {
    const s = run(rougher, at(2, 27), [cut(-30, 27), rapid(2, 27), rapid(-30, 27), cut(-30, 40), rapid(2, 40)]);
    expect(s.findings).toEqual([]);
    expect(s.proof.rapidInStock).toBe(0);
  });
  test("backing out square at rapid is one when the main edge leans back over the wall", () => {
    const s = run(rougher, at(2, 27), [cut(-30, 27), rapid(-30, 40)]);
    expect(s.findings.map((f) => f.kind)).toEqual(["rapidInStock"]);
  });
  test("a rapid into the material is found with its place, once", () => {
    const s = run(bar, at(-20, 32), [rapid(-20, 28), cut(-20, 27)]);
    expect(s.findings).toHaveLength(1);
    expect(s.findings[0]).toMatchObject({ kind: "rapidInStock", step: 0, block: 10 });
    expect(s.proof.rapidInStock).toBeCloseTo(3 * 2 - 2 * (1 - Math.PI / 4) * 0.04, 2);
    const { place } = s.findings[0]!;
    expect(place.z).toBeCloseTo(-20, 1);
    expect(place.r).toBeCloseTo(29, 0);
  });
  test("material removed by the previous batch is gone", () => {
    const s = run(bar, at(-20, 32), [cut(-20, 25), cut(-20, 32), rapid(-20, 25), rapid(-20, 32)]);
    expect(s.findings).toEqual([]);
  });
});

describe("gouge", () => {
  const plan = {
    part: box(-50, 0, 0, 25),
    area: box(-50, 25, 2, 32),
    reach: [{ path: line(at(2, 25), at(-50, 25)), reason: null }],
  };
  test("cutting along the contour is no damage", () => {
    expect(run(rougher, at(2, 25), [cut(-50, 25)], plan).proof.gouge).toBe(0);
  });
  test("half a millimetre too deep is found by its area, and only by the move that cut it", () => {
    const s = run(bar, at(-20, 32), [cut(-20, 24.5), cut(-20, 32), cut(-20, 24.5)], plan);
    expect(s.findings.map((f) => [f.kind, f.step])).toEqual([["gouge", 0]]);
    expect(s.proof.gouge).toBeCloseTo(3 * 0.5 - 2 * (1 - Math.PI / 4) * 0.04, 1);
  });
  test("a groove in a part turned before is the second operation's own area", () => {
    const first = run(rougher, at(2, 25), [cut(-50, 25)], plan);
    const groove = {
      plan: { ...EMPTY, part: box(-50, 0, 0, 20), area: box(-21.5, 20, -18.5, 25) },
      tool: bar,
      firstStep: 1,
      lastStep: 2,
    };
    const turned = { plan: { ...EMPTY, ...plan }, tool: rougher, firstStep: 0, lastStep: 0 };
    const list = [...first.steps, ...steps(bar, at(-20, 32), [cut(-20, 20), cut(-20, 32)])];
    expect(simulate({ blank, steps: list, operations: [turned, groove], unproved: [] }).proof.gouge).toBe(0);
    expect(simulate({ blank, steps: list, operations: [turned], unproved: [] }).proof.gouge).toBeCloseTo(15, 0);
  });
});
const EMPTY: Plan = {
  moves: [],
  issues: [],
  contour: [],
  passes: 0,
  infeed: length(0),
  area: [],
  part: [],
  openSide: at(0, 1),
  reach: [],
  oversizeReach: [],
  maxInfeed: length(0),
};

describe("holder", () => {
  const withHolder: Tool = {
    ...bar,
    holder: { width: length(20), length: length(80), offsetZ: length(-1), offsetX: length(10) },
  };
  test("a plunge less deep than the overhang is free", () => {
    expect(run(withHolder, at(-20, 32), [cut(-20, 21)]).findings).toEqual([]);
  });
  test("a deeper one touches", () => {
    const s = run(withHolder, at(-20, 32), [cut(-20, 18)]);
    expect(s.findings.map((f) => f.kind)).toEqual(["holderContact"]);
  });
  test("what the insert has cut in the same move is not touched", () => {
    const slim: Tool = {
      ...bar,
      holder: { width: length(2), length: length(80), offsetZ: length(-1), offsetX: length(1) },
    };
    expect(run(slim, at(-20, 32), [cut(-20, 10)]).findings).toEqual([]);
  });
  test("is clear, in contact, or unknown as soon as one tool of the run has none", () => {
    const moves = [cut(-20, 25), rapid(-20, 32)];
    const state = (...tools: Tool[]) => {
      const list = tools.flatMap((tool) => steps(tool, at(-20, 32), moves));
      return simulate({ blank, steps: list, operations: [], unproved: [] }).proof.holder;
    };
    expect(state(withHolder)).toBe("clear");
    expect(state(withHolder, bar)).toBe("unknown");
    expect(state(bar)).toBe("unknown");
    expect(run(withHolder, at(-20, 32), [cut(-20, 18)]).proof.holder).toBe("contact");
  });
});

describe("residual material", () => {
  const shoulder = (reason: null | "secondaryEdge") => ({
    part: [at(-50, 0), at(0, 0), at(0, 20), at(-30, 20), at(-30, 30), at(-50, 30)],
    area: box(-30, 20, 2, 32),
    reach: [
      { path: line(at(2, 20), at(-30, 20)), reason },
      { path: line(at(-30, 20), at(-30, 32)), reason: null },
    ],
  });
  const finish = [cut(2, 20), cut(-30, 20), cut(-30, 32)];
  const rough = [cut(2, 26), cut(-30, 26), cut(-30, 33), rapid(2, 33), rapid(2, 20), cut(-30, 20), cut(-30, 33)];
  test("a sharp inner corner keeps the residue of the nose radius", () => {
    const s = run(rougher, at(2, 35), rough, shoulder(null));
    expect(s.proof.gouge).toBe(0);
    expect(s.proof.residual.map((r) => r.reason)).toEqual(["insertRadius"]);
    expect(s.proof.residual[0]!.area).toBeCloseTo((1 - Math.PI / 4) * 0.64, 1);
  });
  test("a stretch with a reason passes it on", () => {
    expect(run(rougher, at(2, 35), rough, shoulder("secondaryEdge")).proof.residual.map((r) => r.reason)).toEqual([
      "secondaryEdge",
    ]);
  });
  test("uncut material is oversize, apart from material that cannot be cut", () => {
    const s = run(rougher, at(2, 35), [cut(2, 26), cut(-30, 26), cut(-30, 33)], shoulder(null));
    expect(s.proof.residual.map((r) => r.reason)).toEqual(["insertRadius", "oversize"]);
    expect(s.proof.residual[1]!.area).toBeCloseTo(30 * 6, 0);
  });
  test("a plain cylinder leaves no residual material", () => {
    const plan = {
      part: box(-50, 0, 0, 25),
      area: box(-50, 25, 2, 32),
      reach: [{ path: line(at(2, 25), at(-50, 25)), reason: null }],
    };
    expect(run(rougher, at(2, 25), [cut(-55, 25), cut(-55, 33)], plan).proof.residual).toEqual([]);
  });
  test("in a bore, residue keeps its own reason although the bore is open across the axis", () => {
    const plan = {
      part: box(-50, 20, 0, 30),
      area: box(-30, 0, -20, 20),
      openSide: at(0, -1),
      reach: [{ path: line(at(-20, 15), at(-30, 15)), reason: null }],
    };
    const left = run({ ...button, TO: 6 }, at(-20, 15), [cut(-30, 15)], plan).proof.residual;
    expect(left.find((r) => r.reason === "insertRadius")?.area).toBeCloseTo(10 * 5, 0);
  });
  test("issues say X as a diameter", () => {
    const all = stockIssues(run(rougher, at(2, 35), finish, shoulder(null)));
    expect(all.every((i) => i.issue.code === "materialLeft")).toBe(true);
    expect((all[0]!.issue.data as { x: number }).x).toBeGreaterThan(39);
  });
});

test("times add up and an empty program is the blank", () => {
  const s = run(rougher, at(2, 27), [cut(-30, 27), rapid(2, 27)]);
  expect([...s.startTimes]).toEqual([0, 1, 2]);
  expect(s.totalSeconds).toBe(2);
  const none = simulate({ blank, steps: [], operations: [], unproved: [] });
  expect(none.final).toEqual(blank);
  expect(stockAt(none, { step: 3, fraction: 0.4 })).toEqual(blank);
  expect(playerOf(none).at({ step: NaN, fraction: NaN })).toEqual(blank);
});

test("moves that are no numbers cut nothing and break nothing", () => {
  const s = run(rougher, at(2, 27), [cut(NaN, 27), cut(-30, Infinity), cut(-30, 27), cut(2, 27)]);
  expect(s.final.flat().every((p) => Number.isFinite(p.z) && Number.isFinite(p.r))).toBe(true);
  expect(areaOf(s.final)).toBeLessThan(blankArea);
});
