import type { HelpMenuTexts } from "../../en/first/help.ts";

export const helpMenu = {
  open: "Aide",
  long: "Aide, conditions de coupe, glossaire",
  menu: "Menu",
  cycle: (cycle) => `Cycle ${cycle} pas à pas`,
  guide: "Aide de tous les cycles et séquences",
  course: "Cours",
} satisfies HelpMenuTexts;
