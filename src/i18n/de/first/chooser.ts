import type { ChooserTexts } from "../../en/first/chooser.ts";

export const chooser = {
  cycles: "Zyklen",
  search: "Zyklen durchsuchen",
  hint: "Nummer, Name oder Werkstattbegriff",
  languages: "Suche in allen vier Sprachen.",
  keys: "Pfeiltasten gehen von Zyklus zu Zyklus.",
  found: (n) => (n === 1 ? "1 Zyklus gefunden." : `${n} Zyklen gefunden.`),
  enter: (cycle) => `Enter nimmt ${cycle}.`,
  none: "Kein Zyklus passt zu diesen Wörtern.",
  acts: (cycle) =>
    `${cycle}: wirkt nur in einem Programm, ab seiner Definition. Ein Programm öffnen und ihn dort unter „Zyklus“ einfügen.`,
  kept: (cycle) =>
    `${cycle}: bleibt im Programm und wird gezeigt, aber nicht ausgeführt; dahinter ist nichts geprüft. Seine Zeilen in den Text einfügen.`,
  recent: "Zuletzt verwendet",
  recentOne: (cycle) => `Zuletzt verwendet: ${cycle}`,
  count: (n) => (n === 1 ? "1 Zyklus" : `${n} Zyklen`),
  recalled: "Liste aus der Erinnerung",
  empty: "Leer",
  insert: "Einfügen",
  back: "Alle Sätze",
} satisfies ChooserTexts;
