import type { Shape } from "../shape.ts";

/** Find, replace and go to in a program text, and the actions on the whole text. */
export const find = {
  ctrl: "Ctrl",
  shift: "Shift",
  find: "Find",
  with: "Replace with",
  replace: "Replace",
  replaceOne: "Replace",
  replaceAll: "Replace all",
  previous: "Previous match",
  next: "Next match",
  close: "Close",
  position: (n: number, of: number) => `${n} of ${of}`,
  count: (n: number) => (n === 0 ? "No match" : n === 1 ? "1 match" : `${n} matches`),
  replaced: (n: number) => `${n} replaced`,
  goTo: "Go to",
  goToLong: "Block, LBL, tool, cycle or Q",
  block: (n: string) => `Block ${n}`,
  renumber: "Renumber blocks",
  fold: "Collapse or expand all cycles",
  tools: "Find and arrange",
};

export type FindTexts = Shape<typeof find>;
