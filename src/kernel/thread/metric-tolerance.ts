import { rounded } from "../units.ts";
import type { Limits } from "./named-thread.ts";
import { preferred } from "./preferred-numbers.ts";

/*
 * Tolerances of ISO 965-1 in µm. Other grades follow in steps of R 40 from grade 6, as in its tables. Compared with
 * ASME B1.13M and DIN 13 limits of 300 threads (decision 0051).
 */

/** Pitch, mm; fundamental deviations e (null where there is none), f and g; tolerances of grade 6 of d and D1. */
const BY_PITCH: readonly (readonly [P: number, e: number | null, f: number, g: number, Td: number, TD1: number])[] = [
  [0.2, null, 32, 17, 56, 60],
  [0.25, null, 33, 18, 67, 71],
  [0.3, null, 33, 18, 75, 85],
  [0.35, null, 34, 19, 85, 100],
  [0.4, null, 34, 19, 95, 112],
  [0.45, null, 35, 20, 100, 125],
  [0.5, 50, 36, 20, 106, 140],
  [0.6, 53, 36, 21, 125, 160],
  [0.7, 56, 38, 22, 140, 180],
  [0.75, 56, 38, 22, 140, 190],
  [0.8, 60, 38, 24, 150, 200],
  [1, 60, 40, 26, 180, 236],
  [1.25, 63, 42, 28, 212, 265],
  [1.5, 67, 45, 32, 236, 300],
  [1.75, 71, 48, 34, 265, 335],
  [2, 71, 52, 38, 280, 375],
  [2.5, 80, 58, 42, 335, 450],
  [3, 85, 63, 48, 375, 500],
  [3.5, 90, 70, 53, 425, 560],
  [4, 95, 75, 60, 475, 600],
  [4.5, 100, 80, 63, 500, 670],
  [5, 106, 85, 71, 530, 710],
  [5.5, 112, 90, 75, 560, 750],
  [6, 118, 95, 80, 600, 800],
  [8, 140, 118, 100, 710, 1000],
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

const same = (a: number, b: number) => Math.abs(a - b) < 1e-6;
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
  if (at !== undefined) return at;
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
  readonly crest: Limits;
  readonly pitch: Limits;
}

const GRADES = { outsideCrest: [4, 6, 8], outsidePitch: [3, 4, 5, 6, 7, 8, 9], inside: [4, 5, 6, 7, 8] } as const;

/**
 * Limits of a class such as 6g, 4g6g, 6H, 5H6H for basic crest and pitch diameters, mm; null where ISO 965-1 has no such
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
    ? preferred(row?.[5] ?? minorTolerance(pitch), stepsTo(forCrest))
    : preferred(row?.[4] ?? 180 * pitch ** (2 / 3) - 3.15 / Math.sqrt(pitch), stepsTo(forCrest));
  const limits = (size: number, gap: number, tolerance: number): Limits =>
    isInside
      ? [rounded(size + gap / 1000), rounded(size + (gap + tolerance) / 1000)]
      : [rounded(size - (gap + tolerance) / 1000), rounded(size - gap / 1000)];
  return {
    name,
    crest: limits(basic.crest, crestDeviation, crest),
    pitch: limits(basic.pitch, pitchDeviation, onPitch),
  };
}

const minorTolerance = (pitch: number): number => (pitch < 1 ? 433 * pitch - 190 * pitch ** 1.22 : 230 * pitch ** 0.7);
