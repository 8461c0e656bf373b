import { describe, expect, test } from "vitest";
import type { FeedUnit, Move } from "../../kernel/plan/move.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Spindle, Step } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { degrees, feed, length, radians } from "../../kernel/units.ts";
import { simulate } from "../simulate.ts";
import { loadAlong, type PathLoad } from "./along.ts";
import { rzByRule } from "./cusp.ts";
import { roughnessOf } from "./roughness.ts";

const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
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
const copier: Tool = {
  ...rougher,
  T: 4,
  NAME: "VNMG",
  "P-ANGLE": degrees(35),
  "T-ANGLE": degrees(100),
  RS: length(0.4),
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
const button: Tool = { T: 11, NAME: "BUTTON", TYPE: "BUTTON", TO: 9, RS: length(2) };

const purpose = { phase: "rough", run: "rough", step: 1 } as const;
const rapid = (z: number, r: number): Move => ({ kind: "rapid", to: at(z, r), ...purpose });
const cut = (z: number, r: number, f = 0.23, feedUnit: FeedUnit = "mm/rev"): Move => ({
  kind: "feed",
  to: at(z, r),
  feed: feed(f),
  feedUnit,
  ...purpose,
});
function stepsOf(tool: Tool, start: Pt, moves: readonly Move[]): Step[] {
  let from = start;
  return moves.map((move, i) => {
    const step: Step = { from, move, tool, block: 10 + i, operation: 0, seconds: 1 };
    from = move.to;
    return step;
  });
}

const constant: Spindle = { kind: "constant", speed: 913 };
function loadOf(blank: readonly Ring[], steps: readonly Step[], spindle: Spindle | null = constant): PathLoad {
  const going = loadAlong({ blank, steps, spindles: spindle ? [{ step: 0, spindle }] : [] });
  for (;;) {
    const now = going.next();
    if (now.done) return now.value;
  }
}
/** The row that covers a moment of a step. */
function rowAt(load: PathLoad, step: number, fraction: number) {
  const k = load.step.findIndex(
    (of, i) => of === step && (load.from[i] ?? 0) <= fraction && (load.to[i] ?? 0) >= fraction,
  );
  const pick = (name: "depth" | "chip" | "feed" | "speed" | "rpm") => load[name][k] ?? NaN;
  return {
    depth: pick("depth"),
    chip: pick("chip"),
    feed: pick("feed"),
    speed: pick("speed"),
    rpm: pick("rpm"),
    limited: load.limited[k],
  };
}

describe("what is taken along the path", () => {
  const blank = [box(-60, 0, 0, 31.37)];

  test("a straight cut: its depth, and depth times feed", () => {
    const load = loadOf(blank, stepsOf(rougher, at(2, 30), [cut(-41, 30)]));
    const { depth, chip } = rowAt(load, 0, 0.5);
    expect(depth).toBeCloseTo(1.37, 3);
    expect(chip).toBeCloseTo(1.37 * 0.23, 3);
    expect(rowAt(load, 0, 0.02).depth).toBe(0);
  });

  test("the second pass is measured in the stock left by the first, not by its infeed", () => {
    const steps = stepsOf(rougher, at(2, 30), [
      cut(-41, 30),
      rapid(-40, 33),
      rapid(2, 33),
      rapid(2, 27.1),
      cut(-50, 27.1),
    ]);
    const load = loadOf(blank, steps);
    expect(Math.abs(rowAt(load, 4, 0.4).depth - 2.9)).toBeLessThan(0.02);
    expect(Math.abs(rowAt(load, 4, 0.95).depth - 4.27)).toBeLessThan(0.02);
  });

  test("air cuts have no depth, nor does repeating a cut", () => {
    const steps = stepsOf(rougher, at(2, 30), [
      cut(-41, 30),
      rapid(-40, 33),
      rapid(2, 33),
      rapid(2, 30),
      cut(-40, 30, 0.11),
    ]);
    const load = loadOf(blank, steps);
    expect(rowAt(load, 4, 0.5)).toMatchObject({ depth: 0, chip: 0, feed: 0.11 });
    expect(load.step).not.toContain(1);
  });

  test("a taper: square to the path, regardless of the infeed direction", () => {
    // The same taper of 17 degrees twice, the second 1.1 mm deeper along the normal.
    const slope = radians(17),
      [sin, cos] = [Math.sin(slope), Math.cos(slope)];
    const on = (s: number, deeper: number) => at(3 - s * cos - deeper * sin, 24 + s * sin - deeper * cos);
    const first = [on(0, 0), on(40, 0)] as const,
      second = [on(0, 1.1), on(40, 1.1)] as const;
    const steps = stepsOf(copier, first[0], [
      cut(first[1].z, first[1].r),
      rapid(first[1].z, 60),
      rapid(3, 60),
      rapid(second[0].z, second[0].r),
      cut(second[1].z, second[1].r),
    ]);
    const load = loadOf([box(-60, 0, 0, 50)], steps);
    expect(rowAt(load, 4, 0.5).depth).toBeCloseTo(1.1, 2);
  });

  test("an arc within an arc: the ring between them, divided by the path of the tip", () => {
    // A button about one centre, from the face: its edge goes from 17 mm to 17.7 mm round it.
    const arc = (size: number): Move => ({
      kind: "arc",
      to: at(-size, 40),
      centre: at(0, 40),
      turn: "cw",
      feed: feed(0.19),
      feedUnit: "mm/rev",
      ...purpose,
    });
    const steps = stepsOf(button, at(0, 40 - 15), [
      arc(15),
      rapid(-15, 60),
      rapid(0, 60),
      rapid(0, 40 - 15.7),
      arc(15.7),
    ]);
    const load = loadOf([box(-60, 0, 0, 38)], steps);
    const { depth, chip } = rowAt(load, 4, 0.45);
    expect(depth).toBeCloseTo((17.7 ** 2 - 17 ** 2) / 2 / 15.7, 2);
    expect(chip).toBeCloseTo(depth * 0.19, 6);
  });

  test("a plunge takes the width of its edge", () => {
    expect(rowAt(loadOf(blank, stepsOf(bar, at(-20, 33), [cut(-20, 24)])), 0, 0.6).depth).toBeCloseTo(3, 3);
  });

  test("a feed in mm/min is converted to mm/rev; without a spindle speed it is unknown", () => {
    const steps = stepsOf(rougher, at(2, 30), [cut(-41, 30, 187, "mm/min")]);
    const { feed, chip, speed, limited } = rowAt(loadOf(blank, steps), 0, 0.5);
    expect(feed).toBeCloseTo(187 / 913, 9);
    expect(chip).toBeCloseTo((1.37 * 187) / 913, 3);
    expect(speed).toBeCloseTo((Math.PI * 60 * 913) / 1000, 6);
    expect(limited).toBe(0);
    expect(rowAt(loadOf(blank, steps, null), 0, 0.5)).toMatchObject({ feed: NaN, chip: NaN, speed: NaN });
  });

  test("facing with a speed limit: the cutting speed is constant down to one diameter, then falls", () => {
    const spindle: Spindle = { kind: "surface", cuttingSpeed: 187, limit: 1900 };
    const load = loadOf([box(-60, 0, 1.3, 31)], stepsOf(rougher, at(0, 33), [cut(0, -0.8)]), spindle);
    const fractionAt = (r: number) => (33 - r) / 33.8;
    const knee = 187_000 / (2 * Math.PI * 1900);
    expect(rowAt(load, 0, fractionAt(knee + 1)).speed).toBeCloseTo(187, 6);
    expect(rowAt(load, 0, fractionAt(knee + 1)).limited).toBe(0);
    const near = rowAt(load, 0, fractionAt(7.1));
    expect(near.limited).toBe(1);
    expect(near.rpm).toBeCloseTo(1900, 6);
    expect(Math.abs(near.speed - (2 * Math.PI * 7.1 * 1900) / 1000)).toBeLessThan(5);
    expect(rowAt(load, 0, fractionAt(20)).depth).toBeCloseTo(1.3, 2);
  });

  test("facing without a limit: cutting speed, feed and depth are constant while the spindle speeds up", () => {
    const spindle: Spindle = { kind: "surface", cuttingSpeed: 183, limit: 0 };
    const load = loadOf(
      [box(-60, 0, 1.3, 30.5)],
      stepsOf({ ...copier, "T-ANGLE": degrees(120) }, at(0, 33), [cut(0, -0.8, 0.17)]),
      spindle,
    );
    for (const r of [27.1, 14.3, 6.9]) {
      const row = rowAt(load, 0, (33 - r) / 33.8),
        rpm = 183_000 / (2 * Math.PI * r);
      expect([row.speed, row.feed]).toEqual([expect.closeTo(183, 9), 0.17]);
      expect(row.depth).toBeCloseTo(1.3, 2);
      // One stretch (0.75 mm) has one speed.
      expect(Math.abs(row.rpm / rpm - 1)).toBeLessThan(0.75 / r + 0.02);
    }
  });

  test("a thread has its lead as feed, and no depth", () => {
    const thread: Move = {
      kind: "thread",
      to: at(-20, 30),
      pitch: length(1.75),
      axis: "z",
      angle: degrees(0),
      stops: false,
      ...purpose,
    };
    const { depth, feed } = rowAt(loadOf(blank, stepsOf(copier, at(4, 30), [thread])), 0, 0.5);
    expect([depth, feed]).toEqual([NaN, 1.75]);
  });

  test("ten thousand small moves have at most one row each, and one long path no more than its share", () => {
    const moves = Array.from({ length: 10_000 }, (_, i) => cut(2 - i * 0.004, 30 + (i % 2) * 0.01));
    const load = loadOf([box(-60, 0, 0, 29)], stepsOf(rougher, at(2, 30), moves));
    expect(load.count).toBeLessThanOrEqual(moves.length);
    const long = loadOf([box(-60, 0, 0, 29)], stepsOf(rougher, at(2, 30), [cut(-90_000, 60)]), {
      kind: "surface",
      cuttingSpeed: 200,
      limit: 0,
    });
    expect(long.count).toBeLessThanOrEqual(400);
  });
});

describe("the roughness of what is left", () => {
  const spindles: readonly { readonly step: number; readonly spindle: Spindle }[] = [{ step: 0, spindle: constant }];
  const roughOf = (blank: readonly Ring[], steps: readonly Step[], from = spindles) => {
    const { final } = simulate({ blank, steps, operations: [], unproved: [] });
    return roughnessOf(final, steps, from);
  };
  /** The stretch of the surface at a point. */
  const through = (stretches: ReturnType<typeof roughOf>, z: number, r: number) =>
    stretches.find(({ points }) =>
      points.slice(1).some((to, i) => part.distanceTo({ kind: "line", from: points[i] as Pt, to }, at(z, r)) < 0.01),
    );

  const blank = [box(-60, 0, 0, 31.37)];

  test("roughness comes from the last feed along the surface; unmachined surfaces have none", () => {
    const steps = stepsOf(copier, at(2, 30), [
      cut(-41, 30),
      rapid(-40, 33),
      rapid(2, 33),
      rapid(2, 30),
      cut(-17.3, 30, 0.117),
    ]);
    const found = roughOf(blank, steps);
    expect(through(found, -9, 30)).toMatchObject({ by: "nose", rz: rzByRule(0.117, 0.4), nose: 0.4, block: 14 });
    expect(through(found, -30, 30)).toMatchObject({ by: "nose", rz: rzByRule(0.23, 0.4), block: 10 });
    expect(through(found, -55, 31.37)).toBeUndefined();
    const { position } = through(found, -30, 30) ?? {};
    expect(position?.step).toBe(0);
    expect(part.pointOn({ kind: "line", from: at(2, 30), to: at(-41, 30) }, position?.fraction ?? 0).z).toBeLessThan(
      -17,
    );
  });

  test("tapers and arcs are measured along their own direction", () => {
    const round: Move = {
      ...cut(0, 0, 0.141),
      kind: "arc",
      to: at(-14.4, 30.6),
      centre: at(-14.4, 36.6),
      turn: "cw",
    } as Move;
    const steps = stepsOf(copier, at(2, 20), [
      cut(-8.4, 22.63, 0.083),
      rapid(-8.4, 36.6),
      { ...round, to: at(-14.4, 30.6) },
      cut(-14.4, 40),
    ]);
    const found = roughOf([box(-60, 0, 0, 33)], steps);
    const longest = (step: number) =>
      found.filter(({ position }) => position.step === step).sort((a, b) => b.points.length - a.points.length)[0];
    expect(longest(0)).toMatchObject({ by: "nose", rz: rzByRule(0.083, 0.4) });
    expect(longest(2)).toMatchObject({ by: "nose", rz: rzByRule(0.141, 0.4) });
  });

  test("a face at constant cutting speed with a feed in mm/min: coarser outside, where the spindle turns slower", () => {
    const surface = [{ step: 0, spindle: { kind: "surface", cuttingSpeed: 187, limit: 1900 } as const }];
    const found = roughOf(
      [box(-60, 0, 1.3, 31)],
      stepsOf({ ...copier, "T-ANGLE": degrees(120) }, at(0, 33), [cut(0, -0.4, 211, "mm/min")]),
      surface,
    );
    const rzAt = (r: number) => through(found, 0, r)?.rz ?? NaN;
    const perTurn = (r: number) => 211 / Math.min(1900, 187_000 / (2 * Math.PI * r));
    expect(rzAt(28)).toBeGreaterThan(rzAt(20));
    expect(Math.abs(rzAt(28) / rzByRule(perTurn(28), 0.4) - 1)).toBeLessThan(0.06);
    expect(rzAt(9)).toBeCloseTo(rzByRule(211 / 1900, 0.4), 6);
  });

  test("the bottom and walls of a groove and a thread are not formed by the nose", () => {
    const found = roughOf(blank, stepsOf(bar, at(-20, 33), [cut(-20, 24.2), rapid(-20, 33)]));
    expect(through(found, -20, 24.2)).toMatchObject({ by: "shape", rz: null });
    expect(through(found, -21.5, 28)).toMatchObject({ by: "edge", rz: null });
    const thread: Move = {
      kind: "thread",
      to: at(-20, 30.9),
      pitch: length(1.75),
      axis: "z",
      angle: degrees(0),
      stops: false,
      ...purpose,
    };
    expect(roughOf(blank, stepsOf(copier, at(4, 30.9), [thread])).map(({ by }) => by)).toContain("thread");
  });

  test("without a spindle speed a feed in mm/min gives no roughness", () => {
    const found = roughOf(blank, stepsOf(copier, at(2, 30), [cut(-41, 30, 187, "mm/min")]), []);
    expect(through(found, -20, 30)).toMatchObject({ by: "unknown", rz: null });
  });
});
