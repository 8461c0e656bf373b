import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { approach, type ApproachRequest, type ApproachShape } from "./approach.ts";
import { plane, towardsTool, type PlanePoint, type PlaneSegment } from "./plane.ts";

const { apart, beyond, cross, direction, dot, turned } = plane;

const line = (x1: number, y1: number, x2: number, y2: number): PlaneSegment => ({
  kind: "line",
  from: { x: x1, y: y1 },
  to: { x: x2, y: y2 },
});
const base: ApproachRequest = {
  shape: "LT",
  departing: false,
  side: "right",
  toolRadius: 0,
  element: line(20, 20, 35, 35),
  outside: { x: 40, y: 10 },
  length: 15,
  radius: 10,
  centreAngle: 180,
};
const rounded = (p: PlanePoint | undefined) =>
  p && { x: Math.round(p.x * 1e6) / 1e6 + 0, y: Math.round(p.y * 1e6) / 1e6 + 0 };
const points = (q: Partial<ApproachRequest>) =>
  Object.fromEntries(Object.entries(approach({ ...base, ...q }).points).map(([n, p]) => [n, rounded(p)]));

describe("forms by hand, tool radius 0", () => {
  // The first element runs at 45°, so its direction is (0.707107, 0.707107): 15 mm are 10.606602 on each axis.
  test("LT: PH lies LEN before PA on the line of the element", () =>
    expect(points({})).toEqual({ PS: { x: 40, y: 10 }, PH: { x: 9.393398, y: 9.393398 }, PA: { x: 20, y: 20 } }));
  // RR: the tool stands to the right of the direction, so LEN goes towards (0.707107, −0.707107).
  test("LN: PH lies LEN beside PA on the side of the tool", () => {
    expect(points({ shape: "LN" })["PH"]).toEqual({ x: 30.606602, y: 9.393398 });
    expect(points({ shape: "LN", length: -15 })["PH"]).toEqual({ x: 9.393398, y: 30.606602 });
  });
  // Half a circle of radius 10 ends one diameter beside PA: 20 × 0.707107 = 14.142136.
  test("CT: half a circle starts one diameter beside PA", () =>
    expect(points({ shape: "CT" })["PH"]).toEqual({ x: 34.142136, y: 5.857864 }));
  // Along +Y with RR the circle stands at (20, 20); from (40, 20), twice the radius away, the tangent touches at 60°
  // from the ray: PH = (20 + 10 cos 60°, 20 ± 10 sin 60°). The tool runs clockwise, so it arrives below: the lower
  // point.
  test("LCT: the tangent from PS", () =>
    expect(points({ shape: "LCT", element: line(10, 20, 10, 35), outside: { x: 40, y: 20 } })).toEqual({
      PS: { x: 40, y: 20 },
      PH: { x: 25, y: 11.339746 },
      PA: { x: 10, y: 20 },
    }));
  test("the tool radius lies between contour and path", () => {
    const along = {
      element: line(5, 5, 5, 95),
      side: "left",
      toolRadius: 10,
      outside: { x: -10, y: -10 },
      length: 10,
    } as const;
    expect(points(along)).toEqual({ PS: { x: -10, y: -10 }, PH: { x: -5, y: -5 }, PA: { x: -5, y: 5 } });
    expect(points({ ...along, departing: true, element: line(95, 5, 5, 5), side: "left" })["PN"]).toEqual({
      x: -5,
      y: -5,
    });
  });
});

describe("the direction table of CT", () => {
  test.each([
    ["left", 10, "ccw"],
    ["left", -10, "cw"],
    ["right", 10, "cw"],
    ["right", -10, "ccw"],
  ] as const)("%s with R %d runs %s", (side, radius, turn) => {
    for (const departing of [false, true]) {
      const made = approach({ ...base, shape: "CT", side, radius, departing });
      expect(made.arc?.turn).toBe(turn);
      expect(made.legs.find((l) => l.segment.kind === "arc")?.segment).toMatchObject({ turn });
    }
  });
});

describe("an impossible approach is reported with a value that works", () => {
  const said = (q: Partial<ApproachRequest>) =>
    approach({ ...base, ...q }).issues.map((i) => [i.code, i.at, "nearest" in i.data ? i.data.nearest : null]);
  test("PS in the circle: the radius that reaches exactly to it", () => {
    // Circle through (10, 20) and PS = (18, 26) with its centre to the right of +Y: |w|² / 2 w·n = (64 + 36) / 16 =
    // 6.25.
    const inside = { shape: "LCT", element: line(10, 20, 10, 35), outside: { x: 18, y: 26 } } as const;
    expect(said(inside)).toEqual([["approachInsideCircle", "R", 6.25]]);
    expect(approach({ ...base, ...inside }).legs.map((l) => l.segment.to)).toEqual([{ x: 10, y: 20 }]);
    expect(said({ ...inside, radius: 6.25 })).toEqual([]);
    expect(said({ ...inside, radius: 6.251 })).toHaveLength(1);
  });
  test("missing and wrong words", () => {
    const { length: _l, ...withoutLength } = base;
    expect(approach(withoutLength).issues.map((i) => [i.code, i.at, i.severity])).toEqual([
      ["missing", "LEN", "warning"],
    ]);
    expect(said({ shape: "CT", side: "none" })).toEqual([["approachNeedsSide", undefined, null]]);
    expect(said({ shape: "CT", centreAngle: 400 })).toEqual([["outOfRange", "CCA", 360]]);
    expect(said({ shape: "LCT", radius: -10 })).toEqual([["outOfRange", "R", 10]]);
    expect(said({ shape: "LN", side: "none" })).toEqual([["approachSideAssumed", undefined, null]]);
    expect(said({ shape: "CT", radius: 0 })).toEqual([["outOfRange", "R", 0.001]]);
  });
});

const coordinate = fc.double({ min: -200, max: 200, noNaN: true });
const point = fc.record({ x: coordinate, y: coordinate });
/** Elements in every direction: lines, and arcs of both turns. */
const element = fc
  .record({
    from: point,
    angle: fc.double({ min: -180, max: 180, noNaN: true }),
    size: fc.double({ min: 0.5, max: 120, noNaN: true }),
    kind: fc.constantFrom("line", "cw", "ccw"),
    sweep: fc.double({ min: 5, max: 355, noNaN: true }),
  })
  .map(({ from, angle, size, kind, sweep }): PlaneSegment => {
    const way = turned({ x: 1, y: 0 }, { x: 0, y: 0 }, angle);
    if (kind === "line") return { kind: "line", from, to: beyond(from, way, size) };
    const turn = kind === "ccw" ? "ccw" : "cw";
    const centre = beyond(from, way, size);
    return { kind: "arc", from, to: turned(from, centre, turn === "ccw" ? sweep : -sweep), centre, turn };
  });
const request: fc.Arbitrary<ApproachRequest> = fc
  .record({
    shape: fc.constantFrom<ApproachShape>("LT", "LN", "CT", "LCT"),
    departing: fc.boolean(),
    side: fc.constantFrom("left" as const, "right" as const),
    toolRadius: fc.double({ min: 0, max: 25, noNaN: true }),
    element,
    outside: point,
    length: fc.double({ min: -50, max: 80, noNaN: true }),
    radius: fc.oneof(fc.double({ min: 0.1, max: 60, noNaN: true }), fc.double({ min: -60, max: -0.1, noNaN: true })),
    centreAngle: fc.double({ min: 0.5, max: 360, noNaN: true }),
  })
  .map((q) => (q.shape === "LCT" ? { ...q, radius: Math.abs(q.radius) } : q));

const pure = (q: ApproachRequest) => approach(q);
const RUNS = { numRuns: 1500 };
/** Mirrored at the X axis: left becomes right, counter-clockwise clockwise. */
const mirror = (p: PlanePoint): PlanePoint => ({ x: p.x, y: -p.y });
const mirrored = (s: PlaneSegment): PlaneSegment =>
  s.kind === "line"
    ? { kind: "line", from: mirror(s.from), to: mirror(s.to) }
    : {
        kind: "arc",
        from: mirror(s.from),
        to: mirror(s.to),
        centre: mirror(s.centre),
        turn: s.turn === "ccw" ? "cw" : "ccw",
      };
const near = (a: PlanePoint, b: PlanePoint, within = 1e-9) => expect(apart(a, b)).toBeLessThanOrEqual(within);

describe("laws over random elements, all forms, both sides", () => {
  test("the path is without gaps, ends exactly in its points, and nothing is NaN", () => {
    fc.assert(
      fc.property(request, (q) => {
        const made = pure(q);
        expect(JSON.stringify(made)).not.toMatch(/null,"y"|"y":null|NaN/);
        const segments = made.legs.map((l) => l.segment);
        segments.slice(1).forEach((s, i) => expect(s.from).toEqual(segments[i]?.to));
        const corner = q.departing ? q.element.to : q.element.from;
        const at = beyond(corner, towardsTool(direction(q.element, corner), q.side), q.toolRadius);
        const { PS, PA, PE, PN } = made.points;
        expect(q.departing ? PE : PA).toEqual(at);
        if (segments.length === 0) return;
        expect(segments[0]?.from).toEqual(q.departing ? PE : PS);
        expect(segments.at(-1)?.to).toEqual(q.departing ? PN : PA);
        for (const s of segments)
          if (s.kind === "arc") expect(apart(s.from, s.centre)).toBeCloseTo(apart(s.to, s.centre), 9);
      }),
      RUNS,
    );
  });

  test("tangential in PA and PE for LT, CT and LCT, perpendicular for LN, to a millionth of a radian", () => {
    fc.assert(
      fc.property(request, (q) => {
        const made = pure(q);
        if (made.issues.length > 0 || made.legs.length === 0) return;
        const leg = q.departing ? made.legs[0] : made.legs.at(-1);
        const at = q.departing ? made.points.PE : made.points.PA;
        // The direction of a line is as precise as its ends: to a hundred-millionth of a millimetre.
        if (!leg || !at || (leg.segment.kind === "line" && apart(leg.segment.from, leg.segment.to) < 1e-2)) return;
        const way = direction(leg.segment, at);
        if (q.shape === "LN") expect(Math.abs(dot(way, made.tangent))).toBeLessThan(1e-6);
        else {
          // An arc shorter than a nanometre is left out: the line then ends off the tangent by the angle of that arc.
          const turn = q.shape === "LCT" && leg.segment.kind === "line" ? 1e-6 / (q.radius ?? 1) : 0;
          expect(Math.abs(cross(way, made.tangent))).toBeLessThan(1e-6 + turn);
          if (q.shape !== "LT" || (q.length ?? 0) > 0) expect(dot(way, made.tangent)).toBeGreaterThan(0);
        }
      }),
      RUNS,
    );
  });

  test("LCT: line and arc meet tangentially, to a millionth", () => {
    fc.assert(
      fc.property(request, (q) => {
        const made = pure({ ...q, shape: "LCT", radius: Math.abs(q.radius ?? 1) });
        const [one, two] = made.legs.map((l) => l.segment);
        if (!one || !two || made.issues.length > 0) return;
        const [straight] = [one, two].filter((s) => s.kind === "line");
        if (!straight || apart(straight.from, straight.to) < 1e-3) return;
        // Close to the circle the line to the tangent point is short, and its direction has half the digits of its
        // ends.
        near(direction(one, one.to), direction(two, two.from), 1e-8);
      }),
      RUNS,
    );
  });

  test("LCT is possible exactly from outside its circle, and the nearest radius then works", () => {
    fc.assert(
      fc.property(request, (q) => {
        const made = pure({ ...q, shape: "LCT", radius: Math.abs(q.radius ?? 1) });
        const found = made.issues.find((i) => i.code === "approachInsideCircle");
        expect(found ? 1 : made.legs.length).toBeGreaterThan(0);
        if (!found) return;
        const { nearest } = found.data;
        if (nearest === undefined) return;
        expect(nearest).toBeGreaterThan(0);
        expect(nearest).toBeLessThanOrEqual(Math.abs(q.radius ?? 1));
        expect(pure({ ...q, shape: "LCT", radius: nearest }).issues).toEqual([]);
      }),
      RUNS,
    );
  });

  test("RL and RR are mirror images", () => {
    fc.assert(
      fc.property(request, (q) => {
        const image = pure({
          ...q,
          side: q.side === "left" ? "right" : "left",
          element: mirrored(q.element),
          outside: q.outside && mirror(q.outside),
        });
        const made = pure(q);
        expect(image.legs.length).toBe(made.legs.length);
        made.legs.forEach((l, i) => {
          const other = mirrored(image.legs[i]?.segment ?? l.segment);
          near(l.segment.from, other.from);
          near(l.segment.to, other.to);
          expect(other.kind === "arc" ? other.turn : null).toBe(l.segment.kind === "arc" ? l.segment.turn : null);
        });
      }),
      RUNS,
    );
  });

  test("LEN is the length and CCA the angle of the path", () => {
    fc.assert(
      fc.property(request, (q) => {
        const made = pure(q);
        const { PH, PA, PE, PN } = made.points;
        const [a, b] = q.departing ? [PE, PN] : [PH, PA];
        if (q.shape === "LCT" || made.issues.length > 0 || !a || !b) return;
        if (q.shape === "CT")
          expect(apart(a, b)).toBeCloseTo(
            2 * Math.abs(q.radius ?? 0) * Math.abs(Math.sin(((q.centreAngle ?? 0) * Math.PI) / 360)),
            8,
          );
        else expect(apart(a, b)).toBeCloseTo(Math.abs(q.length ?? 0), 9);
      }),
      RUNS,
    );
  });
});
