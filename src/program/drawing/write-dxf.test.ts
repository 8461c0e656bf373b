import fc from "fast-check";
import { expect, test } from "vitest";
import { at, part, type Segment } from "../../kernel/geometry/point.ts";
import { readRows } from "../job/contour-rows.ts";
import { contourOf, readDrawing } from "./formats.ts";
import { PLAIN_CHOICE } from "./propose.ts";
import { DXF_CHORD, writeDxf } from "./write-dxf.ts";

const contour: readonly Segment[] = [
  { kind: "line", from: at(0.35, 8.125), to: at(-1.4, 9.875) },
  { kind: "line", from: at(-1.4, 9.875), to: at(-17.3, 9.875) },
  { kind: "arc", from: at(-17.3, 9.875), to: at(-20.8, 13.375), centre: at(-17.3, 13.375), turn: "cw" },
  { kind: "line", from: at(-20.8, 13.375), to: at(-31.25, 13.375) },
  { kind: "arc", from: at(-31.25, 13.375), to: at(-33.75, 15.875), centre: at(-31.25, 15.875), turn: "cw" },
  { kind: "arc", from: at(-33.75, 15.875), to: at(-36.25, 18.375), centre: at(-36.25, 15.875), turn: "ccw" },
  { kind: "line", from: at(-36.25, 18.375), to: at(-48.6, 22.07) },
];
const opened = (text: string) => readDrawing({ name: "a.dxf", bytes: new TextEncoder().encode(text) });
/** The contour of a file, its Z as drawn. */
async function read(text: string, diameters = false) {
  const drawing = await opened(text),
    { rows, notes } = contourOf(drawing, { ...PLAIN_CHOICE, diameters });
  return { rows, notes: [...drawing.notes, ...notes] };
}

test.each([
  ["mm", 4, []],
  ["inch", 1, ["unitConverted"]],
] as const)(
  "our own import reads the same contour back from %s, arcs as arcs with their turn",
  async (unit, code, told) => {
    const text = writeDxf([{ name: "CONTOUR", segments: contour }], false, unit),
      back = await read(text);
    expect(text).toMatch(new RegExp(`\\$INSUNITS\\s+70\\s+${code}\\s`));
    expect(back.notes.map(({ code: said }) => said)).toEqual(told);
    const { segments } = readRows(back.rows).contour;
    expect(segments.map((s) => [s.kind, s.kind === "arc" ? s.turn : ""])).toEqual(
      contour.map((s) => [s.kind, s.kind === "arc" ? s.turn : ""]),
    );
    segments.forEach((s, i) => {
      const was = contour[i];
      if (!was) throw new Error("more than there was");
      for (const k of [0, 0.31, 0.77, 1])
        expect(part.apart(part.pointOn(s, k), part.pointOn(was, k))).toBeLessThan(0.001);
    });
  },
);

test("with X as a diameter arcs are chords near the arc, and read as a diameter they are the same contour", async () => {
  const text = writeDxf([{ name: "CONTOUR", segments: contour }], true, "mm");
  expect(text).not.toContain("ARC");
  const { rows, notes } = await read(text, true);
  expect(notes).toEqual([]);
  expect(rows.at(-1)).toMatchObject({ x: "44.14", z: "-48.6" });
  for (const { from, to } of readRows(rows).contour.segments)
    for (const p of [from, to, at((from.z + to.z) / 2, (from.r + to.r) / 2)])
      expect(Math.min(...contour.map((s) => part.distanceTo(s, p)))).toBeLessThan(DXF_CHORD + 0.001);
});

test("a full circle and any arc come back with their length", async () => {
  const angle = fc.integer({ min: 0, max: 3599 }).map((n) => (n * Math.PI) / 1800),
    size = fc.integer({ min: 301, max: 9999 }).map((n) => n / 100);
  await fc.assert(
    fc.asyncProperty(
      angle,
      angle,
      size,
      fc.constantFrom("cw" as const, "ccw" as const),
      async (start, end, r, turn) => {
        const on = (a: number) => at(-30 + r * Math.cos(a), 150 + r * Math.sin(a));
        const arc: Segment = { kind: "arc", from: on(start), to: on(end), centre: at(-30, 150), turn };
        const { curves } = await opened(writeDxf([{ name: "A", segments: [arc] }], false, "mm"));
        for (const { segment } of curves) expect(segment.kind === "arc" && part.radiusOf(segment)).toBeCloseTo(r, 6);
        expect(curves.reduce((sum, c) => sum + part.lengthOf(c.segment), 0)).toBeCloseTo(part.lengthOf(arc), 5);
      },
    ),
  );
});

test("a file is of release 12: no handles, no markers of classes, millimetres, every group a code and a value", () => {
  const lines = writeDxf(
    [
      { name: "CONTOUR_1", segments: contour },
      { name: "CONTOUR_2", segments: contour.slice(2, 3) },
    ],
    false,
    "mm",
  ).split("\r\n");
  expect(lines.at(-1)).toBe("");
  const codes = lines
    .slice(0, -1)
    .filter((_, i) => i % 2 === 0)
    .map(Number);
  expect(codes.every((c) => Number.isInteger(c) && c < 100)).toBe(true);
  expect(codes).not.toContain(5);
  expect(lines.slice(lines.indexOf("$ACADVER"), lines.indexOf("$ACADVER") + 3)[2]).toBe("AC1009");
  expect(lines.filter((l) => l === "CONTOUR_2").length).toBe(2);
  expect(lines.some((l) => /e[-+]\d|NaN|Infinity/.test(l))).toBe(false);
});
