import type { IsoGroup } from "./cutting-table.ts";

/*
 * Starting values of work that the cutting data of a material do not state: threads, recesses, parting off and drills.
 * Sources: decision 0056. Lengths mm, feeds mm/rev, speeds m/min.
 */

/** Cutting speed of a kind of work as a share of the roughing speed of the material. */
export const SPEED_SHARE = { recess: 0.8, partOff: 0.7, thread: 0.65 } as const;

/** Feed of a plunge, as a share of the width of the blade. */
export const FEED_OF_WIDTH = 0.04;
/** Depth of a groove, in widths of the blade, above which the blade bends or breaks. */
export const DEEPEST_GROOVE = 8;
/** Depth of a side cut with a blade, as a share of its width. */
export const DEPTH_OF_WIDTH = 0.5;
/** Depth of a groove, in widths of the blade, from which the chip is broken by steps. */
export const STEPS_FROM_WIDTHS = 1.5;

/** Drills of high-speed steel: cutting speed, and feed as a share of the diameter; hardened steel is not drilled. */
export const HSS_DRILL: Readonly<Record<IsoGroup, { readonly speed: number; readonly feed: number } | null>> = {
  P: { speed: 24, feed: 0.02 },
  M: { speed: 12, feed: 0.015 },
  K: { speed: 22, feed: 0.02 },
  N: { speed: 60, feed: 0.02 },
  S: { speed: 7, feed: 0.015 },
  H: null,
};
/** Greatest feed of a drill. */
export const MOST_DRILL_FEED = 0.3;
/** Reamers of high-speed steel: speed as a share of that of the drill, feed as a share of the diameter, greatest feed. */
export const HSS_REAMER = { speed: 0.5, feed: 0.02, most: 0.4 } as const;
/** Pecks of a deep hole in diameters: the first one, how much shorter each next one is, and the shortest. */
export const PECKS = { first: 2, less: 0.5, least: 1 } as const;
/** Depth of a hole in diameters from which a drill goes slower; speed and feed are these shares. */
export const DEEP_HOLES: readonly (readonly [from: number, speed: number, feed: number])[] = [
  [3, 0.9, 0.9],
  [4, 0.8, 0.9],
  [5, 0.7, 0.8],
  [6, 0.6, 0.8],
];

/** Passes of a thread by its pitch: up to, number. */
export const THREAD_PASSES: readonly (readonly [pitch: number, passes: number])[] = [
  [0.75, 5],
  [1, 6],
  [1.5, 7],
  [2, 9],
  [3, 11],
  [4, 14],
  [6, 16],
  [Infinity, 20],
];
/** Greatest first pass of a thread. */
export const MOST_FIRST_PASS = 0.5;

/** Modulus of elasticity, N/mm²: of the workpiece by its group, and of a steel bar. */
export const ELASTICITY: Readonly<Record<IsoGroup, number>> = {
  P: 210_000,
  M: 200_000,
  K: 120_000,
  N: 70_000,
  S: 115_000,
  H: 210_000,
};
