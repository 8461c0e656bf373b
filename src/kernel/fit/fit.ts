import { rangeOf, standardTolerance, TOLERANCE_RANGES } from "./standard-tolerance.ts";

/*
 * Fundamental deviations of ISO 286-1 up to 500 mm (tag S, sources in decision 0056), µm. The rare letters cd, ef, fg, y,
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
    270, 270, 280, 290, 290, 300, 300, 310, 320, 340, 360, 380, 410, 460, 520, 580, 660, 740, 820, 920, 1050, 1200,
    1350, 1500, 1650,
  ],
  b: [
    140, 140, 150, 150, 150, 160, 160, 170, 180, 190, 200, 220, 240, 260, 280, 310, 340, 380, 420, 480, 540, 600, 680,
    760, 840,
  ],
  c: [
    60, 70, 80, 95, 95, 110, 110, 120, 130, 140, 150, 170, 180, 200, 210, 230, 240, 260, 280, 300, 330, 360, 400, 440,
    480,
  ],
  d: [20, 30, 40, 50, 65, 80, 100, 120, 145, 170, 190, 210, 230],
  e: [14, 20, 25, 32, 40, 50, 60, 72, 85, 100, 110, 125, 135],
  f: [6, 10, 13, 16, 20, 25, 30, 36, 43, 50, 56, 62, 68],
  g: [2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 18, 20],
  h: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
};

/** Distance of the lower deviation ei of shafts above the nominal size, by range; NaN where the letter has none. */
const ABOVE: Readonly<Record<string, readonly number[]>> = {
  k: [0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5],
  m: [2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23],
  n: [4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40],
  p: [6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68],
  r: [10, 15, 19, 23, 23, 28, 28, 34, 34, 41, 43, 51, 54, 63, 65, 68, 77, 80, 84, 94, 98, 108, 114, 126, 132],
  s: [14, 19, 23, 28, 28, 35, 35, 43, 43, 53, 59, 71, 79, 92, 100, 108, 122, 130, 140, 158, 170, 190, 208, 232, 252],
  t: [
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    41,
    48,
    54,
    66,
    75,
    91,
    104,
    122,
    134,
    146,
    166,
    180,
    196,
    218,
    240,
    268,
    294,
    330,
    360,
  ],
  u: [
    18, 23, 28, 33, 33, 41, 48, 60, 70, 87, 102, 124, 144, 170, 190, 210, 236, 258, 284, 315, 350, 390, 435, 490, 540,
  ],
  x: [
    20, 28, 34, 40, 45, 54, 64, 80, 97, 122, 146, 178, 210, 248, 280, 310, 350, 385, 425, 475, 525, 590, 660, 740, 820,
  ],
  z: [
    26, 35, 42, 50, 60, 73, 88, 112, 136, 172, 210, 258, 310, 365, 415, 465, 520, 575, 640, 710, 790, 900, 1000, 1100,
    1250,
  ],
};

/** By grade: lower deviation of shafts j, and upper deviation of holes J, by range; no formula gives them. */
const J_SHAFT: Readonly<Record<number, readonly number[]>> = {
  5: [-2, -2, -2, -3, -4, -5, -7, -9, -11, -13, -16, -18, -20],
  6: [-2, -2, -2, -3, -4, -5, -7, -9, -11, -13, -16, -18, -20],
  7: [-4, -4, -5, -6, -8, -10, -12, -15, -18, -21, -26, -28, -32],
};
const J_HOLE: Readonly<Record<number, readonly number[]>> = {
  6: [2, 5, 5, 6, 8, 10, 13, 16, 18, 22, 25, 29, 33],
  7: [4, 6, 8, 10, 12, 14, 18, 22, 26, 30, 36, 39, 43],
  8: [6, 10, 12, 15, 20, 24, 28, 34, 41, 47, 55, 60, 66],
};

/** Smallest size without the wide clearances of a, b and of holes N above grade 8, and range of the correction, mm. */
const LEAST_WIDE = 1;
const FIRST_RANGE = 3;
/** Last grades whose K, M, N, and whose P and above, are corrected; last grade with a transition k. */
const LAST_KMN = 8;
const LAST_P = 7;

const valueIn = (table: Readonly<Record<string, readonly number[]>>, letter: string, size: number): number | null => {
  const values = table[letter];
  const value = values?.[rangeOf(size, values.length === FINE.length ? FINE : TOLERANCE_RANGES)];
  return value === undefined || Number.isNaN(value) ? null : value;
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
  // The standard prints this one zone out of its own formula.
  const isException = letter === "m" && grade === 6 && size > 250 && size <= 315;
  return { upper: delta - above + (isException ? 2 : 0) };
}

/** Digits of a micrometre in a millimetre. */
const inMm = (micrometres: number): number => (Math.round(micrometres * 10) || 0) / 10_000;

/**
 * Limit deviations of a tolerance class such as h6 (shaft) or H7 (hole) for a nominal size in mm; null for a letter, grade
 * or size without one. `letters`: small for shafts, capital for holes.
 */
export function deviationsOf(letters: string, grade: number, size: number): Deviations | null {
  const it = grade >= 5 ? standardTolerance(grade, size) : null;
  if (it === null) return null;
  const letter = letters.toLowerCase();
  if (letter === "js") return { upper: inMm(it / 2), lower: inMm(-it / 2) };
  if (letters !== letter && letters !== letters.toUpperCase()) return null;
  const found = letters === letter ? ofShaft(letter, grade, size) : ofHole(letter, grade, size);
  if (!found) return null;
  const upper = found.upper ?? (found.lower ?? 0) + it;
  return { upper: inMm(upper), lower: inMm(found.lower ?? upper - it) };
}
