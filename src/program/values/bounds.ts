/** Limits that keep every run finite and its memory small; far above real programs (docs/performance.md). */
export const MOST_BLOCKS = 1_500_000;
/** Moves of milling and turning together, and of turning alone, which is simulated move by move. */
export const MOST_MOVES = 1_200_000;
export const MOST_TURNED = 400_000;
export const MOST_OPERATIONS = 2_000;
