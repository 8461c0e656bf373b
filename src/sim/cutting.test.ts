import fc from "fast-check";
import { expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import { difference } from "../kernel/area/clip.ts";
import type { Move } from "../kernel/plan/move.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { axial, feed, length, radius } from "../kernel/units.ts";
import { cutting } from "./cutting.ts";
import { outlinesOf } from "./outlines.ts";
import { sweepOf, sweptBy } from "./sweep.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const mm = (least: number, most: number) => fc.integer({ min: least * 1000, max: most * 1000 }).map((n) => n / 1000);
const tool: Tool = { T: 11, NAME: "BUTTON-3", TYPE: "BUTTON", TO: 2, RS: length(1.5) };
const blank: Ring = [at(-50, 0), at(0, 0), at(0, 30), at(-50, 30)];
const { insert } = outlinesOf()(tool);
/** With a level edge at its tip. */
const blade: Tool = { T: 10, NAME: "OD-RECESS-2", TYPE: "RECESS", TO: 8, RS: length(0.1), CUTWIDTH: length(2) };
const stepsThrough = (points: readonly (readonly [number, number])[]): Step[] =>
  points.slice(1).map(([z, r], i): Step => {
    const move: Move = {
      kind: "feed",
      to: at(z, r),
      feed: feed(0.2),
      feedUnit: "mm/rev",
      phase: "rough",
      run: "rough",
      step: 1,
    };
    return { from: at(...(points[i] as [number, number])), move, tool, block: i, operation: null, seconds: 1 };
  });
const ways = fc.array(fc.tuple(mm(-55, 5), mm(-4, 36)), { minLength: 2, maxLength: 40 });

test("a stock recomputed again and again is the blank less all sweeps, to rounding", () => {
  fc.assert(
    fc.property(ways, (points) => {
      const steps = stepsThrough(points);
      const cut = cutting([blank]);
      steps.forEach((s) => cut.add(sweptBy(insert, s)));
      const once = difference(
        [blank],
        steps.flatMap((s) => sweepOf(insert, s)),
      );
      const { base, gone } = cut.present();
      for (const stock of [cut.stock(), difference(base, gone)])
        expect(areaOf(difference(once, stock)) + areaOf(difference(stock, once))).toBeLessThan(0.02);
    }),
    { numRuns: 60 },
  );
});

test("ways that run level, steep and back over themselves take what their moves take one by one", () => {
  const edge = outlinesOf()(blade).insert;
  const spots = fc.array(fc.tuple(mm(-45, 15), fc.constantFrom(4, 4.5, 7.25)), { minLength: 3, maxLength: 16 });
  fc.assert(
    fc.property(spots, (points) => {
      const cut = cutting([blank]);
      let stock: readonly Ring[] = [blank];
      for (const s of stepsThrough(points)) {
        cut.add(sweptBy(edge, s));
        stock = difference(stock, sweepOf(edge, s));
      }
      expect(areaOf(cut.stock())).toBeCloseTo(areaOf(stock), 1);
    }),
    { numRuns: 60 },
  );
});

test("a stock is the same to the bit where the outlines come from another run, as after an edit", () => {
  const other = outlinesOf()(tool).insert;
  fc.assert(
    fc.property(ways, (points) => {
      const [one, two] = [cutting([blank]), cutting([blank])];
      stepsThrough(points).forEach((s, i) => {
        one.add(sweptBy(insert, s));
        two.add(sweptBy(i % 2 ? insert : other, s));
      });
      expect(two.stock()).toEqual(one.stock());
    }),
    { numRuns: 20 },
  );
});

test("queries in between do not change the stock by a bit, nor earlier results", () => {
  fc.assert(
    fc.property(ways, (points) => {
      const [quiet, asked] = [cutting([blank]), cutting([blank])];
      const given: [() => readonly Ring[], string][] = [];
      for (const s of stepsThrough(points)) {
        quiet.add(sweptBy(insert, s));
        const now = asked.present();
        given.push([() => difference(now.base, now.gone), JSON.stringify(difference(now.base, now.gone))]);
        asked.stock(sweptBy(insert, s, 0.5));
        asked.add(sweptBy(insert, s));
      }
      expect(asked.stock()).toEqual(quiet.stock());
      for (const [again, before] of given) expect(JSON.stringify(again())).toBe(before);
    }),
    { numRuns: 30 },
  );
});
