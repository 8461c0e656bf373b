import DxfParser from "dxf-parser";
import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { contourStatements } from "../job/print-contour.ts";
import { readRows } from "../job/contour-rows.ts";
import { dxfDefaults, readDxf, type DxfChoice, type ParsedDxf } from "./read-dxf.ts";

/** A DXF file of these entities, as written by CAD: group codes and values on separate lines. */
const file = (entities: readonly (readonly (string | number)[])[], header: readonly (string | number)[] = []) =>
  [
    "0",
    "SECTION",
    "2",
    "HEADER",
    ...header,
    "0",
    "ENDSEC",
    "0",
    "SECTION",
    "2",
    "ENTITIES",
    ...entities.flat(),
    "0",
    "ENDSEC",
    "0",
    "EOF",
  ].join("\n");
const line = (x1: number, y1: number, x2: number, y2: number) => [
  0,
  "LINE",
  8,
  0,
  10,
  x1,
  20,
  y1,
  30,
  0,
  11,
  x2,
  21,
  y2,
  31,
  0,
];
const arc = (x: number, y: number, r: number, from: number, to: number) => [
  0,
  "ARC",
  8,
  0,
  10,
  x,
  20,
  y,
  30,
  0,
  40,
  r,
  50,
  from,
  51,
  to,
];
const polyline = (closed: boolean, ...points: readonly (readonly [number, number, number?])[]) => [
  0,
  "LWPOLYLINE",
  8,
  0,
  90,
  points.length,
  70,
  closed ? 1 : 0,
  ...points.flatMap(([x, y, bulge]) => [10, x, 20, y, ...(bulge === undefined ? [] : [42, bulge])]),
];
const parsed = (text: string) => new DxfParser().parseSync(text) as ParsedDxf;
const read = (
  entities: readonly (readonly (string | number)[])[],
  choice: Partial<DxfChoice> = {},
  header: readonly (string | number)[] = [],
) => readDxf(parsed(file(entities, header)), { ...dxfDefaults, ...choice });
const short = (r: ReturnType<typeof read>) =>
  r.rows.map((x) => [x.kind, x.x, x.z, x.r, x.kind === "CR" ? x.turn : ""].filter((s) => s !== "").join(" "));
const codes = (r: ReturnType<typeof read>) => r.issues.map((i) => i.code);

describe("a drawing becomes rows", () => {
  test("lines in any order and direction are joined into one chain, x as Z and y as the radius", () => {
    const r = read([line(-20, 10, -20, 25), line(0, 10, -20, 10), line(-50, 25, -20, 25)]);
    expect(short(r)).toEqual(["L 20 0", "L -20", "L 50", "L -50"]);
    expect(r.issues).toEqual([]);
    expect(readRows(r.rows).issues).toEqual([]);
  });

  test("an arc keeps its circle and its turn, forwards and backwards", () => {
    const entities = [line(0, 10, -15, 10), arc(-15, 15, 5, 180, 270), line(-20, 15, -20, 30)];
    expect(short(read(entities))).toEqual(["L 20 0", "L -15", "CR 30 -20 5 cw", "L 60"]);
    expect(short(read(entities, { reversed: true }))).toEqual(["L 60 -20", "L 30", "CR 20 -15 5 ccw", "L 0"]);
    const { contour } = readRows(read(entities).rows);
    expect(contour.segments[1]).toMatchObject({ kind: "arc", centre: { z: -15, r: 15 } });
  });

  test("a polyline with a bulge: a quarter circle, and the longer way round", () => {
    expect(short(read([polyline(false, [0, 10], [-15, 10, -Math.tan(Math.PI / 8)], [-20, 15], [-20, 30])]))).toEqual([
      "L 20 0",
      "L -15",
      "CR 30 -20 5 cw",
      "L 60",
    ]);
    const long = read([polyline(false, [0, 10, Math.tan((Math.PI * 3) / 8)], [-5, 15])]);
    expect(long.rows[1]).toMatchObject({ kind: "CR", r: "-5", turn: "ccw" });
  });

  test("swapped and flipped axes mirror the arcs as well; Z0 can be put at the right end", () => {
    const entities = [line(10, 0, 10, -15), arc(15, -15, 5, 180, 270)];
    expect(short(read(entities, { swapped: true }))).toEqual(["L 20 0", "L -15", "CR 30 -20 5 cw"]);
    expect(short(read([line(0, 10, 15, 10), arc(15, 15, 5, 270, 360)], { flipped: true }))).toEqual([
      "L 20 0",
      "L -15",
      "CR 30 -20 5 cw",
    ]);
    expect(short(read([line(100, 10, 80, 10)], { zeroRight: true }))).toEqual(["L 20 0", "L -20"]);
  });

  test("X as diameter, and a drawing in inches", () => {
    expect(short(read([line(0, 20, -20, 50)], { diameters: true }))).toEqual(["L 20 0", "L 50 -20"]);
    const inches = read([line(0, 1, -2, 1)], {}, [9, "$INSUNITS", 70, 1]);
    expect(short(inches)).toEqual(["L 50.8 0", "L -50.8"]);
    expect(codes(inches)).toEqual(["inches"]);
  });
});

describe("what is wrong with a drawing is named", () => {
  test("gaps are closed up to the tolerance and no farther", () => {
    const entities = [line(0, 10, -20, 10), line(-20.03, 10, -20.03, 30)];
    const open = read(entities);
    expect(open.chains).toBe(2);
    expect(codes(open)).toEqual(["chains"]);
    const closed = read(entities, { tolerance: 0.05 });
    expect(closed.chains).toBe(1);
    expect(closed.issues).toMatchObject([{ code: "gapsClosed", count: 1 }]);
    expect(closed.issues[0]).toHaveProperty("widest", expect.closeTo(0.03, 6));
  });

  test("the line gives way to the arc at a closed gap", () => {
    const r = read([line(0, 10, -14.99, 10), arc(-15, 15, 5, 180, 270)], { tolerance: 0.05 });
    expect(short(r)).toEqual(["L 20 0", "L -15", "CR 30 -20 5 cw"]);
  });

  test("nothing to read, arcs on diameters, a contour below the axis, other entities, a branch", () => {
    expect(codes(read([]))).toEqual(["nothing"]);
    expect(codes(read([[0, "CIRCLE", 8, 0, 10, 0, 20, 0, 40, 5], line(0, 10, -5, 10)]))).toEqual(["skipped"]);
    expect(codes(read([line(0, 10, -15, 10), arc(-15, 15, 5, 180, 270)], { diameters: true }))).toEqual([
      "arcsInDiameters",
    ]);
    expect(codes(read([line(0, 10, -5, -10)]))).toEqual(["belowAxis"]);
    expect(codes(read([line(0, 10, -10, 10), line(-10, 10, -20, 10), line(-10, 10, -10, 30)]))).toContain("branch");
    expect(codes(read([line(0, 0, -10, 0)]))).toEqual(["onlyAxis"]);
  });

  test("the line of the axis of a closed half section is left out, which opens it", () => {
    const r = read([polyline(true, [0, 0], [0, 10], [-20, 10], [-20, 0])]);
    expect(codes(r)).toEqual(["axisDropped"]);
    expect(short(r)).toEqual(["L 0 0", "L 20", "L -20", "L 0"]);
  });

  test("odd output of a parser does not throw", () => {
    const odd = {
      entities: [
        null,
        3,
        {},
        { type: "LINE" },
        { type: "ARC", center: { x: NaN, y: 0 } },
        { type: "LWPOLYLINE", vertices: [{ x: 1 }] },
      ],
    };
    expect(readDxf(odd, dxfDefaults).issues.map((i) => i.code)).toContain("nothing");
    expect(readDxf({}, dxfDefaults).rows).toEqual([]);
  });
});

describe("laws", () => {
  const points = fc
    .array(fc.record({ x: fc.integer({ min: -200, max: 0 }), y: fc.integer({ min: 1, max: 100 }) }), {
      minLength: 2,
      maxLength: 20,
    })
    .filter((all) => new Set(all.map((p) => `${p.x} ${p.y}`)).size === all.length);

  test("a polyline comes back point by point, from one end or the other", () => {
    fc.assert(
      fc.property(points, fc.boolean(), (all, reversed) => {
        const r = read([polyline(false, ...all.map((p) => [p.x, p.y] as const))], { reversed });
        const ends = readRows(r.rows).rows.map((row) => row.end);
        const wanted = all.map((p) => ({ x: p.y / 0.5, z: p.x }));
        expect([JSON.stringify(wanted), JSON.stringify(wanted.toReversed())]).toContain(JSON.stringify(ends));
      }),
      { numRuns: 200 },
    );
  });

  test("lines shuffled and turned round make the same chain, and their program prints", () => {
    fc.assert(
      fc.property(points, fc.infiniteStream(fc.nat()), (all, numbers) => {
        const lines = all
          .slice(1)
          .map((p, i) => {
            const from = all[i] ?? p,
              [order = 0, turned = 0] = [...numbers.take(2)];
            return { order, entity: turned % 2 ? line(p.x, p.y, from.x, from.y) : line(from.x, from.y, p.x, p.y) };
          })
          .sort((a, b) => a.order - b.order)
          .map((l) => l.entity);
        const r = read(lines);
        expect(r.chains).toBe(1);
        expect(r.rows).toHaveLength(all.length);
        expect(contourStatements(r.rows)).toHaveLength(all.length);
      }),
      { numRuns: 200 },
    );
  });
});
