import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "Begrenzung der Stechtiefe?",
    printed: false,
    label: "Tiefenbegrenzung",
    explanation:
      "Größte Tiefe je Zustellung. Ein tieferer Stich wird gleichmäßig aufgeteilt; dazwischen fährt das Werkzeug zum " +
      "Spanbrechen 0,5 mm zurück. 0: jeder Stich in einem Zug. Unsere Auslegung; an der Steuerung prüfen.",
  },
  recessingOverlap: {
    prompt: "Überlappung beim Stechen?",
    printed: false,
    label: "Überlappung",
    explanation:
      "Seitlicher Versatz von Stich zu Stich als Anteil von CUTWIDTH. Die Schritte sind gleichmäßig aufgeteilt, sodass " +
      "der letzte Stich an der anderen Flanke steht. Beim Kammstechen ist es die Breite eines Stegs.",
  },
  solidFeed: {
    prompt: "Vorschubfaktor im Vollen?",
    printed: false,
    label: "Vorschub im Vollen",
    explanation:
      "Vorschub eines Stichs ins Volle in Prozent des Schruppvorschubs Q478. Neben einem Stich, der ihn überlappt, " +
      "gilt der ganze Vorschub.",
  },
  retraction: {
    prompt: "Rückzugsmodus (0/1)?",
    printed: false,
    label: "Rückzug",
    explanation: "Wie das Werkzeug einen Stich verlässt. Unsere Auslegung; an der Steuerung prüfen.",
    choices: { 0: "gerade heraus, entlang der Kontur", 1: "erst schräg von der Flanke weg, dann heraus" },
  },
  dwellTurns: {
    prompt: "Verweilzeit in Umdrehungen?",
    printed: false,
    label: "Verweilen",
    explanation: "Wie viele Umdrehungen die Spindel macht, während das Werkzeug am Grund eines Stichs steht.",
  },
  combRecessing: {
    prompt: "Kammstechen (0/1)?",
    printed: false,
    label: "Kammstechen",
    explanation: "Die Reihenfolge der Stiche.",
    choices: { 0: "jeder neben dem vorigen, überlappend", 1: "erst volle Stiche, dann die Stege dazwischen" },
  },
} satisfies SomeParamTexts;
