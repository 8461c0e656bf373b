import { rangeOf, standardTolerance, TOLERANCE_RANGES } from "./standard-tolerance.ts";

/*
 * Fundamental deviations of ISO 286-1 up to 500 mm (tag S, sources in decision 0056), mm. The rare letters cd, ef, fg, y,
 * za, zb and zc are left out.
 */

/** Deviations from a nominal size, mm. */
export interface Deviations {
  readonly upper: number;
  readonly lower: number;
}

/** Upper ends of the finer ranges that some letters have, mm. */
const FINE: readonly number[] = [
  3, 6, 10, 14, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500,
];

/** Distance of the upper deviation es of shafts below the nominal size, by range. */
const BELOW: Readonly<Record<string, readonly number[]>> = {
  a: [
    0.27, 0.27, 0.28, 0.29, 0.29, 0.3, 0.3, 0.31, 0.32, 0.34, 0.36, 0.38, 0.41, 0.46, 0.52, 0.58, 0.66, 0.74, 0.82,
    0.92, 1.05, 1.2, 1.35, 1.5, 1.65,
  ],
  b: [
    0.14, 0.14, 0.15, 0.15, 0.15, 0.16, 0.16, 0.17, 0.18, 0.19, 0.2, 0.22, 0.24, 0.26, 0.28, 0.31, 0.34, 0.38, 0.42,
    0.48, 0.54, 0.6, 0.68, 0.76, 0.84,
  ],
  c: [
    0.06, 0.07, 0.08, 0.095, 0.095, 0.11, 0.11, 0.12, 0.13, 0.14, 0.15, 0.17, 0.18, 0.2, 0.21, 0.23, 0.24, 0.26, 0.28,
    0.3, 0.33, 0.36, 0.4, 0.44, 0.48,
  ],
  d: [0.02, 0.03, 0.04, 0.05, 0.065, 0.08, 0.1, 0.12, 0.145, 0.17, 0.19, 0.21, 0.23],
  e: [0.014, 0.02, 0.025, 0.032, 0.04, 0.05, 0.06, 0.072, 0.085, 0.1, 0.11, 0.125, 0.135],
  f: [0.006, 0.01, 0.013, 0.016, 0.02, 0.025, 0.03, 0.036, 0.043, 0.05, 0.056, 0.062, 0.068],
  g: [0.002, 0.004, 0.005, 0.006, 0.007, 0.009, 0.01, 0.012, 0.014, 0.015, 0.017, 0.018, 0.02],
  h: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
};

/** Distance of the lower deviation ei of shafts above the nominal size, by range; t begins above 24 mm. */
const ABOVE: Readonly<Record<string, readonly number[]>> = {
  k: [0, 0.001, 0.001, 0.001, 0.002, 0.002, 0.002, 0.003, 0.003, 0.004, 0.004, 0.004, 0.005],
  m: [0.002, 0.004, 0.006, 0.007, 0.008, 0.009, 0.011, 0.013, 0.015, 0.017, 0.02, 0.021, 0.023],
  n: [0.004, 0.008, 0.01, 0.012, 0.015, 0.017, 0.02, 0.023, 0.027, 0.031, 0.034, 0.037, 0.04],
  p: [0.006, 0.012, 0.015, 0.018, 0.022, 0.026, 0.032, 0.037, 0.043, 0.05, 0.056, 0.062, 0.068],
  r: [
    0.01, 0.015, 0.019, 0.023, 0.023, 0.028, 0.028, 0.034, 0.034, 0.041, 0.043, 0.051, 0.054, 0.063, 0.065, 0.068,
    0.077, 0.08, 0.084, 0.094, 0.098, 0.108, 0.114, 0.126, 0.132,
  ],
  s: [
    0.014, 0.019, 0.023, 0.028, 0.028, 0.035, 0.035, 0.043, 0.043, 0.053, 0.059, 0.071, 0.079, 0.092, 0.1, 0.108, 0.122,
    0.13, 0.14, 0.158, 0.17, 0.19, 0.208, 0.232, 0.252,
  ],
  t: [
    0.041, 0.048, 0.054, 0.066, 0.075, 0.091, 0.104, 0.122, 0.134, 0.146, 0.166, 0.18, 0.196, 0.218, 0.24, 0.268, 0.294,
    0.33, 0.36,
  ],
  u: [
    0.018, 0.023, 0.028, 0.033, 0.033, 0.041, 0.048, 0.06, 0.07, 0.087, 0.102, 0.124, 0.144, 0.17, 0.19, 0.21, 0.236,
    0.258, 0.284, 0.315, 0.35, 0.39, 0.435, 0.49, 0.54,
  ],
  x: [
    0.02, 0.028, 0.034, 0.04, 0.045, 0.054, 0.064, 0.08, 0.097, 0.122, 0.146, 0.178, 0.21, 0.248, 0.28, 0.31, 0.35,
    0.385, 0.425, 0.475, 0.525, 0.59, 0.66, 0.74, 0.82,
  ],
  z: [
    0.026, 0.035, 0.042, 0.05, 0.06, 0.073, 0.088, 0.112, 0.136, 0.172, 0.21, 0.258, 0.31, 0.365, 0.415, 0.465, 0.52,
    0.575, 0.64, 0.71, 0.79, 0.9, 1, 1.1, 1.25,
  ],
};

/** By grade: lower deviation of shafts j, and upper deviation of holes J, by range; no formula gives them. */
const J_SHAFT: Readonly<Record<number, readonly number[]>> = {
  5: [-0.002, -0.002, -0.002, -0.003, -0.004, -0.005, -0.007, -0.009, -0.011, -0.013, -0.016, -0.018, -0.02],
  6: [-0.002, -0.002, -0.002, -0.003, -0.004, -0.005, -0.007, -0.009, -0.011, -0.013, -0.016, -0.018, -0.02],
  7: [-0.004, -0.004, -0.005, -0.006, -0.008, -0.01, -0.012, -0.015, -0.018, -0.021, -0.026, -0.028, -0.032],
};
const J_HOLE: Readonly<Record<number, readonly number[]>> = {
  6: [0.002, 0.005, 0.005, 0.006, 0.008, 0.01, 0.013, 0.016, 0.018, 0.022, 0.025, 0.029, 0.033],
  7: [0.004, 0.006, 0.008, 0.01, 0.012, 0.014, 0.018, 0.022, 0.026, 0.03, 0.036, 0.039, 0.043],
  8: [0.006, 0.01, 0.012, 0.015, 0.02, 0.024, 0.028, 0.034, 0.041, 0.047, 0.055, 0.06, 0.066],
};

/** Smallest size without the wide clearances of a, b and of holes N above grade 8, and range of the correction, mm. */
const LEAST_WIDE = 1;
const FIRST_RANGE = 3;
/** Last grades whose K, M, N, and whose P and above, are corrected; last grade with a transition k. */
const LAST_KMN = 8;
const LAST_P = 7;
/** What holes M6 above 250 to 315 mm are above the formula, mm. */
const EXCEPTION = 0.002;

const valueIn = (table: Readonly<Record<string, readonly number[]>>, letter: string, size: number): number | null => {
  const values = table[letter] ?? [];
  const ends = values.length === TOLERANCE_RANGES.length ? TOLERANCE_RANGES : FINE;
  return values[rangeOf(size, ends) - (ends.length - values.length)] ?? null;
};

/** A deviation and the side of the tolerance zone that it limits. */
type Fundamental = Partial<Deviations>;

function ofShaft(letter: string, grade: number, size: number): Fundamental | null {
  if (letter === "j") {
    const lower = J_SHAFT[grade]?.[rangeOf(size, TOLERANCE_RANGES)];
    return lower === undefined ? null : { lower };
  }
  const below = valueIn(BELOW, letter, size);
  if (below !== null) return "ab".includes(letter) && size < LEAST_WIDE ? null : { upper: -below };
  // Above grade 7 the zone of k begins at the nominal size.
  const above = letter === "k" && grade > LAST_P ? 0 : valueIn(ABOVE, letter, size);
  return above === null ? null : { lower: above };
}

/** The step between a grade and the next finer one, by which holes of the same fit are shifted; 0 up to 3 mm. */
function correction(grade: number, size: number): number {
  const [it, finer] = [standardTolerance(grade, size), standardTolerance(grade - 1, size)];
  return size <= FIRST_RANGE || it === null || finer === null ? 0 : it - finer;
}

function ofHole(letter: string, grade: number, size: number): Fundamental | null {
  if (letter === "j") {
    const upper = J_HOLE[grade]?.[rangeOf(size, TOLERANCE_RANGES)];
    return upper === undefined ? null : { upper };
  }
  const below = valueIn(BELOW, letter, size);
  if (below !== null) return "ab".includes(letter) && size < LEAST_WIDE ? null : { lower: below };
  const above = valueIn(ABOVE, letter, size);
  if (above === null) return null;
  const isTransition = "kmn".includes(letter);
  if (isTransition && grade > LAST_KMN) {
    if (letter === "n") return size < LEAST_WIDE ? null : { upper: size <= FIRST_RANGE ? -above : 0 };
    return letter === "k" && size > FIRST_RANGE ? null : { upper: -above };
  }
  const delta = grade <= (isTransition ? LAST_KMN : LAST_P) ? correction(grade, size) : 0;
  // The standard prints M6 in this range out of its own formula.
  const isException = letter === "m" && grade === 6 && size > 250 && size <= 315;
  return { upper: delta - above + (isException ? EXCEPTION : 0) };
}

/** Deviations are whole or half micrometres. */
const STEPS = 10_000;
const exact = (size: number): number => Math.round(size * STEPS) / STEPS || 0;

/**
 * Limit deviations of a tolerance class such as h6 (shaft) or H7 (hole) for a nominal size in mm; null for a letter, grade
 * or size without one. `letters`: small for shafts, capital for holes.
 */
export function deviationsOf(letters: string, grade: number, size: number): Deviations | null {
  const it = grade >= 5 ? standardTolerance(grade, size) : null;
  if (it === null) return null;
  const letter = letters.toLowerCase();
  if (letter === "js") return { upper: exact(it / 2), lower: exact(-it / 2) };
  if (letters !== letter && letters !== letters.toUpperCase()) return null;
  const found = letters === letter ? ofShaft(letter, grade, size) : ofHole(letter, grade, size);
  if (!found) return null;
  const upper = found.upper ?? (found.lower ?? 0) + it;
  return { upper: exact(upper), lower: exact(found.lower ?? upper - it) };
}
