import type { Shape } from "../../shape.ts";

/** The choice of a cycle: on the start page, and where a block is put into a program. */
export const chooser = {
  cycles: "Cycles",
  search: "Search the cycles",
  hint: "Search by number, name or shop term",
  languages: "Search in any of the four languages.",
  keys: "Arrow keys move from cycle to cycle.",
  found: (n: number) => (n === 1 ? "1 cycle found." : `${n} cycles found.`),
  enter: (cycle: string) => `Enter selects ${cycle}.`,
  none: "No cycle matches these words.",
  /** Why a cycle cannot be begun or put in here, though the control has it. */
  acts: (cycle: string) =>
    `${cycle}: takes effect only within a program. Open a program and insert the cycle there, under Cycle.`,
  kept: (cycle: string) =>
    `${cycle}: shown in a program but not simulated; the program is unverified from there on. Paste the lines of the cycle into the program text.`,
  recent: "Recently used",
  recentOne: (cycle: string) => `Recently used: ${cycle}`,
  count: (n: number) => (n === 1 ? "1 cycle" : `${n} cycles`),
  /** What a row says of a cycle whose parameter list no page prints. */
  recalled: "Unverified",
  empty: "Blank",
  insert: "Insert",
  back: "All blocks",
};

export type ChooserTexts = Shape<typeof chooser>;
