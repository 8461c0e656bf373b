import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaBeyond } from "../../src/course/judge/difference.ts";
import { targetPart } from "../../src/course/target-part.ts";
import { areaOf } from "../../src/kernel/area/area.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import "../seed.ts";
import { blankLine, judged, mm, NOSE, programOf, refusedBy, shoulders, sumOf, taskOf } from "./hand-turned.ts";

/*
 * Results of the judge, calculated by hand: a shoulder that is too thin is missing a band of its length, and a step
 * that was left is a band of its depth. Where a nose rounds the corner, both parts have the same rounding.
 */
const RUNS = Number(process.env["LAW_CASES"] ?? 12);
/** Tolerance for a band of some length, mm²: chords, and slivers that the judge ignores. */
const near = (area: number, length: number) => [area - 0.006 * length - 0.01, area + 0.006 * length + 0.01] as const;

const law = <T>(arbitrary: fc.Arbitrary<T>, holds: (value: T) => void) =>
  fc.assert(fc.property(arbitrary, holds), { numRuns: RUNS });

describe("a shoulder", () => {
  test("passes as it is drawn, in millimetres and in inches", () =>
    law(shoulders, (s) => {
      expect(refusedBy(judged(taskOf(s), programOf(s)))).toEqual([]);
      expect(refusedBy(judged(taskOf(s), programOf(s, { unit: "INCH" })))).toEqual([]);
    }));

  test("passes in any way: in two passes, face first, with parameters", () =>
    law(shoulders, (s) => {
      const middle = Math.round((s.outer + s.diameter) * 500) / 1000;
      const two = [
        `7 L X${middle} FMAX`,
        `7 L Z-${s.length} F0.3`,
        `7 L X${s.outer + 2}`,
        "7 L Z2 FMAX",
        `7 L X${s.diameter} FMAX`,
        `7 L Z-${s.length} F0.2`,
        `8 L X${s.outer + 2}`,
      ];
      const counted = [
        "7 Q5 = 0",
        `7 Q6 = ${s.length}`,
        "7 L IZ-2 F0.2",
        "7 Q7 = Q5 - Q6",
        "7 L Z+Q7",
        `8 L IX+${s.outer + 2 - s.diameter}`,
      ];
      expect(refusedBy(judged(taskOf(s), programOf(s, { cuts: two })))).toEqual([]);
      expect(refusedBy(judged(taskOf(s), programOf(s, { cuts: counted })))).toEqual([]);
    }));

  test("that is thinner is missing a band of its length, cut there by block 7", () =>
    law(fc.tuple(shoulders, mm(0.02, 0.6)), ([s, deeper]) => {
      for (const unit of ["MM", "INCH"] as const) {
        const found = judged(taskOf(s), programOf({ ...s, diameter: s.diameter - 2 * deeper }, { unit }));
        expect(refusedBy(found)).toEqual(["missing"]);
        const [least, most] = near(deeper * s.length, s.length);
        expect(sumOf(found, "missing")).toBeGreaterThan(least);
        expect(sumOf(found, "missing")).toBeLessThan(most);
        const [first] = found.marks.filter((m) => m.rule === "missing");
        expect(first?.block).toBe(7);
        expect(first?.place?.z).toBeLessThan(0);
        expect(first?.place?.z).toBeGreaterThan(-s.length);
        expect(first?.place?.r).toBeLessThan(s.diameter / 2 + NOSE);
        expect(first?.place?.r).toBeGreaterThan(s.diameter / 2 - deeper - 0.001);
      }
    }));

  test("that is shorter has residue of its step", () =>
    law(fc.tuple(shoulders, mm(0.05, 3)), ([s, shorter]) => {
      const found = judged(taskOf(s), programOf({ ...s, length: s.length - shorter }, { blank: blankLine(s) }));
      expect(refusedBy(found)).toEqual(["residue"]);
      const deep = (s.outer - s.diameter) / 2;
      const [least, most] = near(deep * shorter, deep);
      expect(sumOf(found, "residue")).toBeGreaterThan(least);
      expect(sumOf(found, "residue")).toBeLessThan(most);
      const [first] = found.marks.filter((m) => m.rule === "residue");
      expect(Math.abs((first?.place?.z ?? 0) + s.length - shorter / 2)).toBeLessThan(shorter / 2 + NOSE);
      expect(first?.operation).toBeUndefined();
    }));

  test("that is longer is missing the band behind it, cut by the first block there", () =>
    law(fc.tuple(shoulders, mm(0.05, 3)), ([s, longer]) => {
      const found = judged(taskOf(s), programOf({ ...s, length: s.length + longer }, { blank: blankLine(s) }));
      expect(refusedBy(found)).toEqual(["missing"]);
      const deep = (s.outer - s.diameter) / 2;
      const [least, most] = near(deep * longer, deep);
      expect(sumOf(found, "missing")).toBeGreaterThan(least);
      expect(sumOf(found, "missing")).toBeLessThan(most);
      expect(found.marks.find((m) => m.rule === "missing")?.block).toBe(7);
    }));

  test("drawn sharp may keep the nose radius in its corner", () =>
    law(shoulders, (s) => {
      const sharp = taskOf(s);
      const part = {
        ...sharp.part,
        blank: [blankLine(s)],
        outside: ["L X+0 Z+0", `L X${s.diameter}`, `L Z-${s.length}`, `L X${s.outer}`],
      };
      const found = judged({ ...sharp, part }, programOf(s));
      expect(refusedBy(found)).toEqual(["residue"]);
      expect(Math.abs(sumOf(found, "residue") - NOSE * NOSE * (1 - Math.PI / 4))).toBeLessThan(0.01);
      expect(refusedBy(judged({ ...sharp, part, rules: { residue: 0.16 } }, programOf(s)))).toEqual([]);
    }));

  test("reached by a rapid through material is refused although the part is right", () =>
    law(shoulders, (s) => {
      const cuts = [`7 L Z-${(s.length / 2).toFixed(3)} FMAX`, `7 L Z-${s.length} F0.2`, `8 L X${s.outer + 2}`];
      const found = judged(taskOf(s), programOf(s, { cuts }));
      expect(refusedBy(found)).toEqual(["rapid"]);
      const [first] = found.marks.filter((m) => m.rule === "rapid");
      expect(first?.block).toBe(7);
      expect(Math.abs((first?.value ?? 0) - ((s.outer - s.diameter) / 2) * (s.length / 2))).toBeLessThan(
        2 * NOSE + 0.1 * s.length,
      );
    }));

  test("stated as the blank is no answer, nor is another bar or an empty program", () =>
    law(shoulders, (s) => {
      const finished = "BLK FORM ROTATION Z DIM_D LBL 1";
      const contour = [
        "10 LBL 1",
        "10 L X+0 Z+0",
        `10 L X${s.diameter}`,
        `10 L Z-${s.length}`,
        "10 RND R0.8",
        `10 L X${s.outer}`,
        `10 L Z-${(s.length + 31.7).toFixed(3)}`,
        "10 L X+0",
        "10 LBL 0",
      ];
      const stated = programOf(s, { blank: finished }).replace("11 END", [...contour, "11 END"].join("\n"));
      expect(refusedBy(judged(taskOf(s, { rules: { residue: 1 } }), stated))).toEqual(["blank"]);
      expect(refusedBy(judged(taskOf(s), programOf({ ...s, outer: s.outer + 0.5 })))).toContain("blank");
      expect(judged(taskOf(s), "0 BEGIN PGM N MM\n1 END PGM N MM").passed).toBe(false);
      expect(judged(taskOf(s), "").passed).toBe(false);
    }));
});

/** Steps as diameters with the Z where each ends, one after the other. */
const stairs = fc.array(fc.tuple(mm(6, 58), mm(0.7, 9)), { minLength: 1, maxLength: 7 });
type Stairs = readonly (readonly [diameter: number, length: number])[];

const ends = (steps: Stairs) => steps.map((_, i) => steps.slice(0, i + 1).reduce((sum, [, length]) => sum - length, 0));
const radiusAt = (steps: Stairs, z: number, blank: number) => {
  const i = ends(steps).findIndex((end) => z > end);
  return (i < 0 ? blank : (steps[i]?.[0] ?? blank)) / 2;
};
const D = 61.7,
  BACK = -88;
const lines = (steps: Stairs) => {
  const end = ends(steps);
  return ["L X+0 Z+0", ...steps.flatMap(([d], i) => [`L X${d}`, `L Z${end[i]?.toFixed(3)}`]), `L X${D}`];
};

describe("areas", () => {
  test("of two stairs are those of their strips, whichever protrudes", () =>
    fc.assert(
      fc.property(stairs, stairs, (one, other) => {
        const blank = [`BLK FORM CYLINDER Z D${D} L${-BACK + 1} DIST+1`];
        const [a, b] = [one, other].map((steps) => targetPart({ blank, outside: lines(steps) }).rings);
        const cuts = [...new Set([0, ...ends(one), ...ends(other)])].sort((p, q) => q - p);
        let [out, back] = [0, 0];
        cuts.slice(1).forEach((z, i) => {
          const wide = (cuts[i] ?? 0) - z,
            middle = (z + (cuts[i] ?? 0)) / 2;
          const gap = radiusAt(one, middle, D) - radiusAt(other, middle, D);
          if (gap > 0) out += gap * wide;
          else back -= gap * wide;
        });
        // Strips thinner than a sliver do not count.
        expect(Math.abs(areaOf(areaBeyond(a ?? [], b ?? [])) - out)).toBeLessThan(0.01 * 40 + 0.02);
        expect(Math.abs(areaOf(areaBeyond(b ?? [], a ?? [])) - back)).toBeLessThan(0.01 * 40 + 0.02);
      }),
      { numRuns: 60 },
    ));

  test("of a bore: the blank behind it is unmachined, solid or hollow", () =>
    fc.assert(
      fc.property(mm(12, 30), mm(2, 9), mm(5, 40), fc.boolean(), (d, hollow, deep, isTube) => {
        const blank = [`BLK FORM CYLINDER Z D${D} L90 DIST+1.5${isTube ? ` DI${hollow}` : ""}`];
        const bore = [`L X${d} Z+0`, `L Z-${deep}`, `L X${isTube ? hollow : 0}`];
        const hole = isTube ? hollow / 2 : 0;
        const whole = (D / 2 - hole) * 90;
        const faced = targetPart({ blank, outside: ["L X+0 Z+0", `L X${D}`], bore }).rings;
        expect(areaOf(faced)).toBeCloseTo(whole - (D / 2 - hole) * 1.5 - (d / 2 - hole) * deep, 2);
        const bored = targetPart({ blank, bore }).rings;
        expect(areaOf(bored)).toBeCloseTo(whole - (d / 2 - hole) * (deep + 1.5), 2);
      }),
      { numRuns: 30 },
    ));

  test("of an outline that runs back on itself do not touch the neck behind the last point", () => {
    const blank = [`BLK FORM CYLINDER Z D60 L90 DIST+0`];
    // A collar of 7.3 mm, and a neck of ⌀31.4 from Z-20 that extends 4 mm behind the start of the unmachined blank.
    const rings = targetPart({
      blank,
      outside: ["L X+0 Z+0", "L X+48.6", "L Z-7.3", "L X+31.4", "L Z-24", "L X+60 Z-20"],
    }).rings;
    const gone = (30 - 24.3) * 7.3 + (30 - 15.7) * (20 - 7.3) + ((30 - 15.7) * 4) / 2;
    expect(areaOf(rings)).toBeCloseTo(30 * 90 - gone, 2);
    expect(rings.flat().some((p) => p.z > -24.001 && p.z < -23.999 && Math.abs(p.r - at(0, 15.7).r) < 0.01)).toBe(true);
  });
});
