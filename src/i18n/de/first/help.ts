import type { HelpMenuTexts } from "../../en/first/help.ts";

export const helpMenu = {
  open: "Hilfe",
  long: "Hilfe, Schnittdaten, Glossar",
  menu: "Menü",
  cycle: (cycle) => `Zyklus ${cycle} Schritt für Schritt`,
  guide: "Hilfe zu allen Zyklen und Sätzen",
  course: "Kurs",
} satisfies HelpMenuTexts;
