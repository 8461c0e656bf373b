import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { plane, type PlanePoint, type PlaneSegment } from "../plane/plane.ts";
import { signOf, type Turn } from "../geometry/segments.ts";
import type { FreeElement } from "./element.ts";
import { solveFreeContour } from "./solve.ts";

const { apart, beyond, heading, lengthOf, leftOf, pointOn, scaled, sum } = plane;

const nothing: FreeElement = {
  kind: "line",
  tangent: false,
  x: null,
  y: null,
  polar: null,
  angle: null,
  length: null,
  turn: "ccw",
  radius: null,
  centreX: null,
  centreY: null,
  centrePolar: null,
  sweep: null,
  through: [],
  distancePoint: null,
  parallel: null,
  closes: null,
};
const line = (given: Partial<FreeElement>): FreeElement => ({ ...nothing, ...given });
const arc = (turn: Turn, given: Partial<FreeElement>): FreeElement => ({ ...nothing, kind: "arc", turn, ...given });
const at = (value: number) => ({ at: value });
const centre = (x: number, y: number) => ({ centreX: at(x), centreY: at(y) });

/** An element of a real contour, and which of its values are given. */
interface Drawn {
  readonly corner: number | null;
  readonly kind: "line" | "arc";
  readonly long: number;
  readonly sweep: number;
  readonly turn: Turn;
  readonly given: readonly boolean[];
}

function drawn(parts: readonly Drawn[]): { readonly segments: PlaneSegment[]; readonly elements: FreeElement[] } {
  const segments: PlaneSegment[] = [];
  const elements: FreeElement[] = [];
  let [from, angle]: [PlanePoint, number] = [{ x: 3.7, y: -2.9 }, 0.4];
  for (const part of parts) {
    const tangent = part.corner === null && segments.length > 0;
    const way = angle + (part.corner ?? 0);
    const [a = false, b = false, c = false, d = false] = part.given;
    if (part.kind === "line") {
      const to = beyond(from, heading(way), part.long);
      segments.push({ kind: "line", from, to });
      elements.push(
        line({
          tangent,
          angle: a ? at(way) : null,
          length: b ? part.long : null,
          x: c ? at(to.x) : null,
          y: d ? at(to.y) : null,
        }),
      );
      [from, angle] = [to, way];
      continue;
    }
    const middle = sum(from, scaled(leftOf(heading(way)), signOf(part.turn) * part.long));
    const to = plane.turned(from, middle, (signOf(part.turn) * part.sweep * 180) / Math.PI);
    segments.push({ kind: "arc", from, to, centre: middle, turn: part.turn });
    elements.push(
      arc(part.turn, {
        tangent,
        radius: a ? part.long : null,
        ...(b && centre(middle.x, middle.y)),
        x: c ? at(to.x) : null,
        y: d ? at(to.y) : null,
      }),
    );
    [from, angle] = [to, way + signOf(part.turn) * part.sweep];
  }
  return { segments, elements };
}

/** Two tangential arcs of the same radius are one arc: nothing determines where they meet. */
const isOneArc = (a: Drawn | undefined, b: Drawn) =>
  a?.kind === "arc" && b.kind === "arc" && b.corner === null && a.turn === b.turn && Math.abs(a.long - b.long) < 1;
const contours = (one: fc.Arbitrary<Drawn>, maxLength: number) =>
  fc.array(one, { minLength: 1, maxLength }).filter((parts) => !parts.some((b, i) => isOneArc(parts[i - 1], b)));

const part: fc.Arbitrary<Drawn> = fc.record({
  corner: fc.oneof(
    fc.constant(null),
    fc.integer({ min: -22, max: 22 }).map((n) => n / 10),
  ),
  kind: fc.constantFrom("line" as const, "arc" as const),
  long: fc.integer({ min: 40, max: 400 }).map((n) => n / 13),
  sweep: fc.integer({ min: 3, max: 45 }).map((n) => n / 10),
  turn: fc.constantFrom("cw" as const, "ccw" as const),
  given: fc.array(fc.boolean(), { minLength: 4, maxLength: 4 }),
});

/** Places along two segments agree. */
const same = (a: PlaneSegment, b: PlaneSegment) =>
  [0, 0.31, 0.66, 1].every((k) => apart(pointOn(a, k), pointOn(b, k)) < 1e-3) &&
  Math.abs(lengthOf(a) - lengthOf(b)) < 1e-2;

test("a certain result is the contour that the values were taken from", () => {
  let certain = 0;
  fc.assert(
    fc.property(contours(part, 4), (parts) => {
      const { segments, elements } = drawn(parts);
      solveFreeContour(elements, { x: 3.7, y: -2.9 }, null).forEach((solved, i) => {
        const real = segments[i];
        if (!solved?.certain || !real) return;
        certain += 1;
        expect(same(solved.segment, real), JSON.stringify([solved.segment, real])).toBe(true);
      });
    }),
    { numRuns: 120 },
  );
  expect(certain).toBeGreaterThan(60);
});

test("elements that follow from a choice are uncertain, even those before it", () => {
  // The radius of the second arc allows two centres; the first arc, given only by its end, is tangential to either.
  const { elements } = drawn([
    { corner: 0, kind: "arc", long: 40 / 13, sweep: 0.3, turn: "cw", given: [false, false, true, true] },
    {
      corner: null,
      kind: "arc",
      long: 40 / 13,
      sweep: 3.2,
      turn: "ccw",
      given: [true, false, true, true],
    },
  ]);
  expect(solveFreeContour(elements, { x: 3.7, y: -2.9 }, null).map((solved) => solved?.certain)).toEqual([
    false,
    false,
  ]);
});

test("a fully given contour is found, in whatever direction it runs", () => {
  const whole = part.map((p) => ({
    ...p,
    given: p.kind === "line" ? [true, true, false, false] : [false, true, true, true],
  }));
  fc.assert(
    fc.property(contours(whole, 6), (parts) => {
      const { segments, elements } = drawn(parts);
      solveFreeContour(elements, { x: 3.7, y: -2.9 }, null).forEach((solved, i) => {
        expect(solved?.certain).toBe(true);
        expect(solved && segments[i] && same(solved.segment, segments[i])).toBe(true);
      });
    }),
    { numRuns: 60 },
  );
});

describe("elements determined together with their neighbours", () => {
  const ends = (elements: readonly FreeElement[], start: PlanePoint) =>
    solveFreeContour(elements, start, null).map(
      (s) => s && [s.segment.to.x, s.segment.to.y].map((n) => Math.round(n * 1000) / 1000 + 0),
    );

  test("a line between two circles given only by centre and radius", () => {
    const [one, two, three] = solveFreeContour(
      [
        arc("cw", { radius: 12, ...centre(12, 0) }),
        line({ tangent: true }),
        arc("cw", { tangent: true, radius: 5, ...centre(40, 9), x: at(40), y: at(4) }),
      ],
      { x: 0, y: 0 },
      null,
    );
    expect([one, two, three].every((s) => s?.certain)).toBe(true);
    expect(two && Math.abs(lengthOf(two.segment) - Math.sqrt(28 * 28 + 81 - 49))).toBeLessThan(1e-6);
  });
  test("a line at a distance from a point, and one parallel to another", () => {
    const found = ends(
      [
        line({ angle: at(0), length: 30 }),
        line({ angle: at(Math.PI / 2), x: at(30) }),
        line({ parallel: { of: 1, distance: 12.5 }, angle: at(Math.PI), length: 7 }),
      ],
      { x: 0, y: 0 },
    );
    expect(found).toEqual([
      [30, 0],
      [30, 12.5],
      [23, 12.5],
    ]);
    expect(
      ends([line({ distancePoint: { point: { x: 10, y: 4 }, distance: 4 }, angle: at(0), x: at(18) })], { x: 2, y: 0 }),
    ).toEqual([[18, 0]]);
  });
  test("an arc through points, one by its sweep, one that begins in a direction", () => {
    expect(
      ends(
        [
          arc("ccw", {
            through: [
              { x: 10, y: 10 },
              { x: 0, y: 20 },
            ],
            x: at(-6),
            y: at(18),
          }),
        ],
        { x: 0, y: 0 },
      ),
    ).toEqual([[-6, 18]]);
    expect(ends([arc("cw", { ...centre(0, 0), sweep: Math.PI / 2 })], { x: -9, y: 0 })).toEqual([[0, 9]]);
    expect(ends([arc("ccw", { angle: at(0), radius: 7, x: at(7), y: at(7) })], { x: 0, y: 0 })).toEqual([[7, 7]]);
  });
  test("a closed contour ends where it began", () => {
    const found = ends(
      [line({ angle: at(0), length: 20 }), line({ angle: at(Math.PI / 2), length: 8 }), line({ closes: 0 })],
      {
        x: 1,
        y: 2,
      },
    );
    expect(found).toEqual([
      [21, 2],
      [21, 10],
      [1, 2],
    ]);
  });
  test("a line that only just touches a circle has one solution", () =>
    expect(ends([arc("cw", { radius: 30, ...centre(30, 30), x: at(0) })], { x: 30, y: 60 })).toEqual([[0, 30]]));
  test("of several contours the shortest is taken and marked uncertain", () => {
    const [only] = solveFreeContour([arc("ccw", { radius: 10, ...centre(0, 0), x: at(-6) })], { x: 10, y: 0 }, null);
    expect(only?.certain).toBe(false);
    expect(only?.segment.to.x).toBeCloseTo(-6, 6);
    expect(only?.segment.to.y).toBeCloseTo(8, 6);
  });
  test("elements before a contradiction are found, open or contradicting ones are not", () => {
    const found = ends(
      [line({ angle: at(0), length: 5 }), line({ angle: at(0), length: 3, x: at(2) }), line({ x: at(9), y: at(9) })],
      {
        x: 0,
        y: 0,
      },
    );
    expect(found).toEqual([[5, 0], null, null]);
    expect(ends([line({ angle: at(0.5) })], { x: 0, y: 0 })).toEqual([null]);
  });
});
