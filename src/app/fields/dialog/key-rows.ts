const keys = (...rows: readonly string[]): readonly string[] => rows.flatMap((row) => row.split(" "));

/**
 * Keypads of a prompt, in rows of seven keys, flat of nine; ENT takes the rest of its row. A calculator with the keys of
 * the control, high and flat, and the keys of path words.
 */
export const KEY_ROWS = {
  sums: keys("7 8 9 / ( up erase", "4 5 6 * ) down noEnter", "1 2 3 - Q cancel end", "sign 0 point + enter"),
  flatSums: keys("7 8 9 / ( sign up erase noEnter", "4 5 6 * ) point down cancel end", "1 2 3 0 - + Q enter"),
  words: keys("7 8 9 up erase noEnter end", "4 5 6 down sign point I", "1 2 3 0 enter"),
} as const;

/** Keypads of a field outside the prompts: a number, or a number that may be left open. */
export const FIELD_ROWS = {
  words: {
    high: keys("7 8 9 / ( up erase", "4 5 6 * ) down letters", "1 2 3 - Q ready", "sign 0 point + enter"),
    flat: keys("7 8 9 / ( sign up erase letters", "4 5 6 * ) point down Q ready", "1 2 3 0 - + enter"),
  },
  open: {
    high: keys("7 8 9 / ( up erase", "4 5 6 * ) down letters", "1 2 3 - ? ready", "sign 0 point + enter"),
    flat: keys("7 8 9 / ( sign up erase letters", "4 5 6 * ) point down ? ready", "1 2 3 0 - + enter"),
  },
} as const;
