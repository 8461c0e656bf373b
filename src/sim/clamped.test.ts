import { describe, expect, test } from "vitest";
import { at, type Ring } from "../kernel/point.ts";
import { leftPieces } from "./clamped.ts";

const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];

describe("pieces that a run leaves", () => {
  const bar = box(-80, 0, -33.5, 15.2), part = box(-31.4, 4.1, 0, 14.9), chip = box(0, 10, 0.5, 11.1);

  test("the chuck holds what reaches farthest back, however small it is; what came off is the largest first", () => {
    expect(leftPieces({ final: [part, bar, chip] })).toEqual({ held: [bar], off: [[part]] });
    const stub = box(-80, 0, -78.6, 2.3);
    expect(leftPieces({ final: [part, stub, box(-70, 0, -60, 14)] })).toEqual({ held: [stub], off: [[part], [box(-70, 0, -60, 14)]] });
  });

  test("a cavity belongs to the piece that is round it, and nothing left is no piece", () => {
    const cavity: Ring = [...box(-60, 4, -50, 6)].reverse();
    expect(leftPieces({ final: [bar, cavity] })).toEqual({ held: [bar, cavity], off: [] });
    expect(leftPieces({ final: [chip] })).toEqual({ held: null, off: [] });
  });
});
