import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { situations } from "./situation.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import { firstValues } from "../../src/cycles/first-values.ts";
import { cuttingCycles, cycleByNumber } from "../../src/cycles/index.ts";
import { knownOutline, sameSegment } from "../../src/cycles/known-outline.ts";
import { likelyCompletion } from "../../src/cycles/completions.ts";
import type { Cycle } from "../../src/cycles/define.ts";
import type { Params, Values } from "../../src/cycles/params.ts";

const RUNS = 20;

describe.each(situations(0))("the known contour of cycle $cycle.number", ({ cycle, arbitrary }) => {
  const contourOf = (values: object, given: Parameters<Cycle["outline"]>[1]) => {
    const { contour, issues } = cycle.outline(values as Values<Params>, given);
    return issues.some((i) => i.severity === "error") ? [] : contour;
  };
  test("is complete when all values are typed", () => {
    fc.assert(
      fc.property(arbitrary, ({ values, given }) => {
        const whole = contourOf(values, given);
        // A contour that no cycle can cut is drawn as programmed.
        const drawn = whole.length === 0 && cycle.contour === "free" ? given.contour : whole;
        expect(knownOutline(cycle, values, given).contour).toEqual(drawn);
      }),
      { numRuns: RUNS },
    );
  });
  test("is a part of it while values are missing, and never shrinks with one more value", () => {
    fc.assert(
      fc.property(arbitrary, fc.array(fc.boolean(), { minLength: 40, maxLength: 40 }), fc.nat(39), (s, typed, one) => {
        const few = Object.fromEntries(Object.entries(s.values).filter((_, i) => typed[i]));
        // Only typed values are corrected.
        const corrections = Object.keys(cycle.params).filter(
          (c) => cycle.params[c]?.shown === "depthCompensation" && !(c in few),
        );
        const values = { ...s.values, ...Object.fromEntries(corrections.map((c) => [c, 0])) };
        const whole = contourOf(values, s.given);
        if (whole.length === 0) return;
        const all = Object.entries(values);
        const [q, value] = all[one % all.length] as [string, number];
        const known = knownOutline(cycle, few, s.given).contour;
        const more = knownOutline(cycle, { ...few, [q]: value }, s.given).contour;
        for (const segment of known) {
          expect(
            whole.some((w) => sameSegment(w, segment)),
            JSON.stringify([segment, few]),
          ).toBe(true);
          // Where almost nothing fits any more, nothing is known.
          if (more.length > 0)
            expect(
              more.some((w) => sameSegment(w, segment)),
              JSON.stringify([segment, few, q]),
            ).toBe(true);
        }
      }),
      { numRuns: RUNS },
    );
  });
  test("can be drawn with each additional value", () => {
    const example = firstValues(cycle);
    const given = { contour: null, start: null };
    if (cycle.contour === "free") return;
    Object.keys(example).forEach((_, n) => {
      const few = Object.fromEntries(Object.entries(example).slice(0, n));
      const made = likelyCompletion(cycle, few, given);
      expect(made?.values).toMatchObject(few);
    });
  });
});

describe("a shoulder, value by value", () => {
  const cycle = cycleByNumber(812) as Cycle;
  const of = (values: Record<string, number>) => knownOutline(cycle, values, { contour: null, start: null });
  const box = { Q491: 61.37, Q492: 0.8, Q493: 42.11, Q494: -23.9 };

  test("an arc that falls or rises with the end diameter is unknown until that is typed", () => {
    const start = { Q491: 67.41, Q492: -4.156, Q495: 75, Q496: 0, Q500: 0, Q501: 2, Q502: 0.428 };
    const plunging = cycleByNumber(814) as Cycle,
      given = { contour: null, start: at(-4.148, 33.703) };
    expect(knownOutline(plunging, start, given).contour).toEqual([]);
    expect(knownOutline(plunging, { ...start, Q493: 91.406, Q494: -64.152 }, given).contour[0]).toMatchObject({
      kind: "arc",
    });
  });
  test("a diameter is a position, with its Z it is a point", () => {
    expect(of({ Q491: 61.37 })).toMatchObject({
      positions: [{ q: "Q491", axis: "x", value: 61.37 }],
      corners: [],
      contour: [],
      sketch: [],
    });
    expect(of({ Q491: 61.37, Q492: 0.8 }).corners).toEqual([{ x: 61.37, z: 0.8 }]);
  });
  test("both corners make a sketch with square walls", () => {
    const { sketch, contour, corners, whole } = of(box);
    expect(corners).toHaveLength(2);
    expect(sketch.map(({ from, to }) => [from.z, from.r * 2, to.z, to.r * 2])).toEqual([
      [0.8, 42.11, -23.9, 42.11],
      [-23.9, 42.11, -23.9, 61.37],
    ]);
    expect(contour).toEqual([]);
    expect(whole).toBe(false);
  });
  test("an element is known as soon as no missing value affects it", () => {
    const few = { ...box, Q495: 0, Q501: 1, Q502: 0.7, Q500: 0, Q496: 0 };
    expect(of(few).contour.map((s) => s.to.z.toFixed(3))).toEqual(["0.100", "-23.900"]);
    expect(of({ ...few, Q503: 0 })).toMatchObject({ whole: true, sketch: [] });
    expect(of({ ...few, Q503: 0 }).contour).toHaveLength(3);
  });
});

test("every cycle is tested", () => expect(situations(0).map((s) => s.cycle)).toEqual(cuttingCycles));

test("a programmed contour is drawn even if no cycle can cut it yet", () => {
  const flat = [{ kind: "line" as const, from: at(-3.3, 30.7), to: at(-18.1, 30.7) }];
  expect(knownOutline(cycleByNumber(820) as Cycle, { Q463: 1.35 }, { contour: flat, start: null })).toMatchObject({
    contour: flat,
    whole: false,
  });
});

test("a rounding is unknown while only one side of its corner was tried", () => {
  const few = { Q500: 0.001, Q495: 57, Q496: 0, Q493: 38.626, Q494: -10 };
  expect(knownOutline(cycleByNumber(814) as Cycle, few, { contour: null, start: at(0, 24) }).contour).toEqual([]);
});
