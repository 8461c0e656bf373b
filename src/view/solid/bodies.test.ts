import { expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { simulate } from "../../sim/simulate.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { colouredBodies } from "./bodies.ts";

const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const blank = [box(-60.3, 0, 0, 21.7)];
/** A stock with a notch, which is a gouge of step 3, and a rim that should have been removed. */
const stock: Ring = [
  [-60.3, 0],
  [0, 0],
  [0, 21.7],
  [-20.5, 21.7],
  [-20.5, 20.1],
  [-24.5, 20.1],
  [-24.5, 21.7],
  [-60.3, 21.7],
].map(([z = 0, r = 0]) => at(z, r));
const run: Simulation = {
  ...simulate({ blank, steps: [], operations: [], unproved: [] }),
  findings: [
    {
      kind: "gouge",
      step: 3,
      block: 9,
      operation: 0,
      place: at(-22, 21),
      area: 6.4,
      rings: [box(-24.5, 20.1, -20.5, 21.7)],
      moves: 1,
    },
  ],
};
const left: Simulation["proof"]["residual"] = [
  {
    area: 2,
    thickness: 1,
    reason: { code: "nose", radius: 0.8 } as never,
    ring: box(-2.1, 20.7, 0, 21.7),
    place: at(-1, 21),
    operation: 0,
  },
];

test("before the gouging move all is steel; after it a skin round the gouge is separate, and nothing is lost", () => {
  const before = colouredBodies(
    [stock],
    { ...run, steps: Array.from({ length: 9 }) as never },
    { step: 3, fraction: 0 },
    60,
  );
  expect(before.gouge).toEqual([]);
  expect(areaOf(before.steel)).toBeCloseTo(areaOf([stock]), 2);
  const after = colouredBodies(
    [stock],
    { ...run, steps: Array.from({ length: 9 }) as never },
    { step: 3, fraction: 0.4 },
    60,
  );
  // Floor and both walls of the notch, 0.24 mm deep, and a quarter round at each corner.
  expect(areaOf(after.gouge)).toBeCloseTo(0.24 * (4 + 2 * 1.6) + 2 * (Math.PI / 4) * 0.24 ** 2, 1);
  expect(areaOf(after.steel) + areaOf(after.gouge)).toBeCloseTo(areaOf([stock]), 2);
});

test("residual material is a separate body at the end of the run, and not before", () => {
  const whole = {
    ...run,
    findings: [],
    proof: { ...run.proof, residual: left },
    steps: Array.from({ length: 9 }) as never,
  };
  expect(colouredBodies(blank, whole, { step: 8, fraction: 0.9 }, 60).residual).toEqual([]);
  const { residual, steel } = colouredBodies(blank, whole, { step: 9, fraction: 0 }, 60);
  expect(areaOf(residual)).toBeCloseTo((2.1 + 0.02) * (1 + 0.02), 2);
  expect(areaOf(residual) + areaOf(steel)).toBeCloseTo(areaOf(blank), 3);
});

test("no skin of steel covers residual material or gouges, however their outlines slope", () => {
  const leans = (by: number): Ring => [
    at(-39.5555, 19.9),
    at(-28.6248, 20.9576 + by),
    at(-28.6269, 20.9601 + by),
    at(-39.5538, 20.0041 + by),
  ];
  const cone: Ring = [at(-60.3, 0), at(0, 0), at(0, 23.4644), at(-60.3, 18.1886)];
  const steps = Array.from({ length: 9 }) as never,
    end = { step: 9, fraction: 0 };
  for (const by of [-0.0009, 0, 0.0007, 0.0031]) {
    const rest = { ...run.proof, residual: left.map((each) => ({ ...each, ring: leans(by) })) };
    const stays = colouredBodies([cone], { ...run, findings: [], proof: rest, steps }, end, 60);
    expect(stays.residual).toHaveLength(1);
    // The removed area is open to the outside: a hole in the steel would mean that a skin covers it.
    expect(stays.steel.filter((ring) => areaOf([ring]) < 0)).toEqual([]);
    const gouged = colouredBodies(
      [cone],
      { ...run, findings: run.findings.map((f) => ({ ...f, rings: [leans(by)] })), steps },
      end,
      60,
    );
    expect(gouged.gouge).toHaveLength(1);
    expect(gouged.steel.filter((ring) => areaOf([ring]) < 0)).toEqual([]);
  }
});
