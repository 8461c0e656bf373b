import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "ins Volle stechen mit dem Vorschub im Vollen, bis auf das Aufmaß",
  "am Grund verweilen, dann aus dem Einstich zurückziehen",
  "seitlich um die Überlappung, vor dem Werkstück",
  "neben dem vorigen Stich einstechen, mit Vorschub Schruppen",
  "wiederholen bis zur Breite, dann schräge oder runde Flanken",
  "im Eilgang zum Zyklusstart",
];
const finish = [
  "im Eilgang zur ersten Seite",
  "erste Flanke schlichten",
  "halben Grund schlichten, abheben",
  "im Eilgang freifahren",
  "im Eilgang zur zweiten Seite",
  "zweite Flanke schlichten",
  "die andere Hälfte des Grunds schlichten, abheben",
  "im Eilgang zum Zyklusstart",
];
const order =
  "Schruppen vom Grund zu einer Flanke und zurück zur anderen, Schlichten oder Komplettbearbeitung. Beim " +
  "Kammstechen zuerst die vollen Stiche, dann die Stege dazwischen.";
const notes = [
  turnMode,
  safePosition,
  "Ist der ebene Teil der Schneide (Breite minus zweimal Radius) mindestens halb so breit wie die Schneide, ist " +
    "der Versatz der Stiche nie größer als dieser Teil: Dazwischen bleibt kein Restmaterial.",
  "Ein Einstich tiefer als CUTLENGTH wird nur bis zu dieser Tiefe gefertigt, mit Meldung.",
  "Parameterliste und Schritte sind nicht am Handbuch geprüft; an der Steuerung prüfen.",
];
const sections =
  "Eine Kontur mit mehreren Konturtälern wird Abschnitt für Abschnitt bearbeitet: Grund und Flanken eines " +
  "Abschnitts vor dem nächsten.";

export const recessing = {
  860: {
    name: "Stechen Kontur radial",
    summary: "Sticht eine Kontur in Zylinder oder Bohrung, mit beliebig vielen Einstichen.",
    description: [
      "Trägt das Material zwischen der Kontur eines Unterprogramms und dem Startpunkt ab, mit Stichen zur Achse " +
        "hin, in der Bohrung von der Achse weg. Zyklus 14 wählt vorher die Kontur.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "Stechen einfach radial",
    summary: "Sticht einen Einstich mit senkrechten Flanken in Zylinder oder Bohrung, vom Startpunkt zu einer Ecke.",
    description: [
      "Fertigt im Zylinder oder in der Bohrung einen Einstich zwischen dem Startpunkt des Zyklus und der Ecke Q493, " +
        "Q494, mit Stichen nebeneinander. Der Startpunkt ist die erste Ecke des Einstichs.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  862: {
    name: "Stechen erweitert radial",
    summary: "Sticht einen Einstich in Zylinder oder Bohrung, mit geneigten Flanken, Fasen und Eckenradien.",
    description: [
      "Fertigt im Zylinder oder in der Bohrung einen Einstich mit Stichen nebeneinander. Die Kanten können eine " +
        "Fase oder einen Radius haben, beide Flanken können geneigt, die Ecken am Grund verrundet sein.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  870: {
    name: "Stechen Kontur axial",
    summary: "Sticht eine Kontur in eine Planfläche, mit beliebig vielen Einstichen.",
    description: [
      "Trägt das Material zwischen der Kontur eines Unterprogramms und dem Startpunkt ab, mit Stichen entlang " +
        "der Achse. Zyklus 14 wählt vorher die Kontur.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  871: {
    name: "Stechen einfach axial",
    summary: "Sticht einen Einstich mit senkrechten Flanken in eine Planfläche, vom Startpunkt zu einer Ecke.",
    description: [
      "Fertigt in der Planfläche einen Einstich zwischen dem Startpunkt des Zyklus und der Ecke Q493, Q494, mit " +
        "Stichen nebeneinander. Der Startpunkt ist die erste Ecke des Einstichs.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  872: {
    name: "Stechen erweitert axial",
    summary: "Sticht einen Einstich in eine Planfläche, mit geneigten Flanken, Fasen und Eckenradien.",
    description: [
      "Fertigt in der Planfläche einen Einstich mit Stichen nebeneinander. Die Kanten können eine Fase oder " +
        "einen Radius haben, beide Flanken können geneigt, die Ecken am Grund verrundet sein.",
      order,
    ],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
