import { describe, expect, it } from "vitest";
import { CENTRE_FORMS } from "../plan/tool.ts";
import { degrees, length, toRadius, diameter, type Radius } from "../units.ts";
import {
  centreDepth,
  centreDrill,
  centreHole,
  centreHoles,
  centreNamed,
  centreProfile,
  coneDepth,
  leastPilot,
  mouthAt,
  protectionDepth,
} from "./centre-drill.ts";
import { centreParts, drillShape } from "./drill.ts";

describe("names of centre holes", () => {
  it.each([
    ["ISO 6411-A 4/8,5", "A", 4],
    ["ISO 6411 – A4/8.5", "A", 4],
    ["DIN 332-A4×8,5", "A", 4],
    ["DIN 332-B 2,5 x 8", "B", 2.5],
    ["ISO 6411-B2.5/8", "B", 2.5],
    ["DIN 332-R 3.15x6.7", "R", 3.15],
    ["A10", "A", 10],
    ["CENTRE-A4", "A", 4],
    ["DIN333-A1.6", "A", 1.6],
  ])("%s", (name, form, d1) => {
    expect(centreNamed(name)).toMatchObject({ form, d1 });
  });

  it.each(["", "CENTER-90", "NC-SPOT-D10", "A4x9", "A3", "VA4", "DIN 332-C 4x8.5"])("none in %s", (name) => {
    expect(centreNamed(name)).toBeNull();
  });
});

/** SN EN ISO 6411: form, d1, d2, d3, t, and b of form B, mm. */
const PRINTED = [
  ["A", 1, 2.12, 2.12, 1.9, 0],
  ["A", 1.6, 3.35, 3.35, 2.9, 0],
  ["A", 2, 4.25, 4.25, 3.7, 0],
  ["A", 2.5, 5.3, 5.3, 4.6, 0],
  ["A", 3.15, 6.7, 6.7, 5.9, 0],
  ["A", 4, 8.5, 8.5, 7.4, 0],
  ["A", 6.3, 13.2, 13.2, 11.5, 0],
  ["A", 10, 21.2, 21.2, 18.4, 0],
  ["B", 1, 2.12, 3.15, 2.2, 0.3],
  ["B", 1.6, 3.35, 5, 3.4, 0.5],
  ["B", 2, 4.25, 6.3, 4.3, 0.6],
  ["B", 2.5, 5.3, 8, 5.4, 0.8],
  ["B", 3.15, 6.7, 10, 6.8, 0.9],
  ["B", 4, 8.5, 12.5, 8.6, 1.2],
  ["B", 6.3, 13.2, 18, 12.9, 1.4],
  ["B", 10, 21.2, 28, 20.4, 2],
] as const;

describe("sizes of ISO 6411", () => {
  it.each(PRINTED)("%s %s", (form, d1, d2, d3, t, b) => {
    const hole = centreHole(form, d1);
    expect(hole).toMatchObject({ d2, d3, t });
    // The protecting cone of 120° has the depth that the standard prints.
    expect(Math.abs((hole ? protectionDepth(hole) : NaN) - b)).toBeLessThan(0.06);
  });

  it("leaves a pilot below every cone", () => {
    for (const form of CENTRE_FORMS)
      for (const hole of centreHoles(form))
        expect(leastPilot(hole), `${form}${hole.d1}`).toBeGreaterThan(hole.d1 * 0.8);
  });
});

describe("a centre drill", () => {
  const a4 = centreDrill("A4", 5);
  const b4 = centreDrill("B4", 5);
  if (!a4 || !b4) throw new Error("no drill");
  const tool = { T: 1, NAME: "A4", TYPE: "CENTER", TO: 8, RS: length(0), R: toRadius(diameter(10)) } as const;

  it("goes as deep as its cone needs", () => {
    expect(coneDepth(a4.hole)).toBeCloseTo(3.897, 3);
    expect(centreDepth(a4)).toBeCloseTo(8.897, 3);
    expect(centreDepth(b4)).toBeCloseTo(10.052, 3);
    expect(mouthAt(a4, 5, centreDepth(a4))).toBeCloseTo(8.5, 9);
    expect(mouthAt(b4, 7, centreDepth(b4))).toBeCloseTo(12.5, 9);
    expect(mouthAt(a4, 5, 5)).toBeCloseTo(4, 9);
    expect(mouthAt(a4, 5, 100)).toBeCloseTo(10, 9);
  });

  it("takes no pilot that is shorter than the standard", () => {
    expect(centreDrill("A4", undefined)?.pilot).toBeCloseTo(3.503, 3);
    expect(centreDrill("A4", 1)?.pilot).toBeCloseTo(3.503, 3);
  });

  it("has the outline of its profile, and convex parts", () => {
    const shape = drillShape({ ...tool, R: tool.R as Radius, centre: a4, "T-ANGLE": degrees(60) } as never);
    expect(shape.every((edge) => edge.kind === "line")).toBe(true);
    expect(centreProfile(a4, 5).at(-1)?.v).toBe(5);
    const parts = centreParts({ ...tool, centre: a4 } as never) ?? [];
    expect(parts).toHaveLength(3);
    for (const part of parts)
      part.forEach((p, i) => {
        const [q, r] = [part[(i + 1) % part.length] ?? p, part[(i + 2) % part.length] ?? p];
        expect((q.u - p.u) * (r.v - q.v) - (q.v - p.v) * (r.u - q.u)).toBeGreaterThanOrEqual(-1e-9);
      });
    expect(centreParts(tool as never)).toBeNull();
  });
});
