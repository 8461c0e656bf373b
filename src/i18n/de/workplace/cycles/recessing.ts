import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "ins Volle stechen mit dem Vorschub im Vollen, bis auf das Aufmaß",
  "am Grund verweilen, dann aus dem Einstich zurückziehen",
  "seitlich um die Überlappung, vor dem Werkstück",
  "neben dem vorigen Stich einstechen, mit Schruppvorschub",
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
  "Schruppt vom Grund zu einer Flanke und zurück zur anderen, schlichtet oder macht beides. Beim Kammstechen " +
  "kommen erst die vollen Stiche, dann die Stege dazwischen.";
const notes = [
  turnMode,
  safePosition,
  "Zwei Stiche liegen nie weiter auseinander als der ebene Teil der Schneide (Breite minus zweimal Radius), wenn " +
    "der mindestens halb so breit ist: So bleibt dazwischen nichts stehen.",
  "Ein Einstich, der tiefer ist als CUTLENGTH, wird mit einer Meldung nur so tief gestochen, wie die Schneide lang " +
    "ist.",
  "Parameterliste und Schritte sind aus der Erinnerung; eine gedruckte Seite liegt uns nicht vor. Unsere Auslegung; an " +
    "der Steuerung prüfen.",
];
const sections =
  "Eine Kontur mit mehreren Tälern wird Abschnitt für Abschnitt gestochen, jeder bis zum Grund und an den Flanken " +
  "entlang vor dem nächsten.";

export const recessing = {
  860: {
    name: "Stechen Kontur radial",
    summary: "Sticht eine Kontur in Zylinder oder Bohrung, mit beliebig vielen Einstichen.",
    description: [
      "Nimmt weg, was zwischen der Kontur eines Unterprogramms und dem Startpunkt liegt, mit Stichen zur Achse hin, in " +
        "der Bohrung von ihr weg. Zyklus 14 nennt vorher die Kontur.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "Stechen einfach radial",
    summary: "Sticht einen Einstich mit geraden Flanken in Zylinder oder Bohrung, vom Startpunkt zu einer Ecke.",
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
      "Fertigt im Zylinder oder in der Bohrung einen Einstich mit Stichen nebeneinander. Die Kanten können eine Fase " +
        "oder einen Radius bekommen, beide Flanken können geneigt, die Ecken am Grund verrundet sein.",
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
      "Nimmt weg, was zwischen der Kontur eines Unterprogramms und dem Startpunkt liegt, mit Stichen entlang der " +
        "Achse. Zyklus 14 nennt vorher die Kontur.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  871: {
    name: "Stechen einfach axial",
    summary: "Sticht einen Einstich mit geraden Flanken in eine Planfläche, vom Startpunkt zu einer Ecke.",
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
      "Fertigt in der Planfläche einen Einstich mit Stichen nebeneinander. Die Kanten können eine Fase oder einen " +
        "Radius bekommen, beide Flanken können geneigt, die Ecken am Grund verrundet sein.",
      order,
    ],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
