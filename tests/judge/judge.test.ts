import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf as ringArea } from "../../src/kernel/area/area.ts";
import { difference } from "../../src/kernel/area/clip.ts";
import { insertOutline } from "../../src/kernel/cutter/insert.ts";
import type { Move } from "../../src/kernel/plan/move.ts";
import { TOOL_TYPES, type TipOrientation, type Tool } from "../../src/kernel/plan/tool.ts";
import { axial, degrees, feed, length, radius } from "../../src/kernel/units.ts";
import { areaOf, common, crossed, each, filled, grown, shrunk, without } from "./field.ts";
import { hull, insertOf, type P } from "./insert.ts";
import { gridOver, judge, sumOf } from "./judge.ts";

/* Checks of the second judge itself: areas calculated by hand. */

const at = (z: number, r: number) => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number) => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const ring = (points: readonly P[]) => points.map((p) => at(p.z, p.r));
const mm = (min: number, max: number) => fc.integer({ min: min * 1000, max: max * 1000 }).map((n) => n / 1000);
const feeding = { feed: feed(0.2), feedUnit: "mm/rev", phase: "rough", run: "rough", step: 1 } as const;
const cut = (z: number, r: number): Move => ({ kind: "feed", to: at(z, r), ...feeding });
const rapid = (z: number, r: number): Move => ({ kind: "rapid", to: at(z, r), phase: "rough", run: "rough", step: 1 });
const bar = {
  T: 1,
  NAME: "BAR",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0),
  CUTWIDTH: length(4),
  CUTLENGTH: length(30),
} as Tool;

describe("columns", () => {
  const rings = [
    [
      { z: 0, r: 0 },
      { z: 10, r: 0 },
      { z: 10, r: 5 },
      { z: 0, r: 5 },
    ],
    [
      { z: 2, r: 1 },
      { z: 2, r: 3 },
      { z: 4, r: 3 },
      {
        z: 4,
        r: 1,
      },
    ],
  ];
  test.each(["z", "r"] as const)("along %s: a box with a hole, grown and shrunk", (along) => {
    const grid = gridOver(rings, along, 0.01);
    const field = filled(grid, rings);
    expect(areaOf(grid, field)).toBeCloseTo(46, 0);
    expect(areaOf(grid, grown(field, 0.5))).toBeGreaterThan(areaOf(grid, field) + 5);
    expect(areaOf(grid, each(field, grown(field, 0.01), without))).toBe(0);
    expect(areaOf(grid, each(shrunk(field, 0.01), field, without))).toBe(0);
    expect(areaOf(grid, each(field, shrunk(field, 0.01), without))).toBeGreaterThan(0.1);
  });
  test("stretches: intersection and difference make the whole", () => {
    const spans = fc
      .array(mm(0, 9), { maxLength: 8 })
      .map((n) => n.sort((a, b) => a - b))
      .map((n) => n.slice(0, n.length - (n.length % 2)));
    const size = (s: readonly number[]) => s.reduce((sum, n, i) => sum + (i % 2 ? n : -n), 0);
    fc.assert(
      fc.property(spans, spans, (a, b) => {
        expect(size(common(a, b)) + size(without(a, b))).toBeCloseTo(size(a), 9);
      }),
    );
  });
  test("a convex polygon crosses the columns that it fills", () => {
    const points = fc.array(fc.record({ z: mm(-9, 9), r: mm(-9, 9) }), { minLength: 3, maxLength: 9 });
    fc.assert(
      fc.property(points, fc.constantFrom("z" as const, "r" as const), (p, along) => {
        const shape = hull(p);
        fc.pre(shape.length > 2);
        const grid = gridOver([shape], along, 0.05);
        const field = filled(grid, [shape]);
        let apart = 0;
        crossed(grid, shape, (i, low, high) => {
          apart = Math.max(apart, Math.abs((field[i]?.[0] ?? low) - low), Math.abs((field[i]?.[1] ?? high) - high));
        });
        expect(apart).toBeLessThan(1e-6);
      }),
    );
  });
});

describe("the insert read twice", () => {
  const tools = fc
    .record({
      type: fc.constantFrom(...TOOL_TYPES),
      orientation: fc.constantFrom(1, 2, 3, 4, 5, 6, 7, 8),
      nose: mm(0, 1.2),
      delta: mm(0, 0.1),
      angle: mm(91, 110),
      point: mm(35, 69),
      width: mm(3, 6),
      edge: mm(5, 20),
      z: mm(-1, 1),
      r: mm(-1, 1),
    })
    .map((t): Tool => ({
      T: 1,
      NAME: "ANY",
      TYPE: t.type,
      TO: t.orientation as TipOrientation,
      RS: length(t.nose),
      DRS: length(t.delta),
      "T-ANGLE": degrees(t.angle),
      "P-ANGLE": degrees(t.point),
      CUTWIDTH: length(t.width),
      DCW: length(t.delta),
      CUTLENGTH: length(t.edge),
      correction: { z: length(t.z), r: length(t.r) },
    }));
  test("kernel and judge draw the same shape, for every type and orientation", () => {
    fc.assert(
      fc.property(tools, (tool) => {
        // A point that is cut off in front of the back of its nose is no insert.
        const [nose, half] = [tool.RS + (tool.DRS ?? 0), (((tool["P-ANGLE"] ?? 60) / 2) * Math.PI) / 180];
        fc.pre(tool.TYPE !== "THREAD" || (tool.CUTLENGTH ?? 0) * Math.cos(half) > nose * (1 / Math.sin(half) + 1));
        const [theirs, ours] = [insertOutline(tool, 0.0005), ring(insertOf(tool))];
        expect(ringArea(difference([theirs], [ours]))).toBeLessThan(0.02);
        expect(ringArea(difference([ours], [theirs]))).toBeLessThan(0.02);
        expect(Math.abs(ringArea([ours]))).toBeGreaterThan(tool.TYPE === "BUTTON" ? -1 : 1);
      }),
      { numRuns: 100 },
    );
  });
});

describe.each(["z", "r"] as const)("a cut on paper, columns along %s", (along) => {
  const blank = [box(-40, 0, 0, 20)];
  const grid = gridOver(blank, along, 0.02);
  const from = at(-20, 25);
  const run = (part: P[][], ...moves: Move[]) => {
    let here: P = from;
    return judge(
      blank,
      moves.map((move) => {
        const motion = { from: here, move, tool: bar };
        here = move.to;
        return motion;
      }),
      part,
      grid,
    );
  };
  test("a slot of 4 by 5", () => expect(Math.abs(run([], cut(-20, 15)).removed - 20)).toBeLessThan(0.11));
  test("the same slot twice is cut once", () =>
    expect(Math.abs(run([], cut(-20, 15), cut(-20, 25), cut(-20, 15)).removed - 20)).toBeLessThan(0.11));
  test("across the axis: at −5 it cuts material at 5", () => {
    const across = run([], cut(-20, -5));
    expect(Math.abs(across.removed - 80)).toBeLessThan(0.25);
    const beyond = judge(blank, [{ from: at(-20, -60), move: cut(-20, -45), tool: bar }], [], grid);
    expect(Math.abs(beyond.removed - 20)).toBeLessThan(0.11);
  });
  test("an arc of the bar's corner, at feed and at rapid", () => {
    const arc: Move = { kind: "arc", to: at(-20, 15), centre: at(-25, 15), turn: "cw", ...feeding };
    expect(run([], cut(-25, 20), arc).removed).toBeGreaterThan(20);
    expect(sumOf(run([], rapid(-20, 15)), "rapid")).toBeGreaterThan(19);
    expect(sumOf(run([], cut(-20, 15), rapid(-20, 25), rapid(-20, 15)), "rapid")).toBe(0);
  });
  test("a gouge is a cut into the part", () => {
    const part = [
      [
        { z: -40, r: 0 },
        { z: 0, r: 0 },
        { z: 0, r: 16 },
        { z: -40, r: 16 },
      ],
    ];
    expect(Math.abs(sumOf(run(part, cut(-20, 15)), "gouge") - 4)).toBeLessThan(0.15);
    expect(sumOf(run(part, cut(-20, 16)), "gouge")).toBe(0);
  });
  test("a tool that begins in material is reported", () => {
    expect(run([], cut(-20, 15)).inside).toBe(false);
    expect(judge(blank, [{ from: at(-20, 18), move: cut(-20, 15), tool: bar }], [], grid).inside).toBe(true);
  });
});
