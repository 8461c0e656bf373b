import type { ChooserTexts } from "../../en/first/chooser.ts";

export const chooser = {
  cycles: "Zyklen",
  search: "Zyklen durchsuchen",
  hint: "Suche nach Nummer, Name oder Fachbegriff",
  languages: "Suche in allen vier Sprachen.",
  found: (n) => (n === 1 ? "1 Zyklus gefunden." : `${n} Zyklen gefunden.`),
  enter: (cycle) => `Enter wählt ${cycle}.`,
  none: "Kein Zyklus mit diesen Wörtern.",
  acts: (cycle) =>
    `${cycle}: wirkt nur in einem Programm, ab der Definition. Ein Programm öffnen und den Zyklus dort unter „Zyklus“ einfügen.`,
  kept: (cycle) =>
    `${cycle}: bleibt im Programm, wird aber nicht simuliert; ab da ist das Programm ungeprüft. Die Zeilen des Zyklus in den Programmtext einfügen.`,
  recent: "Zuletzt verwendet",
  recentOne: (cycle) => `Zuletzt verwendet: ${cycle}`,
  count: (n) => (n === 1 ? "1 Zyklus" : `${n} Zyklen`),
  evidence: (cycles) =>
    `Die Parameterlisten von ${cycles} sind am Handbuch geprüft. Die der anderen Zyklen an der eigenen Steuerung prüfen.`,
  evidenceLink: "Parameterlisten in der Hilfe",
  empty: "Ohne Werte",
  insert: "Einfügen",
  back: "Alle Sätze",
} satisfies ChooserTexts;
