import { describe, expect, test } from "vitest";
import type { Move } from "../../kernel/plan/move.ts";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { feed, length } from "../../kernel/units.ts";
import type { PathLoad } from "../../sim/load/along.ts";
import type { RoughStretch } from "../../sim/load/roughness.ts";
import { drawingAlong, drawingOfSurface } from "./lines.ts";
import { stretchNear, stretchOfStep } from "./near.ts";
import { classAt, classesOf, classTone, scaleOf } from "./scale.ts";
import { greatestAlong, roughestOf, rowAt, worstOf } from "./values.ts";

describe("classes by round numbers", () => {
  test.each([
    [0, 3.02, [0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5]],
    [0, 0.23, [0, 0.05, 0.1, 0.15, 0.2, 0.25]],
    [0, 7.03, [0, 2, 4, 6, 8]],
    [137, 262, [125, 150, 175, 200, 225, 250, 275]],
    [0, 0.00041, [0, 0.0001, 0.0002, 0.0003, 0.0004, 0.0005]],
  ])("%f to %f", (low, high, bounds) => expect(scaleOf(low, high).bounds).toEqual(bounds));

  test("a constant value is one class in the middle tone; so is no value at all", () => {
    expect(scaleOf(187, 187.4).bounds).toEqual([187, 187.4]);
    expect(classTone(scaleOf(187, 187.4), 0)).toBe(3);
    expect(classesOf(scaleOf(0, 0))).toBe(1);
  });

  test("never more than seven classes, every value in its own, the last always in the strongest tone", () => {
    for (let high = 0.0137; high < 9000; high *= 1.317) {
      const scale = scaleOf(0, high),
        last = classesOf(scale) - 1;
      expect(last).toBeLessThan(7);
      expect(last).toBeGreaterThan(2);
      expect(classAt(scale, high)).toBe(last);
      expect(classTone(scale, last)).toBe(6);
      for (const share of [0.07, 0.31, 0.77]) {
        const index = classAt(scale, high * share);
        expect(scale.bounds[index]).toBeLessThanOrEqual(high * share);
        expect(scale.bounds[index + 1]).toBeGreaterThan(high * share);
      }
    }
  });
});

const tool: Tool = { T: 1, NAME: "ROUND", TYPE: "BUTTON", TO: 9, RS: length(2) };
const purpose = { phase: "rough", run: "rough", step: 1 } as const;
const to = (z: number, r: number): Move => ({
  kind: "feed",
  to: at(z, r),
  feed: feed(0.21),
  feedUnit: "mm/rev",
  ...purpose,
});
const round: Move = { ...to(-14, 26), kind: "arc", centre: at(-10, 26), turn: "ccw" } as Move;
const moves: readonly (readonly [Pt, Move, number | null])[] = [
  [at(2, 30), to(-10, 30), 0],
  [at(-10, 30), round, 0],
  [at(-14, 26), to(-14, 9), 1],
  [at(-14, 9), to(-20, 9), null],
];
const steps: Step[] = moves.map(([from, move, operation], i) => ({
  from,
  move,
  tool,
  block: 20 + i,
  operation,
  seconds: 1,
}));

/** Columns from rows: step, from, to, depth, speed, limited. */
const loadOf = (rows: readonly (readonly [number, number, number, number, number, number])[]): PathLoad => {
  const column = (i: number) => Float64Array.from(rows, (row) => row[i] ?? NaN);
  return {
    count: rows.length,
    step: Int32Array.from(rows, (row) => row[0]),
    from: column(1),
    to: column(2),
    depth: column(3),
    chip: column(3).map((depth) => depth * 0.21),
    feed: column(3).map(() => 0.21),
    speed: column(4),
    rpm: column(4).map((speed) => speed * 5),
    limited: Uint8Array.from(rows, (row) => row[5]),
  };
};
const load = loadOf([
  [0, 0, 0.25, 0, 187, 0],
  [0, 0.25, 1, 1.37, 187, 0],
  [1, 0, 1, 2.61, 187, 0],
  [2, 0, 0.4, 1.9, 187, 0],
  [2, 0.4, 1, 0.7, 93, 1],
  [3, 0, 1, NaN, 93, 0],
]);

describe("values along the path", () => {
  test("the row of a moment, and none where nothing is fed", () => {
    expect(rowAt(load, { step: 0, fraction: 0.1 })).toBe(0);
    expect(rowAt(load, { step: 0, fraction: 0.6 })).toBe(1);
    expect(rowAt(load, { step: 2, fraction: 0.41 })).toBe(4);
    expect(rowAt(load, { step: 4, fraction: 0 })).toBeNull();
  });

  test("the greatest of each operation with its block and place, and the worst of all", () => {
    const each = greatestAlong(load, "depth", steps);
    expect(each.map(({ operation, value, block }) => [operation, value, block])).toEqual([
      [0, 2.61, 21],
      [1, 1.9, 22],
    ]);
    expect(each[1]?.position).toEqual({ step: 2, fraction: 0.2 });
    expect(each[1]?.place.r).toBeCloseTo(26 - 0.2 * 17, 9);
    expect(worstOf(each)?.block).toBe(21);
    expect(worstOf([])).toBeNull();
  });

  test("at a limit the least cutting speed is the worst, whatever is greater elsewhere", () => {
    const each = greatestAlong(load, "speed", steps);
    expect(each.map(({ value, limited }) => [value, limited])).toEqual([
      [187, false],
      [93, true],
      [93, false],
    ]);
    expect(worstOf(each)).toMatchObject({ value: 93, block: 22 });
  });

  test("one path a class, air left out, the strongest on top; arcs stay arcs", () => {
    const { scale, lines } = drawingAlong(load, "depth", steps, () => true);
    expect(scale.bounds).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3]);
    expect(lines.map(({ tone }) => tone)).toEqual([1, 2, 4, 6]);
    expect(lines[3]?.d).toMatch(/^M-10 30A4 4 0 0 1 -14 26$/);
    expect(lines[1]?.d).toBe("M-1 30L-10 30");
    expect(drawingAlong(load, "depth", steps, (step) => step === 2).lines).toHaveLength(2);
  });

  test("stretches at a limit have a line of their own", () => {
    const { lines } = drawingAlong(load, "speed", steps, () => true);
    expect(lines.filter(({ limited }) => limited).map(({ d }) => d)).toEqual(["M-14 19.2L-14 9"]);
  });
});

describe("values of the surface", () => {
  const stretch = (
    points: readonly Pt[],
    rz: number | null,
    step: number,
    fraction: number,
    operation: number,
  ): RoughStretch => ({
    points,
    rz,
    exact: rz,
    by: rz === null ? "edge" : "nose",
    feed: 0.21,
    nose: 0.4,
    position: { step, fraction },
    block: 20 + step,
    operation,
  });
  const stretches = [
    stretch([at(0, 20), at(-1.5, 21.5)], 6.27, 0, 0.1, 0),
    stretch([at(-1.5, 21.5), at(-31, 21.5), at(-33, 21.5)], 6.26, 0, 0.6, 0),
    stretch([at(-33, 21.5), at(-33, 30)], null, 1, 0.5, 1),
    stretch([at(-33, 30), at(-40, 30)], 1.13, 2, 0.5, 1),
  ];

  test("of equally rough stretches the longest is named", () => {
    expect(roughestOf(stretches).map(({ value, operation }) => [value, operation])).toEqual([
      [6.26, 0],
      [1.13, 1],
    ]);
    expect(roughestOf(stretches)[0]?.place).toEqual(at(-31, 21.5));
  });

  test("stretches without a value have a line without a tone, at the bottom", () => {
    const { lines } = drawingOfSurface(stretches);
    expect(lines.map(({ tone }) => tone)).toEqual([null, 1, 6]);
    expect(lines[0]?.d).toBe("M-33 21.5L-33 30");
  });

  test("the stretch under a pointer, above the axis and below it, and the stretch of the running move", () => {
    expect(stretchNear(stretches, at(-20, -21.8), 0.5)).toBe(stretches[1]);
    expect(stretchNear(stretches, at(-20, 23), 0.5)).toBeNull();
    expect(stretchOfStep(stretches, { step: 0, fraction: 0.2 })).toBe(stretches[0]);
    expect(stretchOfStep(stretches, { step: 7, fraction: 0.2 })).toBeNull();
  });
});
