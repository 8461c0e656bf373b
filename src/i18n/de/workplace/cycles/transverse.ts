import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "achsparallel zustellen im Eilgang",
  "plan schneiden mit Schruppvorschub",
  "um die Zustellung zurückziehen",
  "im Eilgang zum Anfang des Schnitts",
  "wiederholen, bis die Kontur erreicht ist",
  "im Eilgang zum Zyklusstart",
];
const finish = [
  "zustellen im Eilgang",
  "Kontur von Start bis Ende schlichten",
  "um den Sicherheitsabstand zurückziehen",
  "im Eilgang zum Zyklusstart",
];
/** Of the cycles that have a contour of their own. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "Kontur plan",
    summary: "Dreht eine freie Kontur aus einem Unterprogramm, in Planrichtung.",
    description: [
      "Dreht eine beliebige Kontur in Planrichtung. Die Kontur steht als Unterprogramm aus Geraden, Rundungen, Fasen und Bögen " +
        "im Programm und wird mit Zyklus 14 oder SEL CONTOUR benannt.",
      "Schruppt achsparallel, schlichtet oder macht beides. Erster Konturpunkt in X größer als der letzte: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt Z des Startpunkts unter dem Konturstart, fährt das Werkzeug zuerst in Z auf den Konturstart; beim Schlichten auf " +
        "Sicherheitsabstand.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "Absatz plan",
    summary: "Plant einen rechtwinkligen Absatz, von der Werkzeugposition aus.",
    description: [
      "Dreht eine Planfläche und den Zylinder an ihrem Ende. Die Position des Werkzeugs beim Aufruf ist die eine Ecke des " +
        "Zerspanbereichs, das programmierte Ende die andere; Winkel und gebrochene Kanten gibt es nicht.",
      "Schruppt achsparallel in Planrichtung, schlichtet oder macht beides. Startpunkt weiter von der Drehachse weg als " +
        "Q493: Außenbearbeitung. Näher daran: Innenbearbeitung.",
    ],
    ...own,
  },
  822: {
    name: "Absatz plan erweitert",
    summary: "Plant einen Absatz, mit Fasen, Winkeln und Eckenradius.",
    description: [
      "Dreht einen Absatz in Planrichtung. Die Kanten an Konturstart und Konturende können eine Fase oder einen Radius " +
        "bekommen, Planfläche und Umfangsfläche können geneigt, die Innenecke kann verrundet sein.",
      "Schruppt achsparallel in Planrichtung, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in Z, dann in X auf Sicherheitsabstand.",
    ],
    ...own,
  },
  823: {
    name: "Drehen Eintauchen plan",
    summary: "Dreht hinter einer Flanke in eine Planfläche ein, quer zur Drehachse.",
    description: [
      "Dreht einen Bereich in einer Planfläche, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart hinab, über " +
        "einen Grund und bis an eine rechtwinklige Wand am Ende.",
      "Was neben dem Konturstart steht, bleibt in der Ebene von Q492 stehen. Unsere Auslegung; an der Steuerung prüfen.",
      "Schruppt achsparallel in Planrichtung, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in Z, dann in X auf Sicherheitsabstand neben den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "Drehen Eintauchen plan erweitert",
    summary:
      "Dreht hinter einer Flanke in eine Planfläche ein, mit gebrochenen Kanten, Eckenradien und geneigter Wand.",
    description: [
      "Dreht einen Bereich in einer Planfläche, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart hinab, über " +
        "einen Grund und eine Wand am Ende hinauf. Die Kanten an beiden Enden können eine Fase oder einen Radius bekommen, " +
        "beide Ecken am Grund können verrundet, die Wand kann geneigt sein.",
      "Was neben dem Konturstart steht, bleibt in der Ebene von Q492 stehen. Unsere Auslegung; an der Steuerung prüfen.",
      "Schruppt achsparallel in Planrichtung, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in Z, dann in X auf Sicherheitsabstand neben den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
