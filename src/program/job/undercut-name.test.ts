import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { contourFrom } from "../../kernel/contour/contour.ts";
import { GROOVE_FORMS, groovesOf } from "../../kernel/contour/relief-groove.ts";
import type { RecessWords, Undercut } from "../../kernel/contour/undercut.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { nameOfUndercut, pitchesFor, readUndercutName, undercutsNamed } from "./undercut-name.ts";

const shaft = (d: number) => ({ diameter: diameter(d), isInside: false });
const bore = (d: number) => ({ diameter: diameter(d), isInside: true });
const only = (typed: string, place = shaft(40)) => {
  const { sizes } = undercutsNamed(typed, place);
  expect(sizes).toHaveLength(1);
  return sizes[0] as NonNullable<(typeof sizes)[0]>;
};

describe("designations as drawings have them", () => {
  it.each([
    ["DIN 509-F 0,8×0,3", "DIN 509", "F", 0.8, 0.3, 0],
    ["DIN 509 – E 0,8 x 0,3", "DIN 509", "E", 0.8, 0.3, 0],
    ["E1x0.2", "DIN 509", "E", 1, 0.2, 0],
    ["Freistich F1,2×0,4", "DIN 509", "F", 1.2, 0.4, 0],
    ["freistich din 509 - e 0,6 * 0,3", "DIN 509", "E", 0.6, 0.3, 0],
    ["ISO 18388-F0.8x0.3", "ISO 18388", "F", 0.8, 0.3, 0],
    ["ISO 18388 – E0,8×0,3", "ISO 18388", "E", 0.8, 0.3, 0],
    ["Undercut DIN 509-H1.2x0.3", "DIN 509", "H", 1.2, 0.3, 0],
    ["Dégagement F 2,5×0,4", "DIN 509", "F", 2.5, 0.4, 0],
    ["F 0,6×0,3 z 0,2", "DIN 509", "F", 0.6, 0.3, 0.2],
  ])("%s", (typed, standard, form, r, t1, allowance) => {
    expect(readUndercutName(typed)).toEqual({ standard, form, size: { r, t1 }, allowance });
  });

  it.each([
    ["DIN 76-A", "A", null],
    ["DIN 76 – D", "D", null],
    ["Gewindefreistich DIN 76-A 2,5", "A", 2.5],
    ["DIN 76-1 B P1.5", "B", 1.5],
    ["C 1,75", "C", 1.75],
    ["DIN76-Ax2", "A", 2],
    ["DIN 76", null, null],
    ["Gewindefreistich DIN 76-1", null, null],
    ["DIN 76 P1,5", null, 1.5],
  ])("%s", (typed, form, pitch) => {
    expect(readUndercutName(typed)).toEqual({ standard: "DIN 76", form, pitch });
  });

  it.each([
    "",
    "DIN 471",
    "DIN 76-E",
    "DIN 76-2 A",
    "DIN 76-2",
    "DIN 76-1.5",
    "DIN 509-A 0.8x0.3",
    "F 0.8",
    "0.8x0.3",
    "E 0,8x0,3x1",
  ])("no designation: %s", (typed) => expect(readUndercutName(typed)).toBeNull());

  it("reads anything at all, in time", () => {
    fc.assert(
      fc.property(fc.string({ maxLength: 200 }), fc.double({ min: 0.5, max: 500, noNaN: true }), (typed, d) => {
        expect(undercutsNamed(typed, shaft(d)).sizes.length).toBeLessThan(30);
      }),
      { seed: 76, numRuns: 200 },
    );
  });
});

/** DIN 509: designation, then words of UDC. */
const GROOVES: readonly (readonly [string, number, RecessWords])[] = [
  ["E 0.1x0.1", 1.5, { R: 0.1, DEPTH: 0.1, BREADTH: 0.5, ANGLE: 15 }],
  ["E 0.2x0.1", 3, { R: 0.2, DEPTH: 0.1, BREADTH: 1, ANGLE: 15 }],
  ["E 0.4x0.2", 10, { R: 0.4, DEPTH: 0.2, BREADTH: 2, ANGLE: 15 }],
  ["E 0.6x0.2", 18, { R: 0.6, DEPTH: 0.2, BREADTH: 2, ANGLE: 15 }],
  ["E 0.6x0.3", 40, { R: 0.6, DEPTH: 0.3, BREADTH: 2.5, ANGLE: 15 }],
  ["E 0.8x0.3", 80, { R: 0.8, DEPTH: 0.3, BREADTH: 2.5, ANGLE: 15 }],
  ["E 1x0.2", 50, { R: 1, DEPTH: 0.2, BREADTH: 2.5, ANGLE: 15 }],
  ["E 1x0.4", 90, { R: 1, DEPTH: 0.4, BREADTH: 4, ANGLE: 15 }],
  ["E 1.6x0.3", 63, { R: 1.6, DEPTH: 0.3, BREADTH: 4, ANGLE: 15 }],
  ["E 2.5x0.4", 100, { R: 2.5, DEPTH: 0.4, BREADTH: 5, ANGLE: 15 }],
  ["E 4x0.5", 150, { R: 4, DEPTH: 0.5, BREADTH: 7, ANGLE: 15 }],
  ["F 0.2x0.1", 3, { R: 0.2, DEPTH: 0.1, BREADTH: 1, ANGLE: 15, FACEDEPTH: 0.1, FACEANGLE: 8 }],
  ["F 0.4x0.2", 12, { R: 0.4, DEPTH: 0.2, BREADTH: 2, ANGLE: 15, FACEDEPTH: 0.1, FACEANGLE: 8 }],
  ["F 0.6x0.3", 40, { R: 0.6, DEPTH: 0.3, BREADTH: 2.5, ANGLE: 15, FACEDEPTH: 0.2, FACEANGLE: 8 }],
  ["F 0.8x0.3", 40, { R: 0.8, DEPTH: 0.3, BREADTH: 2.5, ANGLE: 15, FACEDEPTH: 0.2, FACEANGLE: 8 }],
  ["F 1.2x0.2", 30, { R: 1.2, DEPTH: 0.2, BREADTH: 2.5, ANGLE: 15, FACEDEPTH: 0.1, FACEANGLE: 8 }],
  ["F 1.2x0.4", 100, { R: 1.2, DEPTH: 0.4, BREADTH: 4, ANGLE: 15, FACEDEPTH: 0.3, FACEANGLE: 8 }],
  ["F 1.6x0.3", 63, { R: 1.6, DEPTH: 0.3, BREADTH: 4, ANGLE: 15, FACEDEPTH: 0.2, FACEANGLE: 8 }],
  ["H 0.8x0.3", 40, { R: 0.8, BREADTH: 2, ANGLE: 15 }],
  ["H 1.2x0.3", 40, { R: 1.2, BREADTH: 2.4, ANGLE: 15 }],
];

/** Breadth of the recess in the face above the floor (g), of form F: a reference size of the standard. */
const FACE: readonly (readonly [string, number, number])[] = [
  ["F 0.2x0.1", 3, 0.9],
  ["F 0.4x0.2", 10, 1.1],
  ["F 0.6x0.2", 16, 1.4],
  ["F 0.6x0.3", 40, 2.1],
  ["F 0.8x0.3", 40, 2.3],
  ["F 1x0.2", 40, 1.8],
  ["F 1x0.4", 90, 3.2],
  ["F 1.2x0.2", 40, 2],
  ["F 1.2x0.4", 90, 3.4],
  ["F 1.6x0.3", 60, 3.1],
  ["F 2.5x0.4", 100, 4.8],
  ["F 4x0.5", 150, 6.4],
];

const at = (z: number, x: number) => ({ z: axial(z), r: toRadius(diameter(x)) });
const turned = (undercut: Undercut, d: number) =>
  contourFrom([
    { kind: "line", to: at(0, d) },
    { kind: "line", to: at(-30, d) },
    undercut,
    { kind: "line", to: at(-30, d + 40) },
  ]);

describe("sizes of DIN 509", () => {
  it.each(GROOVES)("%s", (typed, d, words) => {
    const { name, udc, notes } = only(typed, shaft(d));
    expect(name).toBe(`DIN 509-${typed.replace("x", "×")}`);
    expect(udc?.words).toEqual(words);
    expect(notes.filter(({ code }) => code !== "faceOfH")).toEqual([]);
  });

  it.each(FACE)("%s: g", (typed, d, g) => {
    const { udc, groove } = only(typed, shaft(d));
    const made = turned({ kind: "undercut", form: "F", words: udc?.words ?? {} }, d);
    expect(made.issues).toEqual([]);
    const floor = d / 2 - (groove?.t1 ?? 0);
    const inFace = made.segments.filter((s) => s.to.z < -30 - 1e-6 || s.from.z < -30 - 1e-6);
    const top = Math.max(...inFace.map((s) => Math.max(s.to.r, s.from.r)));
    expect(Math.abs(top - floor - g)).toBeLessThan(0.06);
  });

  it("makes every size that UDC can express, on the diameters it is assigned to", () => {
    for (const form of GROOVE_FORMS)
      for (const g of groovesOf(form)) {
        const d = Number.isFinite(g.upTo) ? g.upTo : g.over + 20;
        const named = only(`${form}${g.r}x${g.t1}`, shaft(d));
        if (!named.udc) expect(form).toBe("G");
        else
          expect(turned({ kind: "undercut", ...named.udc } as unknown as Undercut, d).issues, named.name).toEqual([]);
      }
  });

  it.each([
    ["F 0.7x0.3", "DIN 509-F 0.6×0.3"],
    ["E 1.5x0.3", "DIN 509-E 1.6×0.3"],
    ["E 0.8x0.4", "DIN 509-E 0.8×0.3"],
    ["H 1x0.3", "DIN 509-H 0.8×0.3"],
  ])("%s is not in the standard: the nearest is named", (typed, taken) => {
    expect(only(typed).notes[0]).toMatchObject({ code: "nearest", taken });
  });

  it("warns of a diameter outside the range, and takes the size all the same", () => {
    const { notes, udc } = only("F 0.8x0.3", shaft(12));
    expect(notes).toEqual([{ code: "diameter", over: 18, upTo: 80 }]);
    expect(udc?.words.R).toBe(0.8);
  });

  it("says that UDC has no form G", () => {
    expect(only("G 0.4x0.2", shaft(12))).toMatchObject({ udc: null, notes: [{ code: "formG" }] });
  });

  // DIN 509: e1 = 0.75 for z = 0.2.
  it("lengthens the slope by e1 for an allowance", () => {
    const { udc } = only("E 0.8x0.3 z0.2");
    expect(udc?.words).toMatchObject({ R: 0.8, DEPTH: 0.5, BREADTH: 3.246 });
    expect(only("F 0.8x0.3 z0.2").udc?.words).toMatchObject({ DEPTH: 0.5, FACEDEPTH: 0.4, BREADTH: 3.046 });
  });

  // After grinding, the finished cylinder and face meet the undercut where the standard has it.
  it.each(["E 0.8x0.3", "F 0.8x0.3", "F 1.2x0.4"])("%s with an allowance leaves the size of the standard", (typed) => {
    const z = 0.3;
    const d = typed.includes("1.2") ? 90 : 40;
    const { udc, groove } = only(`${typed} z${z}`, shaft(d));
    const face = udc?.form === "F" ? z : 0;
    const raw = { kind: "undercut", form: udc?.form ?? "E", words: udc?.words ?? {} } as const;
    const slope = turned(raw, d + 2 * z).segments[1];
    // The raw face stands before the finished one.
    const along = ((slope?.from.r ?? 0) - d / 2) / Math.tan((15 * Math.PI) / 180);
    expect((slope?.from.z ?? 0) - along + 30 + face).toBeCloseTo(groove?.f ?? 0, 2);
  });

  it.each([
    [12, ["DIN 509-F 0.4×0.2", "DIN 509-F 0.6×0.2"]],
    [25, ["DIN 509-F 0.6×0.3", "DIN 509-F 0.8×0.3", "DIN 509-F 1×0.2", "DIN 509-F 1.2×0.2"]],
    [60, ["DIN 509-F 0.6×0.3", "DIN 509-F 0.8×0.3", "DIN 509-F 1.6×0.3"]],
    [200, ["DIN 509-F 1×0.4", "DIN 509-F 1.2×0.4", "DIN 509-F 4×0.5"]],
  ])("lists form F for diameter %s: usual load and series 1 first", (d, names) => {
    expect(undercutsNamed("F", shaft(d)).sizes.map(({ name }) => name)).toEqual(names);
  });
});

describe("reliefs of DIN 76", () => {
  it.each([
    ["DIN 76-A 2.5", shaft(20), { PITCH: 2.5, R: 1.2, DEPTH: 1.8, BREADTH: 8.7, ANGLE: 30 }],
    ["DIN 76-B 2.5", shaft(20), { PITCH: 2.5, R: 1.2, DEPTH: 1.8, BREADTH: 6.3, ANGLE: 30 }],
    ["DIN 76-C 2", bore(20), { PITCH: 2, R: 1, DEPTH: 0.25, BREADTH: 10.3, ANGLE: 30 }],
    ["DIN 76-C 1.5", bore(18.376), { PITCH: 1.5, R: 0.8, DEPTH: 1.062, BREADTH: 7.8, ANGLE: 30 }],
    ["DIN 76-D 1.5", bore(18.376), { PITCH: 1.5, R: 0.8, DEPTH: 1.062, BREADTH: 5.6, ANGLE: 30 }],
  ] as const)("%s", (typed, place, words) => {
    expect(only(typed, place).udc).toEqual({ form: "THREAD", words });
  });

  it("takes the form of the side it is on", () => {
    expect(only("DIN 76-D 1.5", shaft(20))).toMatchObject({
      name: "DIN 76-B P1.5",
      notes: [{ code: "side", form: "D", other: "B" }],
    });
  });

  it("proposes the pitches of the diameter, the coarse one first", () => {
    expect(undercutsNamed("DIN 76-A", shaft(20)).sizes.map(({ name }) => name)).toEqual([
      "DIN 76-A P2.5",
      "DIN 76-A P2",
      "DIN 76-A P1.5",
      "DIN 76-A P1",
    ]);
    expect(pitchesFor(bore(18.376))).toContain(1.5);
  });

  it.each([
    ["DIN 76", shaft(20), ["DIN 76-A P1.5", "DIN 76-B P1.5"]],
    ["DIN 76", bore(18.4), ["DIN 76-C P1.5", "DIN 76-D P1.5"]],
    ["DIN 76-B", shaft(20), ["DIN 76-B P1.5"]],
    ["DIN 76-A 2", shaft(20), ["DIN 76-A P2"]],
  ] as const)("%s at a thread takes its pitch", (typed, place, names) => {
    expect(undercutsNamed(typed, { ...place, pitch: 1.5 }).sizes.map(({ name }) => name)).toEqual(names);
  });

  it("names the neighbours of a pitch between two", () => {
    expect(undercutsNamed("DIN 76-A 1.6", shaft(20))).toMatchObject({
      notes: [{ code: "pitch", pitch: 1.6, below: 1.5, above: 1.75 }],
      sizes: [{ name: "DIN 76-A P1.5" }, { name: "DIN 76-A P1.75" }],
    });
  });
});

describe("the name of words", () => {
  it.each(["DIN 509-E 0.8×0.3", "DIN 509-F 0.8×0.3", "DIN 509-F 1.2×0.2", "DIN 509-H 0.8×0.3"])("%s", (name) => {
    const { udc } = only(name);
    expect(nameOfUndercut(udc?.form ?? "E", udc?.words ?? {}, shaft(40))?.name).toBe(name);
  });

  it.each([
    ["DIN 76-A P2.5", shaft(20)],
    ["DIN 76-B P2.5", shaft(20)],
    ["DIN 76-D P1.5", bore(18.376)],
  ])("%s", (name, place) => {
    const { udc } = only(name, place);
    expect(nameOfUndercut("THREAD", udc?.words ?? {}, place)?.name).toBe(name);
  });

  it("has none for words that are no size", () => {
    const { udc } = only("F 0.8x0.3");
    expect(nameOfUndercut("F", { ...udc?.words, DEPTH: 0.35 }, shaft(40))).toBeNull();
    expect(nameOfUndercut("K", { R: 0.8 }, shaft(40))).toBeNull();
  });
});
