import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { MeasuredKind, MeasuredMoment, MeasuredPlace, Measurement } from "../../kernel/plan/measured.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { chainOfRing, type Measurable } from "./edges.ts";
import { measuredFigure } from "./figure.ts";
import { readMeasurement } from "./reading.ts";
import { snapTargetOf, nextStop, snapAt, snappingOf, stopsOf } from "./snap.ts";
import { pickedWith } from "./tool.ts";

const line = (from: Pt, to: Pt): Segment => ({ kind: "line", from, to });
const shaft: readonly Segment[] = [
  line(at(0, 7.35), at(-1.15, 8.5)),
  line(at(-1.15, 8.5), at(-13.27, 8.5)),
  { kind: "arc", from: at(-13.27, 8.5), to: at(-14.87, 10.1), centre: at(-13.27, 10.1), turn: "cw" },
  line(at(-14.87, 10.1), at(-14.87, 21.0175)),
  line(at(-14.87, 21.0175), at(-41.3, 23.33)),
];
const drawing = (given: Partial<Measurable> = {}): Measurable => ({
  isTurned: true,
  contours: [shaft],
  blank: [],
  stock: [],
  path: [],
  ...given,
});
const REACH = 0.6;

function taken(kind: MeasuredKind, on: Measurable, ...pointed: readonly Pt[]): readonly MeasuredPlace[] {
  const snapping = snappingOf(on),
    grip = snapTargetOf(kind, on);
  let first: MeasuredPlace | null = null;
  for (const p of pointed) {
    const picked = pickedWith(kind, snapping, snapAt(snapping, p, REACH, grip), first);
    if (typeof picked === "string") return [];
    if ("measured" in picked) return picked.measured;
    first = picked.waits;
  }
  return [];
}
const value = (kind: MeasuredKind, on: Measurable, ...pointed: readonly Pt[]): number | undefined =>
  measuredFigure(kind, taken(kind, on, ...pointed), on.isTurned)?.value;

describe("snapping of measuring tools", () => {
  const snapping = snappingOf(drawing({ path: [at(3.2, 9.1)], blank: [[line(at(2.2, 26.05), at(-60, 26.05))]] }));
  test.each<[string, Pt, ReturnType<typeof snapAt>["spot"], Pt]>([
    ["a corner before the edge that it ends", at(-1.3, 8.8), "corner", at(-1.15, 8.5)],
    ["somewhere on a line", at(-7.77, 8.31), "edge", at(-7.77, 8.5)],
    ["the centre of an arc", at(-13.1, 10.3), "centre", at(-13.27, 10.1)],
    ["the end of a move", at(3.4, 9.3), "path", at(3.2, 9.1)],
    ["the blank", at(-33.3, 26.3), "edge", at(-33.3, 26.05)],
    ["nothing", at(9.9, 3.3), "free", at(9.9, 3.3)],
    ["the mirrored edge below the axis", at(-7.77, -8.31), "edge", at(-7.77, -8.5)],
    ["the mirrored corner", at(-1.3, -8.8), "corner", at(-1.15, -8.5)],
  ])("%s", (_, place, spot, on) => {
    const found = snapAt(snapping, place, REACH, "point");
    expect(found.spot).toBe(spot);
    expect(part.apart(found.at, on)).toBeLessThan(1e-9);
  });

  test("what remains of the blank is measured as the blank, not as the stock of a moment; a caliper does not snap to ends of moves", () => {
    const bar = [line(at(2.2, 26.05), at(-60, 26.05))];
    const both = snappingOf(drawing({ blank: [bar], stock: [bar], path: [at(-33.3, 26.4)] }));
    expect(snapAt(both, at(-33.3, 26.3), REACH, "surface").edge?.of).toBe("blank");
    expect(snapAt(both, at(-33.3, 26.3), REACH, "point").spot).toBe("path");
  });

  test("keys walk what the tool can measure, and the stop after the last is the first", () => {
    expect(stopsOf(snapping, "arc").map(({ edge }) => edge?.element)).toEqual([2]);
    expect(stopsOf(snapping, "line").map(({ edge }) => [edge?.of, edge?.element])).toEqual([
      ["contour", 0],
      ["contour", 1],
      ["contour", 3],
      ["contour", 4],
      ["blank", 0],
    ]);
    const points = stopsOf(snapping, "point"),
      last = points.at(-1);
    expect(last?.at).toEqual(at(3.2, 9.1));
    expect(last && nextStop(points, last.at, 1)?.at).toEqual(at(0, 7.35));
    expect(nextStop(points, at(5, 5), -1)?.at).toEqual(at(3.2, 9.1));
    // A face has many diameters: only its corners are stops of the caliper.
    expect(stopsOf(snapping, "surface").some(({ at: p }) => part.apart(p, at(-14.87, 15.5587)) < 0.1)).toBe(false);
  });

  test("the axis of a solid bar is no edge, a line at Y0 of a plane is one", () => {
    const chain = [line(at(0, 0), at(-30.3, 0)), line(at(-30.3, 0), at(-30.3, 8))];
    expect(stopsOf(snappingOf(drawing({ contours: [chain] })), "line")).toHaveLength(1);
    expect(stopsOf(snappingOf(drawing({ contours: [chain], isTurned: false })), "line")).toHaveLength(2);
  });
});

describe("measured values", () => {
  const bore: Measurable = drawing({
    contours: [[line(at(0, 15.255), at(-22.1, 15.255)), line(at(-22.1, 15.255), at(-22.1, 9.8))]],
  });
  test.each<[string, number | undefined, number | undefined]>([
    ["the diameter of a cylinder", value("diameter", drawing(), at(-7.77, 8.6)), 17],
    ["the same on the mirrored side", value("diameter", drawing(), at(-7.77, -8.6)), 17],
    ["the diameter of a bore", value("diameter", bore, at(-9.4, 15.1)), 30.51],
    ["the diameter of a cone where it is tapped", value("diameter", drawing(), at(-28.085, 22.17375)), 44.3475],
    ["the diameter on the axis is none", value("diameter", drawing(), at(5, 0)), undefined],
    ["a length between a face and a corner", value("length", drawing(), at(-14.9, 15.3), at(-1.1, 8.4)), 13.72],
    ["a step", value("depth", drawing(), at(-7, 8.4), at(-14.8, 21.1)), 12.5175],
    ["from a place below the axis to one above it", value("depth", drawing(), at(-7, -8.4), at(-7, 8.4)), 17],
    ["a distance", value("distance", drawing(), at(0, 7.3), at(-1.2, 8.6)), Math.hypot(1.15, 1.15)],
    ["a radius, tapped beside its arc", value("radius", drawing(), at(-14.5, 8.7)), 1.6],
    ["no radius far from any arc", value("radius", drawing(), at(-40, 23)), undefined],
    ["a chamfer to the axis", value("angle", drawing(), at(-0.4, 7.9), at(-0.4, 7.9)), 45],
    ["a cylinder lies along the axis", value("angle", drawing(), at(-7, 8.4), at(-7.5, 8.4)), 0],
    ["a face stands on it", value("angle", drawing(), at(-14.9, 15), at(30, 1)), 90],
    ["a cone to the axis", value("angle", drawing(), at(-30, 22), at(-30, 22)), 5.0],
    ["between a face and a cone", value("angle", drawing(), at(-14.9, 14), at(-30, 22.2)), 95.0],
    ["between chamfer and cylinder", value("angle", drawing(), at(-0.4, 7.9), at(-7, 8.4)), 135],
    [
      "two cylinders make no angle",
      value("angle", drawing({ contours: [shaft, [line(at(0, 3.1), at(-9, 3.1))]] }), at(-7, 8.5), at(-7, 3.1)),
      undefined,
    ],
  ])("%s", (_, read, wanted) => {
    if (wanted === undefined) expect(read).toBeUndefined();
    else expect(read).toBeCloseTo(wanted, 3);
  });

  test("the angle of an edge is the same from both its ends, and on both sides of the axis", () =>
    fc.assert(
      fc.property(
        fc.double({ min: -180, max: 180, noNaN: true }),
        fc.double({ min: 1, max: 40, noNaN: true }),
        (degrees, long) => {
          const [a, way] = [at(-31.7, 55.1), part.heading((degrees * Math.PI) / 180)],
            b = part.beyond(a, way, long);
          const of = (segment: Segment, side: number) => {
            const middle = part.pointOn(segment, 0.5);
            const edge = { of: "contour", chain: 0, element: 0, shape: "", segment } as const;
            return measuredFigure("angle", [{ at: at(middle.z, side * middle.r), spot: "edge", edge }], true)?.value;
          };
          const wanted = of(line(a, b), 1);
          expect(wanted).toBeLessThanOrEqual(90);
          expect(of(line(b, a), 1)).toBeCloseTo(wanted ?? NaN, 6);
          expect(of(line(a, b), -1)).toBeCloseTo(wanted ?? NaN, 6);
        },
      ),
    ));

  test("in a plane that is not turned a diameter is that of a circle, and Y below zero is not mirrored", () => {
    const circle: Segment = {
      kind: "arc",
      from: at(31.2, -17.9),
      to: at(31.2, -17.9),
      centre: at(24.5, -17.9),
      turn: "ccw",
    };
    const plane = drawing({ contours: [[circle], [line(at(0, -5.5), at(12, -9))]], isTurned: false });
    expect(value("diameter", plane, at(24.5, -24.3))).toBeCloseTo(13.4, 9);
    expect(value("diameter", plane, at(6, -7.25))).toBeUndefined();
    const [place] = taken("distance", plane, at(0.1, -5.4), at(12.1, -9.2));
    expect(place?.at).toEqual(at(0, -5.5));
  });
});

/** A ring by chords of arcs and corners, rounded as the polygon engine does. */
const ringOf = (chain: readonly Segment[]): Ring =>
  part
    .flattenedChain(chain, 0.001)
    .slice(0, -1)
    .map((p) => at(Math.round(p.z * 1e5) / 1e5, Math.round(p.r * 1e5) / 1e5));

describe("the outline of stock", () => {
  const ball: readonly Segment[] = [
    line(at(-41.7, 0), at(-20.33, 0)),
    line(at(-20.33, 0), at(-20.33, 2.51)),
    // An arc of more than half a turn: a ball on a neck.
    { kind: "arc", from: at(-20.33, 2.51), to: at(-25.6, 2.51), centre: at(-22.965, 9.337), turn: "ccw" },
    line(at(-25.6, 2.51), at(-41.7, 2.51)),
    line(at(-41.7, 2.51), at(-41.7, 0)),
  ];

  test("arcs are arcs again, with their centre and radius, and corners stay corners", () => {
    const chain = chainOfRing(ringOf(ball)),
      [arc] = chain.filter((s) => s.kind === "arc");
    expect(chain.map((s) => s.kind).sort()).toEqual(["arc", "line", "line", "line", "line"]);
    expect(arc && part.radiusOf(arc)).toBeCloseTo(Math.hypot(2.635, 6.827), 2);
    expect(arc && part.sweepOf(arc)).toBeGreaterThan(Math.PI);
    expect(part.apart(arc?.centre ?? at(0, 0), at(-22.965, 9.337))).toBeLessThan(0.003);
  });

  test("its radius is measured, and the wall of a sleeve square to its surface", () => {
    const on = drawing({ contours: [], stock: [chainOfRing(ringOf(ball))] });
    expect(value("radius", on, at(-22.9, 16.6))).toBeCloseTo(7.3179, 2);
    const sleeve = chainOfRing([at(-30.2, 12.25), at(-1.4, 13.1), at(-1.4, 17.77), at(-30.2, 17.77)]);
    const tube = drawing({ contours: [], stock: [sleeve] });
    // Square to the outside: the bore is a cone. At Z-12.2 it lies at 12.78125.
    expect(value("wall", tube, at(-12.2, 17.9))).toBeCloseTo(17.77 - (12.25 + (0.85 * 18) / 28.8), 6);
    expect(value("wall", tube, at(-12.2, -17.9))).toBeCloseTo(17.77 - (12.25 + (0.85 * 18) / 28.8), 6);
    // A solid bar has no wall.
    const bar = chainOfRing([at(-30.2, 0), at(-1.4, 0), at(-1.4, 17.77), at(-30.2, 17.77)]);
    expect(value("wall", drawing({ contours: [], stock: [bar] }), at(-12.2, 17.9))).toBeUndefined();
  });
});

describe("after a change", () => {
  const fingerprintOf = (print: string | null) => (_: Omit<MeasuredMoment, "print">) => print;
  const made = (kind: MeasuredKind, ...pointed: readonly Pt[]): Measurement => ({
    id: "m",
    kind,
    plane: "ZX",
    places: taken(kind, drawing(), ...pointed),
  });
  /** The shaft with its cylinder at another diameter and its shoulder elsewhere. */
  const changed = (r: number, z: number): readonly Segment[] => [
    line(at(0, r - 1.15), at(-1.15, r)),
    line(at(-1.15, r), at(z + 1.6, r)),
    { kind: "arc", from: at(z + 1.6, r), to: at(z, r + 1.6), centre: at(z + 1.6, r + 1.6), turn: "cw" },
    line(at(z, r + 1.6), at(z, 21.0175)),
    line(at(z, 21.0175), at(-41.3, 23.33)),
  ];

  test.each<[string, Measurement, number]>([
    ["a diameter follows its cylinder", made("diameter", at(-7.77, 8.6)), 18.62],
    ["also that of the mirrored side", made("diameter", at(-7.77, -8.6)), 18.62],
    ["a length follows its face", made("length", at(-14.9, 15.3), at(-1.1, 8.4)), 16.03],
    ["a radius stays what it is", made("radius", at(-14.5, 8.7)), 1.6],
  ])("%s", (_, measurement, wanted) => {
    const now = readMeasurement(measurement, {
      ...drawing({ contours: [changed(9.31, -17.18)] }),
      fingerprintOf: fingerprintOf(""),
    });
    expect(now?.value).toBeCloseTo(wanted, 9);
    expect(now?.isStale).toBe(false);
  });

  test("with other elements, only places that still lie on an edge are current; the rest is old and keeps its value", () => {
    const without = changed(8.5, -14.87).filter((s) => s.kind === "line");
    const on = { ...drawing({ contours: [without] }), fingerprintOf: fingerprintOf("") };
    expect(readMeasurement(made("diameter", at(-7.77, 8.6)), on)).toMatchObject({ value: 17, isStale: false });
    const radius = readMeasurement(made("radius", at(-14.5, 8.7)), on);
    expect(radius?.value).toBeCloseTo(1.6, 9);
    expect(radius?.isStale).toBe(true);
    const moved = {
      ...drawing({ contours: [changed(9.02, -14.87).filter((s) => s.kind === "line")] }),
      fingerprintOf: fingerprintOf(""),
    };
    expect(readMeasurement(made("diameter", at(-7.77, 8.6)), moved)).toMatchObject({ value: 17, isStale: true });
  });

  test("a measurement of stock is current while its fingerprint is unchanged; an end of a move while that end exists", () => {
    const place: MeasuredPlace = { at: at(-3.3, 9.25), spot: "free" },
      path: MeasuredPlace = { at: at(1.7, 4.4), spot: "path" };
    const moment: MeasuredMoment = { step: 12, fraction: 0.25, block: 31, print: "abc" };
    const measurement: Measurement = { id: "m", kind: "distance", plane: "ZX", places: [place, path], moment };
    const on = (print: string | null, ends: readonly Pt[]) =>
      readMeasurement(measurement, { ...drawing({ path: ends }), fingerprintOf: fingerprintOf(print) })?.isStale;
    expect(on("abc", [at(1.7, 4.4)])).toBe(false);
    expect(on("abd", [at(1.7, 4.4)])).toBe(true);
    expect(on(null, [at(1.7, 4.4)])).toBe(true);
    expect(on("abc", [at(1.7, 4.5)])).toBe(true);
  });
});

test("a failed pick says why: parallel edges, no distance in that direction, the same place", () => {
  const beside = line(at(-2.31, 30.7), at(-9.74, 30.7)),
    far = drawing({ contours: [[...shaft, beside]] }),
    snapping = snappingOf(far);
  const outcome = (kind: MeasuredKind, one: Pt, other: Pt) => {
    const [a, b] = [one, other].map((p) => snapAt(snapping, p, REACH, snapTargetOf(kind, far)));
    return a && b ? pickedWith(kind, snapping, b, a) : null;
  };
  const [seat, face] = [at(-7.3, 8.5), at(-14.87, 15.2)];
  expect(outcome("angle", seat, at(-5.1, 30.7))).toBe("parallel");
  expect(outcome("angle", seat, face)).toHaveProperty("measured.length", 2);
  expect(outcome("length", at(-14.87, 10.1), at(-14.87, 21.0175))).toBe("level");
  expect(outcome("depth", at(-1.15, 8.5), at(-13.27, 8.5))).toBe("level");
  expect(outcome("depth", at(-14.87, 10.1), at(-14.87, 21.0175))).toHaveProperty("measured.length", 2);
  expect(outcome("distance", at(-1.15, 8.5), at(-13.27, 8.5))).toHaveProperty("measured.length", 2);
  expect(outcome("distance", face, face)).toBe("nothing");
});
