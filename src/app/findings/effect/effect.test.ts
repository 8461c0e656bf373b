import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { Outcome } from "../../calculation/outcome.ts";
import type { JobReading } from "../../document/reading.ts";
import { chipArea, cutAtOnce, effectNow, effectOf } from "./effect.ts";

const call = (passes: number, infeed: number, moves = 1, cycle = 811) => ({
  cycle,
  tool: { CUTWIDTH: 3 },
  plan: { passes, infeed, moves: Array.from({ length: moves }, () => ({})) },
});
const outcome = (operations: readonly unknown[], areas: readonly number[], seconds = 60) =>
  ({
    run: { operations, seconds },
    simulation: { proof: { residual: areas.map((area) => ({ area })) } },
  }) as unknown as Outcome;

describe("the effect of a program", () => {
  const two = outcome([call(3, 1.5), call(2, 2.5)], [0.4, 0.2]);
  test.each([
    ["passes add up, the infeed is that of the first", two, { passes: 5, infeed: 1.5, seconds: 60, residual: 0.6 }],
    [
      "a rounding of areas is none",
      outcome([call(1, 1)], [0.002, 0.0029]),
      { passes: 1, infeed: 1, seconds: 60, residual: 0 },
    ],
    [
      "a little is a little",
      outcome([call(1, 1)], [0.002, 0.0031]),
      { passes: 1, infeed: 1, seconds: 60, residual: 0.0051 },
    ],
    [
      "a call without a path leaves the residue open",
      outcome([call(1, 1), call(0, 0, 0)], [0.4]),
      { passes: 1, infeed: 1, seconds: 60, residual: null },
    ],
    ["nothing", outcome([], []), { passes: 0, infeed: 0, seconds: 60, residual: 0 }],
  ])("%s", (_, made, effect) => {
    const found = effectOf(made);
    expect({ ...found, residual: found.residual && Math.round(found.residual * 1e6) / 1e6 }).toEqual(effect);
    expect(effectOf(made)).toBe(found);
  });

  test("of a run that is not proved yet has the residue of the proof before", () => {
    const planned = { ...outcome([call(9, 1)], [7], 30), simulation: null } as unknown as Outcome;
    expect(effectNow(planned, two)).toMatchObject({ passes: 9, seconds: 30 });
    expect(effectNow(planned, two).residual).toBeCloseTo(0.6, 9);
    expect(effectNow(planned, null).residual).toBeNull();
    expect(effectNow(two, outcome([], [5]))).toBe(effectOf(two));
  });

  test("the cut at once is the infeed, of a plunge the width of the tool", () => {
    expect([cutAtOnce(two), cutAtOnce(outcome([call(4, 1.5, 1, 861)], [])), cutAtOnce(outcome([], []))]).toEqual([
      1.5, 3, 0,
    ]);
  });

  test("the chip is cut by feed: per revolution, or by the speed where that is known", () => {
    const reading = (perRevolution: boolean, value: unknown, mode = "constant") =>
      ({
        cycle: cycleByNumber(811),
        job: { perRevolution, spindle: { mode, speed: "500", cuttingSpeed: "180" } },
        reading: { perField: { Q478: { value } } },
      }) as unknown as JobReading;
    expect(chipArea(reading(true, 0.3), 2)).toBeCloseTo(0.6, 9);
    expect(chipArea(reading(false, 150), 2)).toBeCloseTo(0.6, 9);
    expect(chipArea(reading(false, 150, "surface"), 2)).toBeNull();
    expect(chipArea(reading(true, "auto"), 2)).toBeNull();
  });
});
