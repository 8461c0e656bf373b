import { describe, expect, it } from "vitest";
import { threadRelief, type ReliefForm } from "./thread-relief.ts";

/** DIN 76-1: pitch, form, radius, difference of diameters, g1, g2, mm. */
const PRINTED: readonly (readonly [number, ReliefForm, number, number, number, number])[] = [
  [0.2, "A", 0.1, 0.3, 0.45, 0.7],
  [0.2, "B", 0.1, 0.3, 0.25, 0.5],
  [0.2, "C", 0.1, 0.1, 0.8, 1.2],
  [0.2, "D", 0.1, 0.1, 0.5, 0.9],
  [0.5, "A", 0.2, 0.8, 1.1, 1.75],
  [0.5, "D", 0.2, 0.3, 1.25, 2],
  [0.8, "B", 0.4, 1.3, 0.9, 2],
  [1, "A", 0.6, 1.6, 2.1, 3.5],
  [1, "C", 0.6, 0.5, 4, 5.2],
  [1.5, "A", 0.8, 2.3, 3.2, 5.2],
  [1.5, "B", 0.8, 2.3, 1.8, 3.8],
  [1.5, "C", 0.8, 0.5, 6, 7.8],
  [1.5, "D", 0.8, 0.5, 3.8, 5.6],
  [1.75, "D", 1, 0.5, 4.3, 6.4],
  [2.5, "A", 1.2, 3.6, 5.6, 8.7],
  [2.5, "D", 1.2, 0.5, 6.3, 9.3],
  [3.5, "B", 1.6, 5, 4.7, 9],
  [4, "C", 2, 0.5, 16, 20],
  [6, "A", 3.2, 8.3, 14, 21],
  [6, "D", 3.2, 0.5, 15, 21],
];

describe("undercuts of DIN 76-1", () => {
  it.each(PRINTED)("pitch %s, form %s", (pitch, form, R, apart, floor, broad) => {
    expect(threadRelief(pitch, form)).toEqual({ form, pitch, R, apart, floor, broad });
  });

  it("lists no pitch between two of the standard", () => {
    expect(threadRelief(1.6, "A")).toBeNull();
  });

  it("leaves room for slopes of 30° on every row, to the rounding of the standard", () => {
    const pitches = [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.75, 0.8, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4];
    for (const pitch of [...pitches, 4.5, 5, 5.5, 6])
      for (const form of ["A", "B"] as const) {
        const { apart, floor, broad } = threadRelief(pitch, form) ?? { apart: 0, floor: 0, broad: 0 };
        expect(broad - floor, `${form} ${pitch}`).toBeGreaterThanOrEqual((apart / 2) * Math.sqrt(3) - 0.2);
      }
  });
});
