/** Limits that keep every run finite and its memory small; far above real programs (docs/performance.md). */
export const MOST_BLOCKS = 1_500_000;
/** Blocks executed beyond the farthest one reached: a loop that never ends stops here, however long the program is. */
export const MOST_REPEATED = 400_000;
/** Moves of milling and turning together, and of turning alone, which is simulated move by move. */
export const MOST_MOVES = 1_200_000;
export const MOST_TURNED = 400_000;
export const MOST_OPERATIONS = 2_000;
/**
 * Greatest number that a program can state or compute, and the smallest one that is not taken as 0. A control counts no
 * farther, and products and quotients of numbers within these bounds stay finite: passes, seconds, areas.
 */
export const MOST_NUMBER = 1e10;
export const LEAST_NUMBER = 1e-10;
