import fc from "fast-check";
import type { Cycle } from "../../src/cycles/define.ts";
import type { Param } from "../../src/cycles/params.ts";
import type { Size } from "../../src/view/camera.ts";
import type { Numbers } from "../../src/view/help/lettering.ts";
import { cycles } from "./drawings.ts";

/** A random picture: a cycle with values, its open prompt, and the size. */
export interface Case {
  readonly cycle: Cycle;
  readonly values: Numbers;
  readonly q: string;
  readonly size: Size;
}

const grid = (min: number, max: number) =>
  fc.integer({ min: Math.round(min * 1000), max: Math.round(max * 1000) }).map((n) => n / 1000);

/** Typical shop values, and sometimes the ends of the printed range. */
function valueOf(p: Param): fc.Arbitrary<number | "auto"> {
  if (p.choices) return fc.constantFrom(...p.choices);
  const [min, max] = p.range;
  const usual = {
    diameter: grid(0, 300),
    oversizeDiameter: grid(0, 2),
    radial: grid(0.05, 8),
    axial: p.incremental ? grid(-1, 1) : grid(-200, 20),
    axialDepth: grid(0.05, 8),
    length: grid(0, 6),
    angle: grid(0, 40),
    feed: grid(0.01, 1),
    choice: fc.constant(0),
    count: fc.integer({ min: 1, max: 6 }),
    factor: grid(0.3, 1),
    percent: grid(20, 120),
    revolutions: grid(0, 5),
  }[p.kind];
  return fc.oneof(
    { weight: 30, arbitrary: usual },
    { weight: 1, arbitrary: fc.constantFrom(min, max, 0, p.example) },
    ...(p.kind === "feed" ? [{ weight: 1, arbitrary: fc.constant("auto" as const) }] : []),
  );
}

const picture: fc.Arbitrary<Case> = fc.constantFrom(...cycles).chain((cycle) =>
  fc.record({
    cycle: fc.constant(cycle),
    values: fc.record(
      Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, valueOf(p)])),
    ) as fc.Arbitrary<Numbers>,
    q: fc.constantFrom(...Object.keys(cycle.params)),
    size: fc.record({ width: fc.integer({ min: 240, max: 900 }), height: fc.integer({ min: 160, max: 700 }) }),
  }),
);

/** LAW_RUNS=number makes a longer run. */
export const RUNS = Number(process.env["LAW_RUNS"] ?? 400);

/** A law over random pictures. */
export const laws = (holds: (c: Case) => void): void => fc.assert(fc.property(picture, holds), { numRuns: RUNS });
