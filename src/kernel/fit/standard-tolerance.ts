/*
 * Standard tolerances of ISO 286-1 up to 500 mm (tag S: public transcriptions of the standard; the sources are in
 * decision 0056). µm.
 */

/** Upper ends of the ranges of sizes, mm: above the one before, up to this. */
export const TOLERANCE_RANGES: readonly number[] = [3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500];

/** By grade; one value for each range, µm. Grade 4 only serves the deviations of holes of grade 5. */
const GRADES: Readonly<Record<number, readonly number[]>> = {
  4: [3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20],
  5: [4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27],
  6: [6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40],
  7: [10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63],
  8: [14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97],
  9: [25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155],
  10: [40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250],
  11: [60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400],
  12: [100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630],
  13: [140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970],
  14: [250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550],
};

/** Index of the range of a size in a list of upper ends; −1 for 0, less, or more than the last. */
export const rangeOf = (size: number, ends: readonly number[]): number =>
  size > 0 ? ends.findIndex((end) => size <= end) : -1;

/** Standard tolerance IT of a grade for a nominal size in mm, µm; null for a grade or size that is not in the table. */
export const standardTolerance = (grade: number, size: number): number | null =>
  GRADES[grade]?.[rangeOf(size, TOLERANCE_RANGES)] ?? null;
