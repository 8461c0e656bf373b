import type { Shape } from "../../shape.ts";

/** The choice of a cycle: on the start page, and where a block is put into a program. */
export const chooser = {
  cycles: "Cycles",
  search: "Search the cycles",
  hint: "Search by number, name or shop term",
  languages: "Search in any of the four languages.",
  found: (n: number) => (n === 1 ? "1 cycle found." : `${n} cycles found.`),
  enter: (cycle: string) => `Enter selects ${cycle}.`,
  none: "No cycle matches these words.",
  /** Why a cycle cannot be selected here, although the control has it. */
  acts: (cycle: string) =>
    `${cycle}: takes effect only within a program. Open a program and insert the cycle there, under Cycle.`,
  kept: (cycle: string) =>
    `${cycle}: shown in a program but not simulated; the program is unverified from there on. Paste the lines of the cycle into the program text.`,
  recent: "Recently used",
  recentOne: (cycle: string) => `Recently used: ${cycle}`,
  count: (n: number) => (n === 1 ? "1 cycle" : `${n} cycles`),
  /** Which parameter lists are printed in a manual. */
  evidence: (cycles: string) =>
    `The parameter lists of ${cycles} are checked against the manual. Check those of all other cycles on your control.`,
  evidenceLink: "Parameter lists in the guide",
  empty: "Blank",
  insert: "Insert",
  back: "All blocks",
};

export type ChooserTexts = Shape<typeof chooser>;
