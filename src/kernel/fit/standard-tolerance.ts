/*
 * Standard tolerances of ISO 286-1 up to 500 mm (tag S: public transcriptions of the standard; the sources are in
 * decision 0056), mm.
 */

/** Upper ends of the ranges of sizes, mm: above the one before, up to this. */
export const TOLERANCE_RANGES: readonly number[] = [3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500];

/** By grade; one value for each range. Grade 4 only serves the deviations of holes of grade 5. */
const GRADES: Readonly<Record<number, readonly number[]>> = {
  4: [0.003, 0.004, 0.004, 0.005, 0.006, 0.007, 0.008, 0.01, 0.012, 0.014, 0.016, 0.018, 0.02],
  5: [0.004, 0.005, 0.006, 0.008, 0.009, 0.011, 0.013, 0.015, 0.018, 0.02, 0.023, 0.025, 0.027],
  6: [0.006, 0.008, 0.009, 0.011, 0.013, 0.016, 0.019, 0.022, 0.025, 0.029, 0.032, 0.036, 0.04],
  7: [0.01, 0.012, 0.015, 0.018, 0.021, 0.025, 0.03, 0.035, 0.04, 0.046, 0.052, 0.057, 0.063],
  8: [0.014, 0.018, 0.022, 0.027, 0.033, 0.039, 0.046, 0.054, 0.063, 0.072, 0.081, 0.089, 0.097],
  9: [0.025, 0.03, 0.036, 0.043, 0.052, 0.062, 0.074, 0.087, 0.1, 0.115, 0.13, 0.14, 0.155],
  10: [0.04, 0.048, 0.058, 0.07, 0.084, 0.1, 0.12, 0.14, 0.16, 0.185, 0.21, 0.23, 0.25],
  11: [0.06, 0.075, 0.09, 0.11, 0.13, 0.16, 0.19, 0.22, 0.25, 0.29, 0.32, 0.36, 0.4],
  12: [0.1, 0.12, 0.15, 0.18, 0.21, 0.25, 0.3, 0.35, 0.4, 0.46, 0.52, 0.57, 0.63],
  13: [0.14, 0.18, 0.22, 0.27, 0.33, 0.39, 0.46, 0.54, 0.63, 0.72, 0.81, 0.89, 0.97],
  14: [0.25, 0.3, 0.36, 0.43, 0.52, 0.62, 0.74, 0.87, 1, 1.15, 1.3, 1.4, 1.55],
};

/** Index of the range of a size in a list of upper ends; −1 for 0, less, or more than the last. */
export const rangeOf = (size: number, ends: readonly number[]): number =>
  size > 0 ? ends.findIndex((end) => size <= end) : -1;

/** Standard tolerance IT of a grade for a nominal size, mm; null for a grade or size that is not in the table. */
export const standardTolerance = (grade: number, size: number): number | null =>
  GRADES[grade]?.[rangeOf(size, TOLERANCE_RANGES)] ?? null;
