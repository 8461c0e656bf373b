import { INCH_ROUNDED } from "../tolerance.ts";
import type { Diameter } from "../units.ts";

/**
 * Depth of the metric profile in pitches: of an outside thread, and of an inside one. Printed for HEIDENHAIN lathes
 * (tag L: MANUALplus 4110 p. 170, MANUALplus 620 and CNC PILOT 640 (54843x-03) p. 130, CNC PILOT 4290 p. 525).
 */
export const METRIC = { outside: 0.6134, inside: 0.5413 } as const;
/** Angle between the flanks of that profile, degrees. */
export const METRIC_ANGLE = 60;

/** Sizes of ISO 261 up to 72 mm: nominal diameter, coarse pitch (null where there is none), fine pitches, mm. */
export const METRIC_SIZES: readonly (readonly [nominal: number, coarse: number | null, ...fine: number[]])[] = [
  [1, 0.25, 0.2],
  [1.2, 0.25, 0.2],
  [1.4, 0.3, 0.2],
  [1.6, 0.35, 0.2],
  [1.8, 0.35, 0.2],
  [2, 0.4, 0.25],
  [2.5, 0.45, 0.35],
  [3, 0.5, 0.35],
  [3.5, 0.6, 0.35],
  [4, 0.7, 0.5],
  [5, 0.8, 0.5],
  [6, 1, 0.75],
  [7, 1, 0.75],
  [8, 1.25, 1, 0.75],
  [9, 1.25, 1, 0.75],
  [10, 1.5, 1.25, 1, 0.75],
  [11, 1.5, 1, 0.75],
  [12, 1.75, 1.5, 1.25, 1],
  [14, 2, 1.5, 1.25, 1],
  [15, null, 1.5, 1],
  [16, 2, 1.5, 1],
  [17, null, 1.5, 1],
  [18, 2.5, 2, 1.5, 1],
  [20, 2.5, 2, 1.5, 1],
  [22, 2.5, 2, 1.5, 1],
  [24, 3, 2, 1.5, 1],
  [25, null, 2, 1.5, 1],
  [26, null, 1.5],
  [27, 3, 2, 1.5, 1],
  [28, null, 2, 1.5, 1],
  [30, 3.5, 3, 2, 1.5, 1],
  [32, null, 2, 1.5],
  [33, 3.5, 3, 2, 1.5],
  [35, null, 1.5],
  [36, 4, 3, 2, 1.5],
  [38, null, 1.5],
  [39, 4, 3, 2, 1.5],
  [40, null, 3, 2, 1.5],
  [42, 4.5, 4, 3, 2, 1.5],
  [45, 4.5, 4, 3, 2, 1.5],
  [48, 5, 4, 3, 2, 1.5],
  [50, null, 3, 2, 1.5],
  [52, 5, 4, 3, 2, 1.5],
  [55, null, 4, 3, 2, 1.5],
  [56, 5.5, 4, 3, 2, 1.5],
  [58, null, 4, 3, 2, 1.5],
  [60, 5.5, 4, 3, 2, 1.5],
  [62, null, 4, 3, 2, 1.5],
  [64, 6, 4, 3, 2, 1.5],
  [65, null, 4, 3, 2, 1.5],
  [68, 6, 4, 3, 2, 1.5],
  [70, null, 6, 4, 3, 2, 1.5],
  [72, 6, 4, 3, 2, 1.5],
];

/** Greatest deviation of a bore from the core of its size, in pitches: more than the tolerance 6H of a core. */
const BORE = 0.25;

/**
 * The nominal diameter, mm, of the inside thread whose bore is programmed with this diameter. A size with this pitch is
 * taken as the nominal diameter itself, any other as the core: of the nearest size, or of an unlisted one (decision
 * 0005).
 */
export function nominalOfBore(bore: Diameter, pitch: number): number {
  const sizes = METRIC_SIZES.filter(([, ...pitches]) => pitches.includes(pitch)).map(([nominal]) => nominal);
  const listedSize = sizes.find((nominal) => Math.abs(nominal - bore) <= INCH_ROUNDED);
  if (listedSize !== undefined) return listedSize;
  const computedNominal = bore + METRIC.inside * pitch * 2;
  const near = sizes.filter((nominal) => Math.abs(nominal - computedNominal) <= BORE * pitch);
  const apart = (nominal: number) => Math.abs(nominal - computedNominal);
  return near.length === 0 ? computedNominal : near.reduce((a, b) => (apart(b) < apart(a) ? b : a));
}
