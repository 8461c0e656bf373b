import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { at, part, type Pt } from "../geometry/point.ts";
import { solveContour } from "./solve-contour.ts";
import type { SolveElement } from "./solve-work.ts";
import { axial, degrees, length, radius } from "../units.ts";

type Line = Extract<SolveElement, { kind: "line" }>;
type Arc = Extract<SolveElement, { kind: "arc" }>;
const Z = (n: number) => ({ at: axial(n) });
const R = (n: number) => ({ at: radius(n) });
const line = (given: Partial<Line> = {}): Line => ({
  kind: "line",
  z: null,
  r: null,
  angle: null,
  length: null,
  tangent: false,
  choice: 0,
  ...given,
});
const arc = (given: Partial<Arc> = {}): Arc => ({
  kind: "arc",
  z: null,
  r: null,
  turn: "ccw",
  radius: null,
  centre: null,
  tangent: false,
  choice: 0,
  ...given,
});
const start = (z: number, r: number) => line({ z: Z(z), r: R(r) });
const points = (elements: readonly SolveElement[]) =>
  solveContour(elements).elements.map((e) =>
    [e.z, e.r].map((n) => (n === null ? null : Math.round(n * 1e4) / 1e4 + 0)),
  );
const codes = (elements: readonly SolveElement[]) =>
  solveContour(elements).issues.map((i) => `${i.code} ${"element" in i.data ? i.data.element : ""}`);

describe("lines", () => {
  test("angle and one coordinate: 45° up from (0, 10) to r 20 ends at z 10", () => {
    expect(points([start(0, 10), line({ r: R(20), angle: degrees(45) })])[1]).toEqual([10, 20]);
  });
  test("angle and length", () => {
    expect(points([start(0, 10), line({ angle: degrees(150), length: length(20) })])[1]).toEqual([-17.3205, 20]);
  });
  test("length and one coordinate: 3-4-5, towards the chuck first, the other on request", () => {
    expect(points([start(0, 10), line({ r: R(13), length: length(5) })])[1]).toEqual([-4, 13]);
    const other = solveContour([start(0, 10), line({ r: R(13), length: length(5), choice: 1 })]).elements[1];
    expect([other?.z, other?.choices]).toEqual([4, 2]);
  });
  test("two angles meet: down at 180°, up at 90°", () => {
    expect(
      points([start(0, 10), line({ angle: degrees(180) }), line({ z: Z(-30), r: R(25), angle: degrees(135) })])[1],
    ).toEqual([-15, 10]);
  });
  test("three angles and one coordinate in between are one system", () => {
    const found = points([
      start(0, 10),
      line({ angle: degrees(180) }),
      line({ r: R(20), angle: degrees(135) }),
      line({ z: Z(-40), r: R(20), angle: degrees(180) }),
    ]);
    expect(found[2]?.[1]).toBe(20);
    expect(
      codes([
        start(0, 10),
        line({ angle: degrees(180) }),
        line({ r: R(20), angle: degrees(135) }),
        line({ z: Z(-40), r: R(20), angle: degrees(180) }),
      ]),
    ).toEqual(["elementFree 2"]);
    expect(
      points([
        start(0, 10),
        line({ z: Z(-10), angle: degrees(180) }),
        line({ angle: degrees(135) }),
        line({ z: Z(-40), r: R(20), angle: degrees(180) }),
      ])[2],
    ).toEqual([-20, 20]);
  });
  test("backwards: the start point follows from angle and length of the first line", () => {
    expect(points([line({}), line({ z: Z(-10), r: R(20), angle: degrees(180), length: length(10) })])[0]).toEqual([
      0, 20,
    ]);
  });
  test("two lengths meet: an isosceles triangle over a base of 6 with legs of 5 has the height 4", () => {
    expect(
      points([start(0, 10), line({ length: length(5) }), line({ z: Z(-6), r: R(10), length: length(5) })])[1],
    ).toEqual([-3, 6]);
  });
  test("an incremental coordinate and a tangential line continue the contour", () => {
    expect(
      points([start(0, 10), line({ z: Z(-5), r: R(15) }), line({ r: { by: radius(5) }, tangent: true })])[2],
    ).toEqual([-10, 20]);
  });
});

describe("arcs", () => {
  test("tangential to a line, with radius and one coordinate: a quarter turn", () => {
    expect(
      points([start(0, 10), line({ z: Z(-20), r: R(10) }), arc({ r: R(15), radius: 5, turn: "cw", tangent: true })])[2],
    ).toEqual([-25, 15]);
  });
  test("a line tangential to an arc continues in its direction", () => {
    const found = points([
      start(0, 10),
      line({ z: Z(-20), r: R(10) }),
      arc({ r: R(15), z: Z(-25), radius: 5, turn: "cw", tangent: true }),
      line({ r: R(30), tangent: true }),
    ]);
    expect(found[3]).toEqual([-25, 30]);
  });
  test("a rounding by hand: radius 5 between two lines whose ends are known", () => {
    const found = points([
      start(0, 10),
      line({ angle: degrees(180) }),
      arc({ radius: 5, turn: "cw", tangent: true }),
      line({ z: Z(-30), r: R(30), angle: degrees(90), tangent: true }),
    ]);
    expect(found.slice(1, 3)).toEqual([
      [-25, 10],
      [-30, 15],
    ]);
  });
  test("the tangent from a point to a circle, before and behind the arc", () => {
    // Circle of radius 3 about (-10, 10); from (-5, 10) the tangent has length 4.
    const before = points([
      start(-5, 10),
      line({}),
      arc({ z: Z(-13), r: R(10), centre: at(-10, 10), radius: 3, turn: "ccw", tangent: true }),
    ]);
    expect(before[1]).toEqual([-8.2, 12.4]);
    const after = points([
      start(-13, 10),
      arc({ centre: at(-10, 10), turn: "ccw" }),
      line({ z: Z(-5), r: R(10), tangent: true }),
    ]);
    // counter-clockwise from the left, under the centre, and up to the point: it touches below
    expect(after[1]).toEqual([-8.2, 7.6]);
  });
  test("a line at an angle tangential to a known circle touches it at right angles to the angle", () => {
    expect(
      points([
        start(-13, 10),
        arc({ centre: at(-10, 10), turn: "ccw" }),
        line({ r: R(20), angle: degrees(90), tangent: true }),
      ]).slice(1),
    ).toEqual([
      [-7, 10],
      [-7, 20],
    ]);
  });
  test("by centre and one coordinate the shorter arc, on request the longer", () => {
    const given = { centre: at(-10, 10), r: R(10), turn: "ccw" as const };
    expect(points([start(-10, 7), arc(given)])[1]).toEqual([-7, 10]);
    expect(points([start(-10, 7), arc({ ...given, choice: 1 })])[1]).toEqual([-13, 10]);
  });
  test("two arcs that touch: an S of radius 5 and 5", () => {
    const found = points([
      start(0, 10),
      line({ z: Z(-10), r: R(10) }),
      arc({ radius: 5, turn: "cw", tangent: true }),
      arc({ centre: at(-20, 15), radius: 5, turn: "ccw", z: Z(-20), r: R(20), tangent: true }),
    ]);
    expect(found[2]).toEqual([-15, 15]);
  });
  test("radius of a tangential arc follows from its end", () => {
    const made = solveContour([
      start(0, 10),
      line({ z: Z(-20), r: R(10) }),
      arc({ z: Z(-25), r: R(15), turn: null, tangent: true }),
    ]).elements[2]?.segment;
    expect(made?.kind === "arc" && [made.centre.z, made.centre.r, made.turn]).toEqual([-20, 15, "cw"]);
  });
});

describe("undetermined and contradicting elements", () => {
  test("degrees of freedom are counted per element", () => {
    const free = (elements: readonly SolveElement[]) => solveContour(elements).elements.map((e) => e.freedom);
    expect(free([start(0, 10), line({ angle: degrees(180) })])).toEqual([0, 1]);
    expect(free([start(0, 10), line()])).toEqual([0, 2]);
    expect(free([start(0, 10), line({ r: R(20) })])).toEqual([0, 1]);
    expect(free([start(0, 10), line({ length: length(10) })])).toEqual([0, 1]);
    expect(free([start(0, 10), arc({ centre: at(0, 15) })])).toEqual([0, 1]);
    expect(free([start(0, 10), arc({ z: Z(-5), r: R(15) })])).toEqual([0, 1]);
  });
  test("an impossible angle, length, radius or transition is reported with the nearest possible one", () => {
    expect(codes([start(0, 10), line({ z: Z(-10), r: R(20), angle: degrees(130) })])).toEqual(["elementContradicts 2"]);
    expect(codes([start(0, 10), line({ z: Z(-10), r: R(10), angle: degrees(0) })])).toEqual(["elementContradicts 2"]);
    expect(codes([start(0, 10), line({ z: Z(-3), r: R(14), length: length(6) })])).toEqual(["elementContradicts 2"]);
    expect(codes([start(0, 10), line({ r: R(20), length: length(6) })])).toEqual(["elementUnreachable 2"]);
    expect(codes([start(0, 10), line({ z: Z(-10), r: R(10) }), line({ z: Z(-10), r: R(20), tangent: true })])).toEqual([
      "elementContradicts 3",
    ]);
    expect(codes([start(0, 10), line({ z: Z(-3), r: R(14), length: length(5), angle: degrees(126.87) })])).toEqual([]);
  });
});

/** Random determined contours, with corners no sharper than can be distinguished. */
const corner = fc.record({ z: fc.integer({ min: -40, max: 40 }), r: fc.integer({ min: 1, max: 60 }) });
const contours = fc
  .array(corner, { minLength: 3, maxLength: 12 })
  .filter((all) =>
    all.every((p, i) => i === 0 || Math.hypot(p.z - (all[i - 1]?.z ?? 0), p.r - (all[i - 1]?.r ?? 0)) > 1),
  )
  .map((all) => all.map((p) => at(p.z, p.r)));
const angleOf = (a: Pt, b: Pt) => degrees((Math.atan2(b.r - a.r, b.z - a.z) * 180) / Math.PI);
const near = (found: ReturnType<typeof solveContour>, wanted: readonly Pt[]) =>
  found.elements.every(
    (e, i) => Math.hypot((e.z ?? NaN) - (wanted[i]?.z ?? 0), (e.r ?? NaN) - (wanted[i]?.r ?? 0)) < 1e-5,
  );

describe("laws", () => {
  test("replacing a coordinate by an angle gives the same point", () => {
    fc.assert(
      fc.property(
        contours,
        fc.array(fc.constantFrom("z", "r", "none"), { minLength: 12, maxLength: 12 }),
        (wanted, erased) => {
          const given = wanted.map((p, i): SolveElement => {
            const before = wanted[i - 1];
            if (!before) return start(p.z, p.r);
            const [dz, dr] = [Math.abs(p.z - before.z), Math.abs(p.r - before.r)];
            const drop = erased[i] === "z" && dr > 0.5 ? "z" : erased[i] === "r" && dz > 0.5 ? "r" : "none";
            return line({
              z: drop === "z" ? null : Z(p.z),
              r: drop === "r" ? null : R(p.r),
              angle: drop === "none" ? null : angleOf(before, p),
            });
          });
          const found = solveContour(given);
          expect(found.issues).toEqual([]);
          expect(near(found, wanted)).toBe(true);
        },
      ),
      { numRuns: 500 },
    );
  });

  test("every second point is recovered from the angles on both sides", () => {
    fc.assert(
      fc.property(contours, (wanted) => {
        const given = wanted.map((p, i): SolveElement => {
          const [before, after] = [wanted[i - 1], wanted[i + 1]];
          if (!before) return start(p.z, p.r);
          const gone =
            i % 2 === 1 &&
            after &&
            Math.abs(Math.sin(((angleOf(before, p) - angleOf(p, after)) * Math.PI) / 180)) > 0.05;
          return line({ z: gone ? null : Z(p.z), r: gone ? null : R(p.r), angle: angleOf(before, p) });
        });
        expect(near(solveContour(given), wanted)).toBe(true);
      }),
      { numRuns: 500 },
    );
  });

  test("all coordinates but the first replaced by angle and length", () => {
    fc.assert(
      fc.property(contours, (wanted) => {
        const given = wanted.map((p, i): SolveElement => {
          const before = wanted[i - 1];
          return before
            ? line({ angle: angleOf(before, p), length: length(Math.hypot(p.z - before.z, p.r - before.r)) })
            : start(p.z, p.r);
        });
        expect(near(solveContour(given), wanted)).toBe(true);
      }),
      { numRuns: 500 },
    );
  });

  test("one of the two solutions of a length or a circle is the removed point", () => {
    fc.assert(
      fc.property(
        corner,
        corner,
        fc.integer({ min: 1, max: 80 }),
        fc.boolean(),
        fc.boolean(),
        (a, b, extra, straight, z) => {
          const [from, to] = [at(a.z, a.r), at(b.z, b.r)];
          const far = Math.hypot(to.z - from.z, to.r - from.r);
          fc.pre(far > 1);
          const made = part.arcByRadius(from, to, far / 2 + extra, "cw").segment;
          const erase = z ? { z: null, r: R(to.r) } : { z: Z(to.z), r: null };
          const found = ([0, 1] as const).map((choice) =>
            solveContour([
              start(from.z, from.r),
              straight || made?.kind !== "arc"
                ? line({ ...erase, length: length(far), choice })
                : arc({ ...erase, centre: made.centre, turn: "cw", choice }),
            ]),
          );
          expect(found.some((f) => near(f, [from, to]))).toBe(true);
        },
      ),
      { numRuns: 500 },
    );
  });

  test("any input ends without an exception and without NaN", () => {
    const maybe = <T>(some: fc.Arbitrary<T>) => fc.option(some, { nil: null });
    const number = fc.oneof(fc.integer({ min: -50, max: 50 }), fc.double({ min: -1e4, max: 1e4, noNaN: true }));
    const any = fc.oneof(
      fc
        .record({
          z: maybe(number),
          r: maybe(number),
          angle: maybe(number),
          length: maybe(number),
          tangent: fc.boolean(),
          choice: fc.constantFrom(0 as const, 1 as const),
        })
        .map((e) =>
          line({
            ...e,
            z: e.z === null ? null : Z(e.z),
            r: e.r === null ? null : R(e.r),
            angle: e.angle === null ? null : degrees(e.angle),
            length: e.length === null ? null : length(e.length),
          }),
        ),
      fc
        .record({
          z: maybe(number),
          r: maybe(number),
          turn: maybe(fc.constantFrom("cw" as const, "ccw" as const)),
          radius: maybe(number),
          centre: maybe(corner),
          tangent: fc.boolean(),
        })
        .map((e) =>
          arc({
            ...e,
            z: e.z === null ? null : Z(e.z),
            r: e.r === null ? null : R(e.r),
            centre: e.centre && at(e.centre.z, e.centre.r),
          }),
        ),
    );
    fc.assert(
      fc.property(fc.array(any, { maxLength: 30 }), (elements) => {
        const found = solveContour(elements);
        expect(found.elements).toHaveLength(elements.length);
        for (const e of found.elements)
          for (const n of [e.z, e.r, e.angle, e.length]) expect(n === null || Number.isFinite(n)).toBe(true);
      }),
      { numRuns: 400 },
    );
  });

  test("a contour of 1,000 elements with angles is solved", () => {
    const elements = Array.from({ length: 1000 }, (_, i) =>
      i === 0 ? start(0, 10) : line({ angle: degrees(i % 2 ? 180 : 90), length: length(1) }),
    );
    expect(solveContour(elements).elements.at(-1)?.z).toBeCloseTo(-500, 6);
  });
});
