import fc from "fast-check";
import { expect, test } from "vitest";
import { contourOf, propose, readDrawing } from "../../src/program/drawing/formats.ts";
import { readRows } from "../../src/program/job/contour-rows.ts";
import { asBinary, asText, bytesOf, dxfGroups, groupsOf, utf8, type Group } from "./dxf-file.ts";
import { entityCases } from "./entity-cases.ts";

/** Reads a file and takes a contour from it in every way; the numbers of a contour are finite. */
async function survived(bytes: Uint8Array): Promise<void> {
  const drawing = await readDrawing({ name: "x.dxf", bytes });
  for (const half of ["upper", "lower"] as const) {
    const choice = propose(drawing, { half }),
      { segments, rows } = contourOf(drawing, { ...choice, gap: 1 });
    for (const s of segments)
      for (const p of [s.from, s.to]) expect(Number.isFinite(p.z) && Number.isFinite(p.r)).toBe(true);
    readRows(rows);
  }
}
const sane = fc.constantFrom(
  "0",
  "1",
  "-1",
  "12",
  "-18",
  "0.5",
  "1e9",
  "-1e-9",
  "1e308",
  "NaN",
  "",
  "x",
  "99999999999",
);
const value = fc.oneof(sane, fc.integer({ min: -60, max: 60 }).map(String));
const code = fc.constantFrom(
  8,
  10,
  20,
  30,
  11,
  21,
  31,
  40,
  41,
  42,
  44,
  45,
  50,
  51,
  38,
  60,
  62,
  67,
  70,
  71,
  72,
  73,
  210,
  220,
  230,
);
const kind = fc.constantFrom("LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE", "VERTEX", "SEQEND", "INSERT 2 B", "TEXT", "DIMENSION", "ENDSEC", "ENDBLK", "TABLE"); // oxfmt-ignore
const entity = fc
  .tuple(kind, fc.array(fc.tuple(code, value), { maxLength: 24 }))
  .map(([type, groups]): Group[] => [...groupsOf(type), ...groups]);

test("entities of any groups and numbers", async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(entity, { maxLength: 14 }), fc.boolean(), async (entities, binary) => {
      const groups: Group[] = [
        ...dxfGroups({ entities: [], blocks: { B: ["LINE 8 0 10 0 20 1 11 3 21 4", "INSERT 8 0 2 C"], C: ["INSERT 8 0 2 B"] } }).slice(0, -2),
        ...entities.flat(),
        [0, "ENDSEC"],
        [0, "EOF"],
      ]; // oxfmt-ignore
      await survived(binary ? asBinary(groups) : utf8(asText(groups)));
    }),
    { numRuns: 200 },
  );
});

test("files with bytes that are changed, lost or cut off", async () => {
  const files = entityCases.map(([, bytes]) => bytes);
  await fc.assert(
    fc.asyncProperty(
      fc.nat({ max: files.length - 1 }),
      fc.array(fc.tuple(fc.double({ min: 0, max: 1, noNaN: true }), fc.nat({ max: 255 })), { maxLength: 6 }),
      fc.double({ min: 0.2, max: 1, noNaN: true }),
      async (index, changes, kept) => {
        const bytes = Uint8Array.from(files[index] ?? []);
        for (const [place, to] of changes) bytes[Math.floor(place * (bytes.length - 1))] = to;
        await survived(bytes.slice(0, Math.ceil(bytes.length * kept)));
      },
    ),
    { numRuns: 80 },
  );
});

test("any bytes behind a true beginning", async () => {
  await fc.assert(
    fc.asyncProperty(fc.uint8Array({ maxLength: 300 }), fc.boolean(), async (tail, binary) => {
      const head = binary ? bytesOf("AutoCAD Binary DXF\r\n\u001a\0") : utf8("0\nSECTION\n2\nENTITIES\n0\nLINE\n");
      await survived(Uint8Array.from([...head, ...tail]));
    }),
    { numRuns: 80 },
  );
});

/** Lines in a net: every one crosses every other of the other direction. */
const net = (count: number) =>
  Array.from({ length: count }, (_, i) => [`LINE 8 0 10 0 20 ${i} 11 ${count} 21 ${i}`, `LINE 8 0 10 ${i} 20 0 11 ${i} 21 ${count}`]).flat(); // oxfmt-ignore
const many = (count: number, make: (i: number) => string) => Array.from({ length: count }, (_, i) => make(i));

test.each([
  ["a net of lines", net(60)],
  ["many loose ends", many(2000, (i) => `LINE 8 0 10 ${(i * 37) % 100} 20 ${(i * 61) % 97} 11 ${(i * 37) % 100}.4 21 ${(i * 61) % 97}.3`)],
  ["lines on one line", many(2000, (i) => `LINE 8 0 10 ${i} 20 5 11 ${i}.5 21 5`)],
  ["circles about one point", many(800, (i) => `CIRCLE 8 0 10 0 20 0 40 ${1 + i / 100}`)],
  ["a spline with many points", [`SPLINE 8 0 70 8 71 3 ${many(600, (i) => `10 ${i / 10} 20 ${5 + ((i * 7919) % 13)}`).join(" ")}`]],
  ["wild ellipses", many(40, (i) => `ELLIPSE 8 0 10 ${i} 20 9 11 ${1e6 + i} 21 3 40 0.000001 41 0 42 6.283`)],
] as const)("%s: bounded in time and curves", async (_, entities) => {
  await survived(utf8(asText(dxfGroups({ entities }))));
}); // oxfmt-ignore
