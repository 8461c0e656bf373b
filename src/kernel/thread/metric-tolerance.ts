import { SAME_STEP } from "../tolerance.ts";
import { rounded } from "../units.ts";
import type { SizeLimits } from "./named-thread.ts";
import { preferred } from "./preferred-numbers.ts";

/*
 * Tolerances of ISO 965-1. Other grades follow in steps of R 40 from grade 6, as in its tables. Compared with
 * ASME B1.13M and DIN 13 limits of 300 threads (decision 0051).
 */

/** Pitch; fundamental deviations e (null where there is none), f and g; tolerances of grade 6 of d and D1, mm. */
const BY_PITCH: readonly (readonly [P: number, e: number | null, f: number, g: number, Td: number, TD1: number])[] = [
  [0.2, null, 0.032, 0.017, 0.056, 0.06],
  [0.25, null, 0.033, 0.018, 0.067, 0.071],
  [0.3, null, 0.033, 0.018, 0.075, 0.085],
  [0.35, null, 0.034, 0.019, 0.085, 0.1],
  [0.4, null, 0.034, 0.019, 0.095, 0.112],
  [0.45, null, 0.035, 0.02, 0.1, 0.125],
  [0.5, 0.05, 0.036, 0.02, 0.106, 0.14],
  [0.6, 0.053, 0.036, 0.021, 0.125, 0.16],
  [0.7, 0.056, 0.038, 0.022, 0.14, 0.18],
  [0.75, 0.056, 0.038, 0.022, 0.14, 0.19],
  [0.8, 0.06, 0.038, 0.024, 0.15, 0.2],
  [1, 0.06, 0.04, 0.026, 0.18, 0.236],
  [1.25, 0.063, 0.042, 0.028, 0.212, 0.265],
  [1.5, 0.067, 0.045, 0.032, 0.236, 0.3],
  [1.75, 0.071, 0.048, 0.034, 0.265, 0.335],
  [2, 0.071, 0.052, 0.038, 0.28, 0.375],
  [2.5, 0.08, 0.058, 0.042, 0.335, 0.45],
  [3, 0.085, 0.063, 0.048, 0.375, 0.5],
  [3.5, 0.09, 0.07, 0.053, 0.425, 0.56],
  [4, 0.095, 0.075, 0.06, 0.475, 0.6],
  [4.5, 0.1, 0.08, 0.063, 0.5, 0.67],
  [5, 0.106, 0.085, 0.071, 0.53, 0.71],
  [5.5, 0.112, 0.09, 0.075, 0.56, 0.75],
  [6, 0.118, 0.095, 0.08, 0.6, 0.8],
  [8, 0.14, 0.118, 0.1, 0.71, 1],
];

/** Ranges of the nominal diameter up to this one, mm, with the tolerance of grade 6 of d2 by pitch. */
const BY_DIAMETER: readonly (readonly [upTo: number, tolerances: Readonly<Record<number, number>>])[] = [
  [1.4, { 0.2: 48, 0.25: 53, 0.3: 56 }],
  [2.8, { 0.2: 50, 0.25: 56, 0.35: 63, 0.4: 67, 0.45: 71 }],
  [5.6, { 0.35: 67, 0.5: 75, 0.6: 85, 0.7: 90, 0.75: 90, 0.8: 95 }],
  [11.2, { 0.75: 100, 1: 112, 1.25: 118, 1.5: 132 }],
  [22.4, { 1: 118, 1.25: 132, 1.5: 140, 1.75: 150, 2: 160, 2.5: 170 }],
  [45, { 1: 125, 1.5: 150, 2: 170, 3: 200, 3.5: 212, 4: 224, 4.5: 236 }],
  [90, { 1.5: 160, 2: 180, 3: 212, 4: 236, 5: 250, 5.5: 265, 6: 280 }],
  [180, { 2: 190, 3: 224, 4: 250, 6: 300, 8: 335 }],
  [355, { 3: 250, 4: 280, 6: 315, 8: 355 }],
];
/** Smallest diameter of the first range, mm. */
const SMALLEST = 0.99;

/** µm in a mm: the formulas of the standard give µm. */
const MICRONS = 1000;

const same = (a: number, b: number) => Math.abs(a - b) < SAME_STEP;
const rowOf = (pitch: number) => BY_PITCH.find(([P]) => same(P, pitch));

/** Fundamental deviation of a position in µm, towards more clearance: by table, or by formula for an unlisted pitch. */
function deviation(position: string, pitch: number): number | null {
  const row = rowOf(pitch);
  const formula: Readonly<Record<string, number>> = {
    e: 50 + 11 * pitch,
    f: 30 + 11 * pitch,
    g: 15 + 11 * pitch,
    h: 0,
  };
  const at = { e: row?.[1], f: row?.[2], g: row?.[3], h: 0 }[position];
  if (at !== undefined) return at === null ? null : at * MICRONS;
  const value = row ? undefined : formula[position];
  return value === undefined ? null : value === 0 ? 0 : preferred(value);
}

/** Tolerance of grade 6 of the pitch diameter, µm. */
function pitchTolerance(nominal: number, pitch: number): number {
  const i = Math.max(
    0,
    BY_DIAMETER.findIndex(([upTo]) => nominal <= upTo),
  );
  const [upTo, listed] = nominal <= 355 ? (BY_DIAMETER[i] as (typeof BY_DIAMETER)[number]) : [1000, {}];
  const from = nominal > 355 ? 355 : (BY_DIAMETER[i - 1]?.[0] ?? SMALLEST);
  const found = (listed as Readonly<Record<number, number>>)[pitch];
  return found ?? preferred(90 * pitch ** 0.4 * Math.sqrt(from * upTo) ** 0.1);
}

/** Steps of R 40 between two grades, and from the tolerance of d2 to that of D2. */
const PER_GRADE = 4;
const INSIDE = 5;
const stepsTo = (grade: number) => (grade - 6) * PER_GRADE;

/** Tolerances and deviation of a class; mm. */
export interface MetricClass {
  readonly name: string;
  readonly crest: SizeLimits;
  readonly pitch: SizeLimits;
}

const GRADES = { outsideCrest: [4, 6, 8], outsidePitch: [3, 4, 5, 6, 7, 8, 9], inside: [4, 5, 6, 7, 8] } as const;

/**
 * SizeLimits of a class such as 6g, 4g6g, 6H, 5H6H for basic crest and pitch diameters, mm; null where ISO 965-1 has no such
 * class.
 */
export function metricClass(
  name: string,
  { nominal, pitch }: { readonly nominal: number; readonly pitch: number },
  basic: { readonly crest: number; readonly pitch: number },
): MetricClass | null {
  const m = /^(\d)([a-h])(?:(\d)([a-h]))?$/i.exec(name);
  if (!m) return null;
  const isInside = name !== name.toLowerCase();
  const [forPitch, at] = [Number(m[1]), (m[2] as string).toLowerCase()];
  const [forCrest, crestAt] = [Number(m[3] ?? m[1]), (m[4] ?? (m[2] as string)).toLowerCase()];
  const [pitchDeviation, crestDeviation] = [deviation(at, pitch), deviation(crestAt, pitch)];
  const grades: readonly (readonly number[])[] = isInside
    ? [GRADES.inside, GRADES.inside]
    : [GRADES.outsidePitch, GRADES.outsideCrest];
  const isKnown = grades[0]?.includes(forPitch) === true && grades[1]?.includes(forCrest) === true;
  if (!isKnown || pitchDeviation === null || crestDeviation === null) return null;
  if (isInside && !["g", "h"].includes(at)) return null;
  const row = rowOf(pitch);
  const sixth = pitchTolerance(nominal, pitch);
  const onPitch = preferred(sixth, stepsTo(forPitch) + (isInside ? INSIDE : 0));
  const crest = isInside
    ? preferred(row ? row[5] * MICRONS : minorTolerance(pitch), stepsTo(forCrest))
    : preferred(row ? row[4] * MICRONS : 180 * pitch ** (2 / 3) - 3.15 / Math.sqrt(pitch), stepsTo(forCrest));
  const limits = (size: number, gap: number, tolerance: number): SizeLimits =>
    isInside
      ? [rounded(size + gap / MICRONS), rounded(size + (gap + tolerance) / MICRONS)]
      : [rounded(size - (gap + tolerance) / MICRONS), rounded(size - gap / MICRONS)];
  return {
    name,
    crest: limits(basic.crest, crestDeviation, crest),
    pitch: limits(basic.pitch, pitchDeviation, onPitch),
  };
}

const minorTolerance = (pitch: number): number => (pitch < 1 ? 433 * pitch - 190 * pitch ** 1.22 : 230 * pitch ** 0.7);
