import { expect, test } from "vitest";
import { at, part, type Segment } from "../src/kernel/geometry/point.ts";
import { DRAWING_ENDINGS } from "../src/program/drawing/endings.ts";
import { readDrawing } from "../src/program/drawing/formats.ts";
import { contourSvg } from "../src/view/contour-svg.ts";
import { MANNERS, Solid } from "./step-solid.ts";

const bush: readonly Segment[] = [
  part.line(at(-20, 8), at(-20, 15)),
  part.line(at(-20, 15), at(0, 15)),
  part.line(at(0, 15), at(0, 8)),
  part.line(at(0, 8), at(-20, 8)),
];
function step(): string {
  const solid = new Solid(MANNERS.seams);
  for (const s of bush) solid.turn(s);
  return solid.text();
}
const SVG = '<svg width="9mm" height="9mm" viewBox="0 0 9 9"><path d="M0 0H9"/></svg>';

test.each([
  ["part.step", step(), 5],
  ["PART.STP", step(), 5],
  ["without ending", step(), 5],
  ["wrong.dxf", step(), 5],
  ["part.svg", SVG, 1],
  ["part", `<?xml version="1.0"?>\n<!-- drawn by hand -->\n${SVG}`, 1],
  ["wrong.step", SVG, 1],
])("%s is read as what it is", async (name, text, count) => {
  const { curves, notes } = await readDrawing({ name, bytes: new TextEncoder().encode(text) });
  expect(notes).toEqual([]);
  expect(curves.length).toBe(count);
});

test("the endings are offered", () => {
  expect(DRAWING_ENDINGS).toEqual(expect.arrayContaining([".dxf", ".step", ".stp", ".svg"]));
});

test("the exported drawing of a contour opens as the same contour", async () => {
  const contour: readonly Segment[] = [
    part.line(at(0, 6.5), at(-12.25, 6.5)),
    { kind: "arc", from: at(-12.25, 6.5), to: at(-15.25, 9.5), centre: at(-12.25, 9.5), turn: "cw" },
    part.line(at(-15.25, 9.5), at(-40, 14)),
  ];
  const text = contourSvg([{ name: "CONTOUR", segments: contour }]) ?? "",
    { curves, unit } = await readDrawing({ name: "contour.svg", bytes: new TextEncoder().encode(text) });
  expect(unit).toEqual({ unit: "mm", source: "file" });
  expect(curves.map((c) => c.segment.kind)).toEqual(contour.map((s) => s.kind));
  contour.forEach((s, i) => {
    for (const k of [0, 0.5, 1])
      expect(part.distanceTo(curves[i]?.segment ?? part.line(at(0, 0), at(0, 0)), part.pointOn(s, k))).toBeLessThan(
        1e-3,
      );
  });
});
