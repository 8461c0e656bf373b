import type { FindTexts } from "../en/find.ts";

export const find: FindTexts = {
  ctrl: "Strg",
  shift: "Umschalt",
  find: "Suchen",
  with: "Ersetzen durch",
  replace: "Ersetzen",
  replaceOne: "Ersetzen",
  replaceAll: "Alle ersetzen",
  previous: "Vorherige Fundstelle",
  next: "Nächste Fundstelle",
  close: "Schließen",
  position: (n: number, of: number) => `${n} von ${of}`,
  count: (n: number) => (n === 0 ? "Keine Fundstelle" : n === 1 ? "1 Fundstelle" : `${n} Fundstellen`),
  replaced: (n: number) => `${n} ersetzt`,
  goTo: "Gehe zu",
  goToLong: "Satz, LBL, Werkzeug, Zyklus oder Q",
  block: (n: string) => `Satz ${n}`,
  renumber: "Sätze neu nummerieren",
  fold: "Alle Zyklen zu- oder aufklappen",
  tools: "Suchen und ordnen",
};
