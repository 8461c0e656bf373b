import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { at, part } from "../../kernel/geometry/point.ts";
import { parse } from "../../nc/parse.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { contourOf, propose, readDrawing } from "../../program/drawing/formats.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { writeDxf } from "../../program/drawing/write-dxf.ts";
import { simulate } from "../../sim/simulate.ts";
import { bodyMesh, bodyStl } from "../../view/solid/export.ts";
import { volumeOf } from "../../view/solid/mesh.ts";
import { bodiesOf, contoursOf, drawnTogether, layersOf, turnedMoment, type OfferedBody } from "./exports.ts";

const head = `0 BEGIN PGM V MM
1 BLK FORM CYLINDER Z D75 L101.3 DIST+1.3
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX2500
5 M136
6 L X+160 Z+60 R0 FMAX
`;
const cycle = `7 CYCL DEF 812 ABSATZ LAENGS ERW. ~
 Q215=+0 ~
 Q460=+2 ~
 Q491=+75 ~
 Q492=+0 ~
 Q493=+50.5 ~
 Q494=-55.3 ~
 Q495=+0 ~
 Q501=+0 ~
 Q502=+0.5 ~
 Q500=+1.5 ~
 Q496=+0 ~
 Q503=+0 ~
 Q504=+0.5 ~
 Q463=+3 ~
 Q478=+0.3 ~
 Q483=+0.4 ~
 Q484=+0.2 ~
 Q505=+0.2 ~
 Q506=+0
8 L X+75 Z+2 R0 FMAX
9 CYCL CALL
`;
const facing = `10 L X+80 Z+0 R0 FMAX
11 L X-1.6 F0.2
12 L Z+5 FMAX
`;

function made(body: string) {
  const ran = run(parse(`${head}${body}20 END PGM V MM\n`), { tools: shippedTools, rapid: 8_000 });
  const simulation = simulate({
    blank: ran.blank,
    stated: ran.stated,
    steps: ran.steps,
    operations: ran.operations,
    unproved: ran.unproved,
  });
  return { ran, simulation, bodies: bodiesOf(ran, simulation, { step: ran.steps.length, fraction: 0 }) };
}
const volume = (body: OfferedBody) => ("rings" in body ? volumeOf(bodyMesh(body).mesh) : NaN);
/** Volume of a disc, mm³. */
const disc = (r: number, long: number) => Math.PI * r * r * long;

test("the finished part has the volume of its drawing, the blank that of the bar, the stock is in between", () => {
  const { bodies, ran } = made(cycle);
  expect(ran.operations.length).toBe(1);
  // The rounding in the corner adds its fillet, at its centroid.
  const fillet = 2 * Math.PI * (25.25 + 0.3351) * (1 - Math.PI / 4) * 1.5 ** 2;
  expect(volume(bodies.part) / (disc(25.25, 55.3 + 1.3) + disc(37.5, 44.7) + fillet)).toBeCloseTo(1, 2);
  expect(Math.abs(volume(bodies.blank) / disc(37.5, 101.3) - 1)).toBeLessThan(0.001);
  expect(volume(bodies.stock)).toBeGreaterThan(volume(bodies.part) - 1);
  expect(volume(bodies.stock)).toBeLessThan(volume(bodies.part) * 1.01);
});

test("what moves outside the cycles face off is not in the finished part", () => {
  const [plain, faced] = [made(cycle), made(cycle + facing)];
  expect(volume(plain.bodies.part) - volume(faced.bodies.part)).toBeGreaterThan(0.97 * disc(25.25, 1.3));
  expect(volume(plain.bodies.part) - volume(faced.bodies.part)).toBeLessThan(1.03 * disc(25.25, 1.3));
});

test("a part without cycles is the stock that the moves leave at the end", () => {
  const { part: left, blank } = made(facing).bodies;
  expect("isLeft" in left && left.isLeft).toBe(true);
  expect("isLeft" in made(cycle).bodies.part).toBe(false);
  expect((volume(blank) - volume(left)) / disc(37.5, 1.3)).toBeCloseTo(1, 1);
});

test("a missing body gives its reason", () => {
  expect(made("").bodies.part).toEqual({ lack: "noCycle" });
  const none = run(parse("0 BEGIN PGM V MM\n1 END PGM V MM\n"), { tools: shippedTools, rapid: 8_000 });
  const simulation = simulate({ blank: [], steps: [], operations: [], unproved: [] });
  expect(bodiesOf(none, simulation, { step: 0, fraction: 0 }).stock).toEqual({ lack: "noBlank" });
  expect(contoursOf(none)).toEqual([]);
});

const readBack = (text: string) => readDrawing({ name: "a.dxf", bytes: new TextEncoder().encode(text) });

test("the contour of a cycle survives export and import as DXF", async () => {
  const contours = contoursOf(made(cycle + cycle).ran),
    text = writeDxf(layersOf(contours), false, "mm");
  expect(contours.length).toBe(1);
  const drawing = await readBack(text),
    { rows } = contourOf(drawing, propose(drawing));
  const { segments } = readRows(rows).contour,
    was = contours[0]?.segments ?? [];
  expect(segments.map((s) => s.kind)).toEqual(was.map((s) => s.kind));
  expect(segments.some((s) => s.kind === "arc")).toBe(true);
  segments.forEach((s, i) => expect(part.apart(s.to, was[i]?.to ?? s.from)).toBeLessThan(0.001));
});

test("a part as thin as a pin keeps its volume in the file", () => {
  const pin = [at(-13.7, 0), at(0.3, 0), at(0.3, 1.45), at(-13.7, 1.45)],
    { bytes, volume: said } = bodyStl({ rings: [pin], threads: null }, "pin");
  const view = new DataView(bytes.buffer),
    count = view.getUint32(80, true);
  let sum = 0;
  for (let t = 0; t < count; t += 1) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = Array.from({ length: 9 }, (_, k) =>
      view.getFloat32(96 + 50 * t + 4 * k, true),
    ) as [number, number, number, number, number, number, number, number, number];
    sum += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
  }
  expect(sum / 1000 / said).toBeCloseTo(1, 5);
  expect(Math.abs(sum / disc(1.45, 14) - 1)).toBeLessThan(0.001);
});

test("threads leave as helices: half a lead on, a cut through the finished part shows grooves where crests were", () => {
  const text = readFileSync("tests/programs/cycle-831.h", "utf8"),
    ran = run(parse(text), { tools: shippedTools, rapid: 8_000 });
  const { blank, stated, steps, operations, unproved } = ran,
    simulation = simulate({ blank, stated, steps, operations, unproved });
  const { part: whole, stock } = bodiesOf(ran, simulation, { step: steps.length, fraction: 0 });
  if (!("rings" in whole) || !("rings" in stock)) throw new Error("there are bodies");
  const {
    mesh: { positions },
    hasRings,
  } = bodyMesh(whole);
  expect(hasRings).toBe(false);
  expect(bodyMesh({ ...whole, rings: [...whole.rings, [at(-5, 1), at(-4, 1), at(-4, 30)]] }).hasRings).toBe(true);
  /** Places of thread roots along one line of the surface, which a half plane cuts. */
  const roots = (isUp: boolean) => {
    const found: number[] = [];
    for (let i = 0; i < positions.length; i += 3) {
      const [x = 0, y = 0, z = 0] = positions.subarray(i, i + 3);
      if (Math.abs(y) < 1e-6 && x > 0 === isUp && Math.abs(Math.abs(x) - 14.36) < 0.03 && z > -20) found.push(z);
    }
    const last = found.sort((a, b) => a - b).filter((z, i) => i === 0 || z - (found[i - 1] ?? 0) > 1);
    return last.map((z) => ((z % 3.5) + 3.5) % 3.5);
  };
  const [up, down] = [roots(true), roots(false)];
  expect(up.length).toBeGreaterThan(3);
  expect(down.length).toBeGreaterThan(3);
  const apart = ((((down[0] ?? 0) - (up[0] ?? 0)) % 3.5) + 3.5) % 3.5;
  expect(apart).toBeCloseTo(1.75, 1);
  expect(volume(stock) / volume(whole)).toBeCloseTo(1, 2);
});

/** Edges of triangles that overlap, or have no opposite edge. */
function doubtfulEdges(bytes: Uint8Array<ArrayBuffer>): number {
  const view = new DataView(bytes.buffer),
    count = view.getUint32(80, true),
    corners = new Map<string, number>(),
    edges = new Map<number, number>();
  const numberOf = (at: number): number => {
    const place = `${view.getFloat32(at, true)} ${view.getFloat32(at + 4, true)} ${view.getFloat32(at + 8, true)}`;
    const known = corners.get(place) ?? corners.size;
    corners.set(place, known);
    return known;
  };
  // More corners than a body has: an edge is one number of both.
  const most = 3 * count;
  for (let t = 0; t < count; t += 1) {
    const [a, b, c] = [0, 12, 24].map((n) => numberOf(96 + 50 * t + n)) as [number, number, number];
    for (const edge of [a * most + b, b * most + c, c * most + a]) edges.set(edge, (edges.get(edge) ?? 0) + 1);
  }
  const opposite = (edge: number) => (edge % most) * most + Math.floor(edge / most);
  return [...edges].filter(([edge, times]) => times !== 1 || edges.get(opposite(edge)) !== 1).length;
}

test.each(["cycle-830", "cycle-831", "cycle-832", "groove-852", "shoulder-inch"])(
  "every edge of the bodies of %s has two triangles",
  (name) => {
    const ran = run(parse(readFileSync(`tests/programs/${name}.h`, "utf8")), { tools: shippedTools, rapid: 8_000 });
    const { blank, stated, steps, operations, unproved } = ran,
      simulation = simulate({ blank, stated, steps, operations, unproved });
    const bodies = bodiesOf(ran, simulation, { step: steps.length, fraction: 0 });
    for (const body of [bodies.part, bodies.blank, bodies.stock]) {
      if (!("rings" in body)) throw new Error("there are bodies");
      const { bytes, volume: said } = bodyStl(body, name);
      expect(doubtfulEdges(bytes)).toBe(0);
      expect(said).toBeGreaterThan(0);
    }
  },
);

/** Two passes around one contour with a rounding, and a cycle in the same program. */
const milling = `30 FUNCTION MODE MILL
31 TOOL DEF 9 L+0 R+3.2
32 TOOL CALL 9 Z S3000
33 L X-31 Y-27 Z+20 R0 FMAX
34 L Z-2.3 F300
35 LBL 4
36 APPR LT X-12.7 Y-11.4 LEN6 RL F250
37 L Y+13.9
38 RND R4.6
39 L X+15.1
40 CR X-12.7 Y-11.4 R+41.3 DR-
41 DEP LT LEN6
42 L IZ-1.1
43 CALL LBL 4 REP1
`;

test("the contour of an approach is exported once, X and Y as programmed, separate from the turning contours", async () => {
  const both = contoursOf(made(cycle + milling).ran),
    milled = both.filter(({ plane }) => plane === "XY");
  expect(both.map(({ plane, cycle: of }) => [plane, of])).toEqual([
    ["ZX", 812],
    ["XY", null],
  ]);
  expect([drawnTogether(both), drawnTogether(milled)]).toEqual([false, true]);
  const { curves } = await readBack(writeDxf(layersOf(milled), false, "mm")),
    radii = curves.map(({ segment: s }) => (s.kind === "arc" ? part.radiusOf(s) : null));
  expect(curves[0]?.segment).toEqual(part.line(at(-12.7, -11.4), at(-12.7, 9.3)));
  expect(radii).toEqual([null, expect.closeTo(4.6, 9), null, expect.closeTo(41.3, 9)]);
});

test("a milled program exports its block, X, Y and Z as programmed; milling of a turned part exports the turned stock", () => {
  const plate = run(parse(`1 BLK FORM 0.1 Z X-3.7 Y+1.3 Z-19.4\n2 BLK FORM 0.2 X+81.9 Y+47.2 Z+0.6\n${milling}`), {
    tools: shippedTools,
    rapid: 8_000,
  });
  const none = simulate({ blank: [], steps: [], operations: [], unproved: [] });
  const { part: finished, blank } = bodiesOf(plate, none, { step: 0, fraction: 0 });
  expect([finished, blank]).toEqual([
    { lack: "noTurning" },
    {
      block: { left: -3.7, right: 81.9, low: 1.3, high: 47.2, bottom: -19.4, top: 0.6 },
    },
  ]);
  if (!("block" in blank)) throw new Error("no block");
  const { bytes, volume: said } = bodyStl(blank, "block"),
    view = new DataView(bytes.buffer);
  expect(said).toBeCloseTo((85.6 * 45.9 * 20) / 1000, 4);
  // Each edge exists once in each direction, so the surface is closed.
  const corner = (t: number, k: number) =>
    [0, 1, 2].map((n) => view.getFloat32(96 + 50 * t + 12 * k + 4 * n, true).toFixed(3)).join(" ");
  const edges = Array.from({ length: view.getUint32(80, true) }, (_, t) =>
    [0, 1, 2].map((k) => [corner(t, k), corner(t, (k + 1) % 3)] as const),
  ).flat();
  const known = new Set(edges.map((edge) => edge.join("|")));
  expect(known.size).toBe(36);
  for (const [a, b] of edges) expect(known.has(`${b}|${a}`)).toBe(true);

  const mixed = made(
    `${cycle}${milling}50 FUNCTION MODE TURN\n51 TOOL CALL 1\n52 L X+80 Z+3 R0 FMAX\n53 L X+70 FMAX\n`,
  ).ran;
  const before = mixed.plane[0]?.turned ?? NaN;
  expect(before).toBeGreaterThan(10);
  expect(before).toBeLessThan(mixed.steps.length);
  expect(turnedMoment(mixed, { step: mixed.plane.length, fraction: 0 }, true)).toEqual({ step: before, fraction: 0 });
  expect(turnedMoment(mixed, { step: 3, fraction: 0.4 }, false)).toEqual({ step: 3, fraction: 0.4 });
});
