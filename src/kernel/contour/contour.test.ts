import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { chainOf, contourFrom, withCorners, type ContourElement } from "./contour.ts";
import { part, type Pt, type Segment } from "../geometry/point.ts";
import { axial, radius } from "../units.ts";

const { direction, lengthOf } = part;

const p = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const shape = (segments: readonly Segment[]) =>
  segments.map((s) => `${s.kind === "line" ? "line" : s.turn} ${s.to.z.toFixed(3)} ${s.to.r.toFixed(3)}`);
const codes = (c: { issues: readonly { code: string }[] }) => c.issues.map((i) => i.code);

describe("corner elements", () => {
  test("a chamfer takes a leg of its size on each line", () => {
    const c = withCorners(chainOf([p(0, 10), p(-20, 10), p(-20, 30)]), [{ kind: "chamfer", size: 3 }]);
    expect(shape(c.segments)).toEqual(["line -17.000 10.000", "line -20.000 13.000", "line -20.000 30.000"]);
  });
  test("a rounding in a right angle has legs of its radius", () => {
    const c = withCorners(chainOf([p(0, 10), p(-20, 10), p(-20, 30)]), [{ kind: "round", size: 3 }]);
    expect(shape(c.segments)).toEqual(["line -17.000 10.000", "cw -20.000 13.000", "line -20.000 30.000"]);
  });
  test("too large: nothing is cut and the largest value is named", () => {
    const c = withCorners(chainOf([p(0, 10), p(-20, 10), p(-20, 15)]), [{ kind: "round", size: 6 }]);
    expect(c.segments).toHaveLength(2);
    expect(c.issues[0]).toMatchObject({
      code: "cornerElementTooLong",
      data: { element: 1, size: 6, max: expect.closeTo(5, 3) },
    });
  });
  test("two corners share the length of their common line", () => {
    const chain = chainOf([p(0, 10), p(-20, 10), p(-20, 15), p(-40, 15)]);
    expect(
      codes(
        withCorners(chain, [
          { kind: "round", size: 2 },
          { kind: "round", size: 3 },
        ]),
      ),
    ).toEqual([]);
    const over = withCorners(chain, [
      { kind: "round", size: 2 },
      { kind: "round", size: 3.5 },
    ]);
    expect(over.issues[0]).toMatchObject({ data: { element: 2, max: expect.closeTo(3, 3) } });
  });
  test("an element too short to have a direction leaves no gap", () => {
    const flat = chainOf([p(0, 47.2), p(-0.002, 53.058), p(-9, 60)]);
    const { segments } = withCorners(
      [chainOf([p(0, 35), p(0, 47.2)])[0] as Segment, ...flat],
      [{ kind: "round", size: 0.25 }],
    );
    expect(segments).toHaveLength(3);
    segments.slice(1).forEach((s, i) => expect(s.from).toEqual(segments[i]?.to));
    const arcs: Segment[] = [
      { kind: "arc", from: p(0, 20), to: p(-5, 25), centre: p(0, 25), turn: "cw" },
      {
        kind: "arc",
        from: p(-5.000_05, 25),
        to: p(-10, 20),
        centre: p(-10, 25),
        turn: "ccw",
      },
    ];
    const [one, two] = arcs as [Segment, Segment];
    const closed = withCorners([one, { kind: "line", from: one.to, to: two.from }, two], []).segments;
    closed.slice(1).forEach((s, i) => expect(part.apart(s.from, closed[i]?.to as Pt)).toBeLessThan(1e-9));
  });
  test("a tangential transition needs no rounding", () => {
    expect(withCorners(chainOf([p(0, 10), p(-20, 10), p(-30, 10)]), [{ kind: "round", size: 3 }])).toMatchObject({
      issues: [],
    });
  });
});

describe("programmed contours", () => {
  test("the printed contour: two roundings between lines", () => {
    const c = contourFrom([
      { kind: "line", to: p(-20, 37.5) },
      { kind: "line", to: p(-20, 25) },
      { kind: "round", size: 2 },
      {
        kind: "line",
        to: p(-25, 10),
      },
      { kind: "round", size: 2 },
      { kind: "line", to: p(0, 10) },
    ]);
    expect(codes(c)).toEqual([]);
    expect(c.elements).toEqual([2, 3, 4, 5, 6]);
    expect(c.segments.map((s) => s.kind)).toEqual(["line", "arc", "line", "arc", "line"]);
  });
  test("CR takes the shorter arc, and the longer one with a negative radius", () => {
    const arc = (r: number) =>
      contourFrom([
        { kind: "line", to: p(0, 10) },
        { kind: "radius", to: p(-10, 20), radius: r, turn: "ccw" },
      ]).segments[0];
    expect(lengthOf(arc(10) as Segment)).toBeCloseTo(5 * Math.PI, 9);
    expect(lengthOf(arc(-10) as Segment)).toBeCloseTo(15 * Math.PI, 9);
  });
  test("a radius too small to span its points is reported with the smallest possible one", () => {
    const c = contourFrom([
      { kind: "line", to: p(0, 10) },
      { kind: "radius", to: p(-10, 10), radius: 4, turn: "cw" },
    ]);
    expect(c.issues[0]).toMatchObject({ code: "arcTooSmall", data: { element: 2, radius: 4 } });
  });
  test("the end of an arc may miss its circle by 0.016", () => {
    const c = (r: number) =>
      codes(
        contourFrom([
          { kind: "line", to: p(0, 10) },
          { kind: "centre", to: p(-10, r), centre: p(-10, 10), turn: "cw" },
        ]),
      );
    expect(c(20.015)).toEqual([]);
    expect(c(20.02)).toEqual(["arcOffCircle"]);
  });
  test("corner elements need a neighbour on both sides", () => {
    expect(
      codes(
        contourFrom([
          { kind: "round", size: 1 },
          { kind: "line", to: p(0, 10) },
          { kind: "line", to: p(-5, 10) },
          {
            kind: "chamfer",
            size: 1,
          },
        ]),
      ),
    ).toEqual(["cornerElementAlone", "cornerElementAlone"]);
  });
  test("a contour that crosses or meets itself names both elements; one that closes does not", () => {
    const lines = (...points: Pt[]) => contourFrom(points.map((to) => ({ kind: "line", to }))).issues;
    expect(lines(p(0, 0), p(-20, 0), p(-20, 10), p(-10, -5))[0]).toMatchObject({
      code: "contourCrossesItself",
      data: { element: 4, other: 2 },
    });
    expect(lines(p(0, 0), p(-20, 0), p(-20, 10), p(-10, 0))).toHaveLength(1);
    expect(lines(p(0, 0), p(-20, 0), p(-20, 10), p(0, 0))).toEqual([]);
    const arc = contourFrom([
      { kind: "line", to: p(0, 10) },
      { kind: "radius", to: p(-20, 10), radius: 10, turn: "ccw" },
      {
        kind: "line",
        to: p(-20, 15),
      },
      { kind: "line", to: p(0, 15) },
    ]);
    expect(arc.issues[0]).toMatchObject({ code: "contourCrossesItself", data: { element: 4, other: 2 } });
  });
  test("a tangential arc follows the element before it", () => {
    const c = contourFrom([
      { kind: "line", to: p(0, 10) },
      { kind: "line", to: p(-10, 10) },
      { kind: "tangent", to: p(-20, 20) },
    ]);
    expect(c.segments[1]).toMatchObject({ kind: "arc", turn: "cw", centre: p(-10, 20) });
  });
});

const point = fc
  .record({ z: fc.integer({ min: -100, max: 100 }), r: fc.integer({ min: 0, max: 100 }) })
  .map((q) => p(q.z, q.r));
const element: fc.Arbitrary<ContourElement> = fc.oneof(
  point.map((to): ContourElement => ({ kind: "line", to })),
  fc
    .record({ to: point, radius: fc.integer({ min: -80, max: 80 }), turn: fc.constantFrom("cw", "ccw") })
    .map((a): ContourElement => ({
      kind: "radius",
      ...a,
    })),
  point.map((to): ContourElement => ({ kind: "tangent", to })),
  fc.record({ kind: fc.constantFrom("round", "chamfer"), size: fc.double({ min: 0.01, max: 20, noNaN: true }) }),
);

test("every contour is one chain, its roundings are tangential on both sides", () => {
  fc.assert(
    fc.property(fc.array(element, { maxLength: 12 }), (elements) => {
      const c = contourFrom(elements);
      c.segments.forEach((s, i) => {
        expect(Number.isFinite(s.to.z + s.to.r + lengthOf(s))).toBe(true);
        const next = c.segments[i + 1];
        if (!next) return;
        expect(Math.hypot(next.from.z - s.to.z, next.from.r - s.to.r)).toBeLessThan(1e-9);
        const roundings = [s, next].map((_, k) => elements[(c.elements[i + k] ?? 0) - 1]?.kind);
        if (!roundings.includes("round")) return;
        const [a, b] = [direction(s, s.to), direction(next, next.from)];
        expect(Math.abs(a.z * b.r - a.r * b.z)).toBeLessThan(1e-6);
      });
    }),
    { numRuns: 2000 },
  );
});
