import type { Shape } from "../../shape.ts";

/** The choice of a cycle: on the start page, and where a block is put into a program. */
export const chooser = {
  cycles: "Cycles",
  search: "Search the cycles",
  hint: "Number, name or shop word",
  languages: "Search in any of the four languages.",
  keys: "Arrow keys go from cycle to cycle.",
  found: (n: number) => (n === 1 ? "1 cycle found." : `${n} cycles found.`),
  enter: (cycle: string) => `Enter takes ${cycle}.`,
  none: "No cycle fits these words.",
  /** Why a cycle cannot be begun or put in here, though the control has it. */
  acts: (cycle: string) =>
    `${cycle}: no work by itself, it acts where it stands in a program. Open one and insert it there, under Cycle.`,
  kept: (cycle: string) =>
    `${cycle}: shown and kept in a program, but not run; nothing behind it is proved. Paste its lines into the program text.`,
  recent: "Recently used",
  recentOne: (cycle: string) => `Recently used: ${cycle}`,
  count: (n: number) => (n === 1 ? "1 cycle" : `${n} cycles`),
  /** What a row says of a cycle whose parameter list no page prints. */
  recalled: "list recalled",
  empty: "Empty",
  insert: "Insert",
  back: "All blocks",
};

export type ChooserTexts = Shape<typeof chooser>;
