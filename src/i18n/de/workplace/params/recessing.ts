import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "Begrenzung der Stechtiefe?",
    printed: false,
    label: "Tiefenbegrenzung",
    explanation:
      "Größte Tiefe je Zustellung. Ein tieferer Stich wird gleichmäßig aufgeteilt; dazwischen fährt das Werkzeug zum " +
      "Spanbrechen 0,5 mm zurück. 0: jeder Stich in einer Zustellung.",
  },
  recessingOverlap: {
    prompt: "Überlappung beim Stechen?",
    printed: false,
    label: "Überlappung",
    explanation:
      "Seitlicher Versatz von Stich zu Stich als Anteil von CUTWIDTH. Die Schritte werden gleichmäßig " +
      "aufgeteilt, der letzte Stich liegt an der anderen Flanke. Beim Kammstechen: Breite eines Stegs.",
  },
  solidFeed: {
    prompt: "Vorschubfaktor im Vollen?",
    printed: false,
    label: "Vorschub im Vollen",
    explanation:
      "Vorschub eines Stichs ins Volle in Prozent des Schruppvorschubs Q478. Ein Stich, der einen vorigen " +
      "überlappt, hat den vollen Vorschub.",
  },
  retraction: {
    prompt: "Rückzugsmodus (0/1)?",
    printed: false,
    label: "Rückzug",
    explanation: "Wie das Werkzeug einen Stich verlässt.",
    choices: { 0: "gerade heraus, entlang der Kontur", 1: "zuerst schräg von der Flanke weg, dann heraus" },
  },
  dwellTurns: {
    prompt: "Verweilzeit in Umdrehungen?",
    printed: false,
    label: "Verweilen",
    explanation: "Spindelumdrehungen, die das Werkzeug am Grund eines Stichs verweilt, bevor es zurückzieht.",
  },
  combRecessing: {
    prompt: "Kammstechen (0/1)?",
    printed: false,
    label: "Kammstechen",
    explanation: "Reihenfolge der Stiche.",
    choices: { 0: "jeder neben dem vorigen, überlappend", 1: "zuerst volle Stiche, dann die Stege dazwischen" },
  },
} satisfies SomeParamTexts;
