import { describe, expect, test } from "vitest";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { leftPieces } from "./left-pieces.ts";
import type { LoosePiece, Proof } from "./simulation.ts";

const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const loose = (area: number, ...rings: Ring[]): LoosePiece => ({
  step: 1,
  block: 1,
  operation: null,
  shape: "piece",
  isPartedOff: true,
  rings,
  area,
  place: at(0, 0),
});
const proofWith = (...pieces: LoosePiece[]) => ({ loose: pieces }) as unknown as Proof;

describe("pieces that a run leaves", () => {
  const bar = box(-80, 0, -33.5, 15.2),
    part = box(-31.4, 4.1, 0, 14.9),
    chip = box(0, 10, 0.5, 11.1);

  test("the final stock is in the chuck; loose pieces come largest first, without chips", () => {
    const small = box(-10, 0, 0, 3);
    expect(
      leftPieces({ final: [bar], proof: proofWith(loose(30, small), loose(339, part), loose(0.55, chip)) }),
    ).toEqual({
      held: [bar],
      off: [[part], [small]],
    });
  });

  test("a cavity belongs to the piece around it; without stock there is no piece", () => {
    const cavity: Ring = [...box(-60, 4, -50, 6)].reverse();
    expect(leftPieces({ final: [bar, cavity], proof: proofWith() })).toEqual({ held: [bar, cavity], off: [] });
    expect(leftPieces({ final: [chip], proof: proofWith() })).toEqual({ held: null, off: [] });
  });
});
