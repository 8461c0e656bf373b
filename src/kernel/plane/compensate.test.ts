import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf } from "../area/area.ts";
import { difference, offset } from "../area/clip.ts";
import { compensate } from "./compensate.ts";
import { partSegment, plane, type PlanePoint, type PlaneSegment } from "./plane.ts";
import { planeContour } from "./plane-contour.ts";
import { part, type Ring } from "../geometry/point.ts";

const { apart, beyond, gapBetween, scaled, sum, turned } = plane;

const point = (x: number, y: number): PlanePoint => ({ x, y });
const lines = (...points: PlanePoint[]): PlaneSegment[] =>
  points.slice(1).map((to, i) => ({ kind: "line", from: points[i] ?? to, to }));
const arc = (from: PlanePoint, to: PlanePoint, centre: PlanePoint, turn: "cw" | "ccw"): PlaneSegment => ({
  kind: "arc",
  from,
  to,
  centre,
  turn,
});
const rounded = (p: PlanePoint) => `${Math.round(p.x * 1e4) / 1e4 + 0} ${Math.round(p.y * 1e4) / 1e4 + 0}`;
const shown = (contour: PlaneSegment[], side: "left" | "right", radius: number) =>
  compensate(contour, side, radius).pieces.map(
    ({ segment: s }) => `${s.kind === "arc" ? s.turn : "line"} ${rounded(s.to)}`,
  );
const faults = (contour: PlaneSegment[], side: "left" | "right", radius: number) =>
  compensate(contour, side, radius).issues.map((i) =>
    i.code === "toolRadiusTooLarge" ? [i.data.element, i.data.nearest] : [],
  );

describe("by hand", () => {
  test("an outer corner gets an arc of the tool radius", () =>
    expect(shown(lines(point(0, 0), point(50, 0), point(50, -50)), "left", 10)).toEqual([
      "line 50 10",
      "cw 60 0",
      "line 60 -50",
    ]));
  test("an inner corner is cut off where both paths meet", () =>
    expect(shown(lines(point(0, 0), point(50, 0), point(50, -50)), "right", 10)).toEqual([
      "line 40 -10",
      "line 40 -50",
    ]));
  // Line y = 0 and a half circle round (50, 20), radius 20, from (50, 0): tangential. Inside it 20 − 5, outside 20 + 5.
  test("a tangential arc stays an arc, smaller inside and larger outside", () => {
    const contour = [...lines(point(0, 0), point(50, 0)), arc(point(50, 0), point(50, 40), point(50, 20), "ccw")];
    expect(shown(contour, "left", 5)).toEqual(["line 50 5", "ccw 50 35"]);
    expect(shown(contour, "right", 5)).toEqual(["line 50 -5", "ccw 50 45"]);
  });
  // Circle round (50, 0), radius 30, entered from a line along y = 0 at (20, 0), upper half clockwise. RL: the circle
  // grows to 36, the line rises to y = 6: x = 50 − √(36² − 6²) = 50 − 35.4965 = 14.5035.
  test("line and arc cut each other in an inner corner", () =>
    expect(
      shown([...lines(point(0, 0), point(20, 0)), arc(point(20, 0), point(80, 0), point(50, 0), "cw")], "left", 6)[0],
    ).toBe("line 14.5035 6"));
  // Two circles of radius 20 round (0, 0) and (30, 0) meet in (15, √175) and dip towards each other: a valley seen from
  // above. With radius 4 both grow to 24: (15, √(24² − 15²)) = (15, 18.735).
  test("arc and arc cut each other", () => {
    const y = Math.sqrt(175);
    const contour = [
      arc(point(-20, 0), point(15, y), point(0, 0), "cw"),
      arc(point(15, y), point(50, 0), point(30, 0), "cw"),
    ];
    expect(shown(contour, "left", 4)).toEqual(["cw 15 18.735", "cw 54 0"]);
  });
  test("a full circle, inside and outside", () => {
    const circle = [arc(point(30, 0), point(30, 0), point(0, 0), "ccw")];
    expect(shown(circle, "left", 10)).toEqual(["ccw 20 0"]);
    expect(shown(circle, "right", 10)).toEqual(["ccw 40 0"]);
  });
  test("R0 is the contour", () => {
    const contour = lines(point(0, 0), point(50, 0), point(50, 9));
    expect(compensate(contour, "none", 10).pieces.map((p) => p.segment)).toEqual(contour);
  });
});

describe("a tool that does not fit is reported at the element, with the largest that does", () => {
  const pocket = [
    ...lines(point(0, 0), point(50, 0)),
    arc(point(50, 0), point(50, 12), point(50, 6), "ccw"),
    ...lines(point(50, 12), point(0, 12)),
  ];
  test("inside radius", () => {
    expect(faults(pocket, "left", 6.5)).toEqual([[2, 6]]);
    expect(faults(pocket, "left", 6)).toEqual([]);
    expect(faults(pocket, "right", 60)).toEqual([]);
  });
  // A notch 10 wide at right angles: both walls take the radius, the floor of 10 is used up at radius 5.
  test("a floor that is too short", () => {
    const notch = lines(point(0, 50), point(0, 0), point(10, 0), point(10, 50));
    expect(faults(notch, "left", 5.5)).toEqual([[2, 5]]);
    expect(faults(notch, "left", 5)).toEqual([]);
    expect(shown(notch, "left", 4)).toEqual(["line 4 4", "line 6 4", "line 6 50"]);
  });
  test("RND and CHF count as elements of their corner", () => {
    const corner = lines(point(0, 0), point(50, 0), point(50, 50)).map((segment, i) =>
      i === 0 ? { segment, corner: { kind: "round", size: 4 } as const } : { segment },
    );
    expect(planeContour(corner, "left", 4).issues).toEqual([]);
    expect(planeContour(corner, "left", 5).issues).toMatchObject([
      {
        element: 0,
        onCorner: true,
        issue: { code: "toolRadiusTooLarge", data: { nearest: 4 } },
      },
    ]);
    expect(planeContour(corner, "right", 5).path.map((p) => `${p.segment.kind} ${rounded(p.segment.to)}`)).toEqual([
      "line 46 -5",
      "arc 55 4",
      "line 55 50",
    ]);
  });
});

/**
 * Closed contours around a centre: corners on rays, joined by lines and by arcs of both turns; counter-clockwise,
 * starting in the middle of a side.
 */
const closedContour = fc
  .record({
    corners: fc.array(
      fc.record({
        far: fc.double({ min: 40, max: 80, noNaN: true }),
        bulge: fc.constantFrom(0, 0, 0.25, -0.2, 0.1),
        rounding: fc.constantFrom(0, 0, 3, 6),
      }),
      { minLength: 3, maxLength: 9 },
    ),
    start: fc.double({ min: 0, max: 360, noNaN: true }),
    centre: fc.record({
      x: fc.double({ min: -90, max: 90, noNaN: true }),
      y: fc.double({ min: -90, max: 90, noNaN: true }),
    }),
  })
  .map(({ corners, start, centre }) => {
    const points = corners.map((c, i) =>
      sum(centre, turned(point(c.far, 0), point(0, 0), start + (360 * i) / corners.length)),
    );
    const sides = points.map((from, i) =>
      bulged(from, points[(i + 1) % points.length] ?? from, corners[i]?.bulge ?? 0),
    );
    const first = sides[0];
    if (!first) return { elements: [], closed: sides };
    const middle =
      first.kind === "line"
        ? scaled(sum(first.from, first.to), 0.5)
        : beyond(
            first.centre,
            headed(first.centre, scaled(sum(first.from, first.to), 0.5)),
            apart(first.centre, first.from),
          );
    const chain = [{ ...first, from: middle }, ...sides.slice(1), { ...first, to: middle }];
    const elements = chain.map((segment, i) => {
      const size = corners[i % corners.length]?.rounding ?? 0;
      return size > 0 && i < chain.length - 1 ? { segment, corner: { kind: "round", size } as const } : { segment };
    });
    return { elements, closed: chain };
  });

/**
 * The unit vector from an arc's centre to the middle of the arc: on the side of the chord where the arc runs (less than
 * half a circle).
 */
function headed(centre: PlanePoint, middleOfChord: PlanePoint): PlanePoint {
  const d = { x: middleOfChord.x - centre.x, y: middleOfChord.y - centre.y };
  return scaled(d, 1 / Math.hypot(d.x, d.y));
}

/** A side with a bulge: height over half chord, positive outwards of a counter-clockwise contour. */
function bulged(from: PlanePoint, to: PlanePoint, bulge: number): PlaneSegment {
  if (bulge === 0) return { kind: "line", from, to };
  const half = apart(from, to) / 2;
  const away = (half * (1 - bulge * bulge)) / (2 * bulge);
  const left = scaled({ x: from.y - to.y, y: to.x - from.x }, 1 / (half + half));
  return arc(from, to, beyond(scaled(sum(from, to), 0.5), left, away), bulge > 0 ? "ccw" : "cw");
}

const ringOf = (chain: readonly PlaneSegment[]): Ring => {
  const points = part.flattenedChain(chain.map(partSegment), 0.0005);
  return points.slice(0, -1);
};
const side = fc.constantFrom("left" as const, "right" as const);
const RUNS = { numRuns: 400 };

describe("laws over closed contours of lines, arcs and roundings", () => {
  test("the path has no gaps and never leaves the contour by more than the tool radius", () => {
    fc.assert(
      fc.property(closedContour, side, fc.double({ min: 0.1, max: 15, noNaN: true }), ({ elements }, hand, radius) => {
        const made = planeContour(elements, hand, radius);
        made.path
          .slice(1)
          .forEach((p, i) =>
            expect(apart(p.segment.from, made.path[i]?.segment.to ?? p.segment.from)).toBeLessThan(1e-9),
          );
        if (made.issues.length > 0) return;
        for (const p of made.path) {
          const near = Math.min(...made.contour.map((c) => gapBetween(p.segment, c.segment).distance));
          expect(near).toBeLessThan(radius + 1e-6);
        }
      }),
      RUNS,
    );
  });

  test("the area inside the path is the contour grown or shrunk by the tool radius, as the polygon engine sees it", () => {
    let compared = 0;
    fc.assert(
      fc.property(closedContour, side, fc.double({ min: 0.5, max: 12, noNaN: true }), ({ elements }, hand, radius) => {
        const made = planeContour(elements, hand, radius);
        if (made.issues.length > 0) return;
        const contour = ringOf(made.contour.map((c) => c.segment));
        const path = ringOf(made.path.map((p) => p.segment));
        const grown = offset([contour], hand === "right" ? radius : -radius);
        const long = made.path.reduce((l, p) => l + apart(p.segment.from, p.segment.to), 0);
        // Cuts beyond neighbouring elements (a waist too narrow for the tool) are covered by the next law.
        const cutsItself = made.path.some((p) =>
          made.contour.some((c) => gapBetween(p.segment, c.segment).distance < radius - 1e-6),
        );
        if (cutsItself) return;
        compared += 1;
        const apartArea = areaOf(difference([path], grown)) + areaOf(difference(grown, [path]));
        expect(apartArea).toBeLessThan(0.004 * (long + 100));
      }),
      RUNS,
    );
    expect(compared).toBeGreaterThan(100);
  });

  test("RL and RR are mirror images", () => {
    const mirror = (p: PlanePoint) => point(p.x, -p.y);
    const mirrored = (s: PlaneSegment): PlaneSegment =>
      s.kind === "line"
        ? { kind: "line", from: mirror(s.from), to: mirror(s.to) }
        : arc(mirror(s.from), mirror(s.to), mirror(s.centre), s.turn === "cw" ? "ccw" : "cw");
    fc.assert(
      fc.property(closedContour, side, fc.double({ min: 0.1, max: 15, noNaN: true }), ({ closed }, hand, radius) => {
        const one = compensate(closed, hand, radius);
        const two = compensate(closed.map(mirrored), hand === "left" ? "right" : "left", radius);
        expect(two.pieces.length).toBe(one.pieces.length);
        two.pieces.forEach((p, i) =>
          expect(apart(mirror(p.segment.to), one.pieces[i]?.segment.to ?? point(NaN, 0))).toBeLessThan(1e-7),
        );
        expect(two.issues.length).toBe(one.issues.length);
      }),
      RUNS,
    );
  });

  test("a tool radius reported to fit does fit", () => {
    fc.assert(
      fc.property(closedContour, side, fc.double({ min: 5, max: 60, noNaN: true }), ({ closed }, hand, radius) => {
        for (const found of compensate(closed, hand, radius).issues) {
          if (found.code !== "toolRadiusTooLarge") continue;
          const { element, nearest } = found.data;
          if (nearest === undefined) continue;
          expect(nearest).toBeLessThan(radius);
          const others = compensate(closed, hand, nearest).issues.map((i) =>
            "element" in i.data ? i.data.element : 0,
          );
          expect(others).not.toContain(element);
        }
      }),
      RUNS,
    );
  });
});
