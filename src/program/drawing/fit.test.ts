import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { FIT, fitted, plainCurve } from "./fit.ts";
import { interpolated, splineOf, splinePoint } from "./splines.ts";
import type { Curve3, V3 } from "./space.ts";

const coordinate = fc.integer({ min: -500, max: 500 }).map((n) => n / 10);
const point = fc.tuple(coordinate, coordinate).map(([x, y]): V3 => [x, y, 0]);
const distance = (made: readonly Segment[], p: Pt) => Math.min(...made.map((s) => part.distanceTo(s, p)));
/** Whether consecutive curves meet. */
const gaps = (made: readonly Segment[]) => made.slice(1).map((s, i) => part.apart(made[i]?.to ?? s.from, s.from));

describe("curves as arcs and lines", () => {
  test("splines of any control points stay within the tolerance, from end to end", () => {
    fc.assert(
      fc.property(fc.array(point, { minLength: 4, maxLength: 9 }), (points) => {
        const [spline] = splineOf(3, [], points, []) ?? [];
        if (!spline) return;
        const made = plainCurve(spline).segments,
          end = points.length - 3;
        expect(Math.max(0, ...gaps(made))).toBeLessThan(1e-6);
        for (let i = 0; i <= 200; i += 1) {
          const [x, y] = splinePoint(spline, (end * i) / 200);
          expect(distance(made, at(x, y))).toBeLessThan(2 * FIT);
        }
      }),
      { numRuns: 20 },
    );
  });

  test("arcs of ellipses stay within the tolerance with few arcs", () => {
    const half: Curve3 = { kind: "conic", centre: [0, 0, 0], u: [30, 0, 0], v: [0, 10, 0], start: 0, end: Math.PI };
    const made = plainCurve(half).segments;
    expect(made.length).toBeLessThan(30);
    for (let i = 0; i <= 100; i += 1) {
      const t = (Math.PI * i) / 100;
      expect(distance(made, at(30 * Math.cos(t), 10 * Math.sin(t)))).toBeLessThan(1.2 * FIT);
    }
  });

  test.each([
    ["circle by equal, upright axes", [4, 0, 0], [0, 4, 0], 1],
    ["circle seen from behind", [4, 0, 0], [0, -4, 0], 1],
    ["circle by oblique axes of equal length that are not upright: an ellipse", [4, 0, 0], [2.4, 3.2, 0], 2],
    ["circle seen from its edge: a line", [4, 0, 0], [0, 0, 4], 1],
  ] as const)("%s", (_, u, v, least) => {
    const { segments, isFitted } = plainCurve({ kind: "conic", centre: [0, 0, 0], u, v, start: 0, end: Math.PI / 2 });
    expect(segments.length).toBeGreaterThanOrEqual(least);
    expect(isFitted).toBe(least > 1);
  });

  test("a rational quarter circle is one arc", () => {
    const [spline] = splineOf(2, [0, 0, 0, 1, 1, 1], [[4, 0, 0], [4, 4, 0], [0, 4, 0]], [1, Math.SQRT1_2, 1]) ?? []; // oxfmt-ignore
    const made = spline ? plainCurve(spline).segments : [];
    expect(made).toHaveLength(1);
    expect(made[0]).toMatchObject({ kind: "arc", turn: "ccw" });
  });

  test("a corner within a spline stays a corner", () => {
    const [spline] = splineOf(2, [0, 0, 0, 1, 1, 2, 2, 2], [[0, 0, 0], [5, 0, 0], [10, 0, 0], [10, 5, 0], [10, 10, 0]], []) ?? []; // oxfmt-ignore
    expect(spline && plainCurve(spline).segments).toEqual([
      part.line(at(0, 0), at(10, 0)),
      part.line(at(10, 0), at(10, 10)),
    ]);
  });

  test("fit points: the curve goes through each, closed ones without a seam", () => {
    const through: V3[] = [[10, 0, 0], [0, 10, 0], [-10, 0, 0], [0, -10, 0]]; // oxfmt-ignore
    for (const closed of [false, true]) {
      const made = (interpolated(through, closed) ?? []).flatMap((c) => plainCurve(c).segments);
      for (const [x, y] of through) expect(distance(made, at(x, y))).toBeLessThan(1e-6);
      // Between its points the ring is near the circle, not the square.
      if (closed) expect(distance(made, at(7.07, 7.07))).toBeLessThan(0.3);
    }
    expect(interpolated([[1, 1, 0]], false)).toBeNull();
  });

  test("a line is one line, whatever its parameter", () => {
    expect(fitted({ point: (t) => at(t ** 3, 2 * t ** 3), from: 0, to: 2, detail: 1 })).toHaveLength(1);
  });
});
