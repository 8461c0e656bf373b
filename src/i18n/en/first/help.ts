import type { Shape } from "../../shape.ts";

/** The help menu of the header. */
export const helpMenu = {
  open: "Help",
  long: "Guide, cutting data, glossary",
  /** On a phone: the same menu, with the buttons that the header has no room for. */
  menu: "Menu",
  cycle: (cycle: number) => `Cycle ${cycle}, step by step`,
  guide: "Guide to all cycles and blocks",
  course: "Course",
};

export type HelpMenuTexts = Shape<typeof helpMenu>;
