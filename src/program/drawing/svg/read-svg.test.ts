import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { at, part } from "../../../kernel/geometry/point.ts";
import { readSvg } from "./read-svg.ts";

const read = (text: string, unit?: "mm" | "inch") => readSvg(new TextEncoder().encode(text), unit && { unit });
/** A drawing of 100 × 100 mm whose user unit is 1 mm. */
const svg = (inside: string, attributes = 'width="100mm" height="100mm" viewBox="0 0 100 100"') =>
  `<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="i" ${attributes}>${inside}</svg>`;
const n = (x: number) => Number(x.toFixed(3)) || 0;
const short = (text: string, unit?: "mm" | "inch") =>
  read(text, unit).curves.map(({ segment: s }) => {
    const ends = `${n(s.from.z)} ${n(s.from.r)} > ${n(s.to.z)} ${n(s.to.r)}`;
    return s.kind === "line" ? ends : `${ends} ${s.turn} ${n(s.centre.z)} ${n(s.centre.r)}`;
  });
const codes = (text: string) => read(text).notes.map((note) => note.code);

describe("paths, y of the file downwards", () => {
  test.each<readonly [string, readonly string[]]>([
    ["M10,20 L30 20V40H10z", ["10 -20 > 30 -20", "30 -20 > 30 -40", "30 -40 > 10 -40", "10 -40 > 10 -20"]],
    ["m10 20 20 0 0,20h-20z", ["10 -20 > 30 -20", "30 -20 > 30 -40", "30 -40 > 10 -40", "10 -40 > 10 -20"]],
    ["M10-2.5L.5.25", ["10 2.5 > 0.5 -0.25"]],
    ["M10 20A5 5 0 0115 25", ["10 -20 > 15 -25 cw 10 -25"]],
    ["M10 20a5 5 0 0 0 5 5", ["10 -20 > 15 -25 ccw 15 -20"]],
    ["M10 20A5 5 0 1 1 15 25", ["10 -20 > 15 -25 cw 15 -20"]],
    // Radii that are too small: half a circle on the chord.
    ["M0 0A1 1 0 0 1 10 0", ["0 0 > 10 0 cw 5 0"]],
    ["M0 0A0 4 0 0 1 10 0", ["0 0 > 10 0"]],
    ["M0 0 10 0M0 5l10 0", ["0 0 > 10 0", "0 -5 > 10 -5"]],
    ["M0 0C0 0 10 0 10 0", ["0 0 > 10 0"]],
    // A fault ends the path, as in a browser.
    ["M0 0L10 0L5 x", ["0 0 > 10 0"]],
    ["L10 0", []],
  ])("%s", (d, expected) => expect(short(svg(`<path d="${d}"/>`))).toEqual(expected));

  test("a Bézier quarter of a circle becomes an arc, one curve and its smooth continuation stay within the tolerance", () => {
    const k = 5 * 0.5522847498;
    const round = read(svg(`<path d="M10 20C${10 + k} 20 15 ${25 - k} 15 25"/>`));
    expect(round.tolerance).toBeGreaterThan(0);
    for (const { segment } of round.curves)
      expect(Math.abs(part.apart(part.pointOn(segment, 0.5), at(10, -25)) - 5)).toBeLessThan(0.007);
    const smooth = read(svg('<path d="M0 0Q5 10 10 0T20 0"/>')).curves.map((c) => c.segment);
    expect(n(smooth.at(-1)?.to.z ?? 0)).toBe(20);
    // The mirrored half bulges to the other side.
    expect(Math.max(...smooth.map((s) => part.boxOf(s).high))).toBeCloseTo(5, 1);
    expect(Math.min(...smooth.map((s) => part.boxOf(s).low))).toBeCloseTo(-5, 1);
  });
});

test.each<readonly [string, readonly string[]]>([
  ['<line x1="1" y1="2" x2="3" y2="4"/>', ["1 -2 > 3 -4"]],
  ['<polyline points="0,0 10,0 10,5"/>', ["0 0 > 10 0", "10 0 > 10 -5"]],
  ['<polygon points="0 0 10 0 10 5"/>', ["0 0 > 10 0", "10 0 > 10 -5", "10 -5 > 0 0"]],
  ['<rect x="1" y="2" width="10" height="5"/>', ["1 -2 > 11 -2", "11 -2 > 11 -7", "11 -7 > 1 -7", "1 -7 > 1 -2"]],
  ['<circle cx="5" cy="6" r="2"/>', ["7 -6 > 7 -6 cw 5 -6"]],
  ['<rect width="0" height="5"/><circle r="-1"/><ellipse rx="3"/>', []],
  ['<g transform="translate(10 20)"><line x2="5"/></g>', ["10 -20 > 15 -20"]],
  ['<g transform="translate(10)"><line transform="rotate(90)scale(2)" x2="5"/></g>', ["10 0 > 10 -10"]],
  ['<line transform="rotate(90 10 0)" x2="5"/>', ["10 10 > 10 5"]],
  ['<line transform="matrix(1 0 0 -1 0 50)" y1="10" x2="5" y2="10"/>', ["0 -40 > 5 -40"]],
  ['<line transform="skewX(45)" y2="5"/>', ["0 0 > 5 -5"]],
  [
    '<svg x="10" y="10" width="20" height="20" viewBox="5 5 10 10"><line x1="5" y1="5" x2="10" y2="5"/></svg>',
    ["10 -10 > 20 -10"],
  ],
  ['<defs><line id="a" x2="5"/></defs><use href="#a" x="1" y="2"/>', ["1 -2 > 6 -2"]],
  ['<path transform="scale(1,2)" d="M0 0A5 2.5 0 0 1 10 0"/>', ["0 0 > 10 0 cw 5 0"]],
])("%s", (inside, expected) => expect(short(svg(inside))).toEqual(expected));

test("a rounded rectangle has four arcs", () => {
  const arcs = read(svg('<rect width="20" height="10" rx="3"/>')).curves.filter((c) => c.segment.kind === "arc");
  expect(arcs.map((c) => n(part.lengthOf(c.segment)))).toEqual([1, 2, 3, 4].map(() => n((3 * Math.PI) / 2)));
});

test.each<readonly [string, "mm" | "inch" | undefined, string, object]>([
  ['width="100mm" height="50mm" viewBox="0 0 200 100"', undefined, "0 0 > 5 0", { unit: "mm", source: "file" }],
  ['width="4in" height="2in" viewBox="0 0 4 2"', undefined, "0 0 > 254 0", { unit: "inch", source: "file" }],
  ['width="96" height="96"', undefined, "0 0 > 2.646 0", { unit: "mm", source: "assumed" }],
  ['viewBox="0 0 10 10"', undefined, "0 0 > 2.646 0", { unit: "mm", source: "assumed" }],
  ['width="100%" viewBox="0 0 10 10"', "mm", "0 0 > 10 0", { unit: "mm", source: "chosen" }],
  ['width="72pt" height="72pt" viewBox="0 0 72 72"', undefined, "0 0 > 3.528 0", { unit: "mm", source: "file" }],
])("size by %s", (attributes, chosen, expected, unit) => {
  const text = svg('<line x2="10"/>', attributes);
  expect(short(text, chosen)).toEqual([expected]);
  expect(read(text, chosen).unit).toEqual(unit);
});

test.each<readonly [string, readonly string[], number]>([
  ['<g style="display:none"><line x2="1"/><line x2="2"/></g><line x2="3"/>', ["invisible"], 1],
  ['<g visibility="hidden"><line x2="1"/><line visibility="visible" x2="2"/></g>', ["invisible"], 1],
  ['<style>.a, .b{display:none}</style><line class="x b" x2="1"/><line x2="2"/>', ["invisible"], 1],
  ['<line style="stroke:none;fill:none" x2="1"/>', ["invisible"], 0],
  ['<image href="a.png"/><line x2="1"/>', ["skipped"], 1],
  ['<path d="M0 0L1 0L"/>', ["broken"], 1],
  ['<g id="a"><use href="#a"/></g>', ["broken"], 0],
  ["<line x2='1'/></svg><b>", [], 1],
])("%s", (inside, expected, count) => {
  expect(codes(svg(inside))).toEqual(expected);
  expect(read(svg(inside)).curves.length).toBe(count);
});

test("roles by dashes, layer and width; texts as hints", () => {
  const { curves, texts } = read(
    svg(`<g inkscape:label="Mittellinie"><line x2="1"/></g><line stroke="#000" stroke-dasharray="10,2,1,2" x2="2"/>
      <line stroke="#000" stroke-dasharray="4" x2="3"/><line stroke="#000" stroke-width="0.5" x2="40"/>
      <line stroke="#000" stroke-width="0.13" x2="5"/><text x="7" y="8">R<tspan>5</tspan></text>`),
  );
  expect(curves.map((c) => c.role)).toEqual(["centre", "centre", "hidden", "outline", "thin"]);
  expect(curves[0]?.layer).toBe("Mittellinie");
  expect(texts).toEqual([{ text: "R5", at: { z: 7, r: -8 } }]);
});

test("what is no drawing says so", () => {
  expect(codes("<html/>")).toEqual(["unreadable"]);
  expect(codes("0\nSECTION")).toEqual(["unreadable"]);
  expect(codes(svg("<g>".repeat(1000)))).toContain("truncated");
  expect(
    codes(svg(`<defs><g id="a">${'<line x2="1"/>'.repeat(100)}</g></defs>${'<use href="#a"/>'.repeat(300)}`)),
  ).toEqual(["tooMany"]);
});

const piece = fc.constantFrom(
  "M",
  "l",
  "c",
  "A",
  "z",
  "1",
  "-2.5",
  "1e300",
  ",",
  " ",
  "0",
  '"/>',
  '<g transform="scale(',
  ')">',
  "</g>",
  '<path d="',
  "<use href='#",
  "&",
  "<",
);
test("damaged files neither throw nor hang, and yield finite numbers", () => {
  fc.assert(
    fc.property(fc.array(piece, { maxLength: 50 }), (pieces) => {
      for (const { segment: s } of read(svg(`<path id="1" d="M0 0${pieces.join("")}`)).curves)
        for (const x of [s.from.z, s.from.r, s.to.z, s.to.r]) expect(Number.isFinite(x)).toBe(true);
    }),
    { numRuns: 150, seed: 2 },
  );
});
