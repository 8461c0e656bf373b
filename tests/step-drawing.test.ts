import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { at, part, type Segment } from "../src/kernel/geometry/point.ts";
import { readPart21 } from "../src/program/files/part21.ts";
import { drawnContour } from "../src/program/drawing/contour-of.ts";
import { propose } from "../src/program/drawing/propose.ts";
import { crossingOf } from "../src/program/drawing/step/beside.ts";
import { stepBodies } from "../src/program/drawing/step/step-body.ts";
import { stepSurface } from "../src/program/drawing/step/step-surface.ts";
import { readStep } from "../src/program/drawing/step/read-step.ts";
import { MANNERS, Solid, type V } from "./step-solid.ts";

const line = (z1: number, r1: number, z2: number, r2: number): Segment => part.line(at(z1, r1), at(z2, r2));
const arc = (
  from: readonly [number, number],
  to: readonly [number, number],
  centre: readonly [number, number],
  turn: "cw" | "ccw",
): Segment => ({
  kind: "arc",
  from: at(...from),
  to: at(...to),
  centre: at(...centre),
  turn,
});

/** Outlines with z to the right, clockwise: the material is on the right. */
const PARTS: Readonly<Record<string, readonly Segment[]>> = {
  "shaft with cone, fillet and shoulder": [
    line(-60, 0, -60, 15),
    line(-60, 15, -31, 15),
    line(-31, 15, -31, 12),
    arc([-31, 12], [-29, 10], [-29, 12], "ccw"),
    line(-29, 10, -8, 10),
    line(-8, 10, 0, 6.5),
    line(0, 6.5, 0, 0),
  ],
  "ball end, solid": [line(-40, 0, -40, 8), line(-40, 8, -6, 8), arc([-6, 8], [2, 0], [-6, 0], "cw")],
  "bush with groove and rounded edge": [
    line(-25, 11, -25, 18),
    line(-25, 18, -15, 18),
    line(-15, 18, -15, 16.25),
    line(-15, 16.25, -12.5, 16.25),
    line(-12.5, 16.25, -12.5, 18),
    line(-12.5, 18, -2, 18),
    arc([-2, 18], [0, 16], [-2, 16], "cw"),
    line(0, 16, 0, 12.5),
    line(0, 12.5, -1.5, 11),
    line(-1.5, 11, -25, 11),
  ],
};

const read = (text: string, unit?: "mm" | "inch") => readStep(new TextEncoder().encode(text), unit && { unit });
/** Segments without order and direction. */
const same = (a: Segment, b: Segment) =>
  a.kind === b.kind &&
  [0, 0.5, 1].every(
    (k) => part.distanceTo(b, part.pointOn(a, k)) < 1e-5 && part.distanceTo(a, part.pointOn(b, k)) < 1e-5,
  );

describe.each(Object.entries(PARTS))("%s", (_, outline) => {
  test.each(Object.entries(MANNERS))("in the manner of %s", (_name, manner) => {
    const solid = new Solid(manner);
    for (const s of outline) solid.turn(s);
    const drawing = read(solid.text());
    expect(drawing.notes.filter((n) => n.code !== "unitConverted")).toEqual([]);
    expect(drawing.unit).toEqual({ unit: manner.unit === "inch" ? "inch" : "mm", source: "file" });
    const lines = drawing.curves.filter((c) => c.role === "outline").map((c) => c.segment);
    expect(lines.length).toBe(outline.length);
    for (const s of outline) expect(lines.filter((l) => same(l, s)).length).toBe(1);
    expect(drawnContour(drawing, propose(drawing)).notes).toEqual([]);
    const [axis] = drawing.curves.filter((c) => c.role === "centre");
    expect(axis?.segment).toMatchObject({ kind: "line", from: { r: 0 }, to: { r: 0 } });
  });
});

/** A plain shaft with a flat milled into it and a hole beside its axis. */
function milled(): Solid {
  const solid = new Solid({
    ...MANNERS["seams"],
    faces: "seam",
    unit: "mm",
    degrees: false,
    surfaces: "plain",
    axis: "z",
  });
  const hole = (z: number) => solid.round([2, -5, z], [2, -5, z], [0, -5, z], 2);
  const corner = (x: number, z: number): V => [x, 8, z];
  const round = (z: number) => solid.round(corner(6, z), corner(-6, z), [0, 0, z], 10),
    chord = (z: number) => solid.straight(corner(-6, z), corner(6, z)),
    side = (x: number) => solid.straight(corner(x, -30), corner(x, -20));
  solid.turn(line(-40, 0, -40, 10), [hole(-40)]);
  solid.turn(line(-40, 10, 0, 10), [round(-30), side(-6), `-${round(-20)}`, `-${side(6)}`]);
  solid.turn(line(0, 10, 0, 0), [hole(0)]);
  solid.face(solid.plane([0, 8, 0], [0, 1, 0]), true, [chord(-30), side(6), `-${chord(-20)}`, `-${side(-6)}`]);
  for (const z of [-30, -20]) solid.face(solid.plane([0, 0, z], [0, 0, 1]), z < -25, [round(z), chord(z)]);
  const along = solid.straight([2, -5, -40], [2, -5, 0]);
  solid.face(solid.cylinder([0, -5, 0], 2), false, [hole(-40), along, `-${hole(0)}`, `-${along}`]);
  return solid;
}
const outlineOf = (drawing: ReturnType<typeof read>) =>
  drawing.curves.filter((c) => c.role === "outline").map((c) => c.segment);

test("what is milled or drilled beside the axis is left out and named; the turned outline stays whole", () => {
  const drawing = read(milled().text()),
    outline = [line(-40, 0, -40, 10), line(-40, 10, 0, 10), line(0, 10, 0, 0)];
  expect(outlineOf(drawing).length).toBe(3);
  for (const s of outline) expect(outlineOf(drawing).some((l) => same(l, s))).toBe(true);
  expect(drawing.notes).toEqual([
    { code: "notTurned", severity: "warning", values: { shape: "flats", count: 1 } },
    { code: "notTurned", severity: "warning", values: { shape: "holes", count: 1 } },
  ]);
});

test.each([
  ["in the hole", -20, 5, true],
  ["where the circle leaves the hole", -20, 6.9, true],
  ["within the circle of holes", -20, 2.9, false],
  ["outside of it", -20, 7.1, false],
  ["behind its end", -40.1, 5, false],
])("a circle about the axis meets a hole beside it: %s", (_, z, r, meets) => {
  const [body] = stepBodies(readPart21(milled().text())).bodies,
    axis = { origin: [5, 0, 0], direction: [0, 0, 1] } as const;
  const crossings = (body?.faces ?? []).flatMap((face) => {
    const surface = body && stepSurface(body.geometry, face.surface, null);
    return surface?.kind === "cylinder" && !surface.meridian(axis) ? [crossingOf({ face, surface }, axis)] : [];
  });
  expect(crossings.map((c) => c?.(at(z, r)))).toEqual([meets]);
});

test("a chosen unit replaces that of the file", () => {
  const length = (d: ReturnType<typeof read>) => Math.max(...outlineOf(d).map((s) => part.lengthOf(s)));
  const text = milled().text();
  expect(length(read(text, "inch"))).toBeCloseTo(40 * 25.4, 6);
  expect(read(text, "inch").unit).toEqual({ unit: "inch", source: "chosen" });
  expect(length(read(text.replace(/\(GEOMETRIC_REPRESENTATION_CONTEXT[^;]*;/, "X();")))).toBeCloseTo(40, 6);
});

test("of several bodies the largest turned one is drawn; each can be given, by name and size", () => {
  const solid = new Solid(MANNERS.inches);
  const pin = (r: number, length: number) =>
    [line(-length, 0, -length, r), line(-length, r, 0, r), line(0, r, 0, 0)].forEach((s) => solid.turn(s));
  pin(4, 20);
  solid.body("Pin", "Body1");
  pin(10, 50);
  solid.body("Shaft", "Body1");
  pin(6, 8);
  solid.body("Shaft", "Cap");
  const text = solid.text(),
    give = (body: number) => readStep(new TextEncoder().encode(text), { body });
  const sized = (drawing: ReturnType<typeof read>) =>
    drawing.bodies?.all.map(({ name, across, length }) => [name, Math.round(across), Math.round(length)]);
  expect(sized(read(text))).toEqual([
    ["Body1", 20, 50],
    ["Pin", 8, 20],
    ["Cap", 12, 8],
  ]);
  expect(read(text).notes).toContainEqual({
    code: "otherBodies",
    severity: "warning",
    values: { name: "Body1", count: 2, turned: 2 },
  });
  for (const [body, length, drawn] of [
    [0, 50, 0],
    [1, 20, 1],
    [2, 8, 2],
    [7, 50, 0],
  ] as const) {
    expect(give(body).bodies?.drawn).toBe(drawn);
    expect(Math.max(...outlineOf(give(body)).map((s) => Math.abs(s.from.z - s.to.z)))).toBeCloseTo(length, 6);
  }
});

test.each([
  ["no such file", "0\nSECTION", ["unreadable"]],
  ["no solid", "ISO-10303-21;HEADER;ENDSEC;DATA;#1=A();ENDSEC;END-ISO-10303-21;", ["noSolid"]],
  [
    "no face of revolution",
    milled()
      .text()
      .replace(/CYLINDRICAL_SURFACE/g, "SOMETHING"),
    ["noRevolved"],
  ],
  [
    "cut off",
    milled()
      .text()
      .replace(/CLOSED_SHELL[^]*/, ""),
    ["noSolid", "truncated", "broken"],
  ],
])("%s", (_, text, codes) => {
  const { curves, notes } = read(text);
  expect(curves).toEqual([]);
  expect(notes.map((n) => n.code)).toEqual(codes);
});

test("damaged files neither throw nor hang, and yield finite numbers or nothing", () => {
  const texts = [
    milled().text(),
    ...Object.values(MANNERS).map((manner) => {
      const solid = new Solid(manner);
      for (const s of PARTS["bush with groove and rounded edge"] ?? []) solid.turn(s);
      return solid.text();
    }),
  ];
  const damage = fc.tuple(
    fc.nat(texts.length - 1),
    fc.array(
      fc.tuple(
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.constantFrom("", "#1", "0.", "1E300", "(", "')", "*", "-", ".F.", "$"),
      ),
      { minLength: 1, maxLength: 6 },
    ),
  );
  fc.assert(
    fc.property(damage, ([which, cuts]) => {
      const text = cuts.reduce((t, [at01, put]) => {
        const place = Math.floor(at01 * t.length);
        return t.slice(0, place) + put + t.slice(place + 4);
      }, texts[which] ?? "");
      for (const { segment: s } of read(text).curves)
        for (const n of [s.from.z, s.from.r, s.to.z, s.to.r]) expect(Number.isFinite(n)).toBe(true);
    }),
    { numRuns: 80, seed: 10303 },
  );
});
