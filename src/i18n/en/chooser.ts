import type { Shape } from "../shape.ts";

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
