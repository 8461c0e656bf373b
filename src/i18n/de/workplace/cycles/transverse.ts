import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "achsparallele Zustellung im Eilgang",
  "Planschnitt mit Vorschub Schruppen",
  "Rückzug um die Zustellung",
  "im Eilgang zum Anfang des Schnitts",
  "wiederholen, bis die Kontur erreicht ist",
  "im Eilgang zum Zyklusstart",
];
const finish = [
  "Zustellung im Eilgang",
  "Kontur von Start bis Ende schlichten",
  "Rückzug um den Sicherheitsabstand",
  "im Eilgang zum Zyklusstart",
];
/** Steps and notes of the cycles that describe the contour by parameters. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "Kontur plan",
    summary: "Dreht eine freie Kontur aus einem Unterprogramm, in Planrichtung.",
    description: [
      "Dreht eine beliebige Kontur in Planrichtung. Die Kontur ist ein Unterprogramm aus Geraden, Rundungen, " +
        "Fasen und Kreisbögen, gewählt mit Zyklus 14 oder SEL CONTOUR.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. X des Konturstarts größer als X des " +
        "Konturendes: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt Z des Startpunkts unter dem Konturstart, fährt das Werkzeug zuerst in Z auf den Konturstart; beim " +
        "Schlichten auf " +
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
      "Dreht eine Planfläche und den Zylinder an ihrem Ende. Die Position des Werkzeugs beim Aufruf ist die eine " +
        "Ecke des " +
        "Zerspanbereichs, das programmierte Ende die andere, ohne Winkel, Fasen und Rundungen.",
      "Schruppen achsparallel in Planrichtung, Schlichten oder Komplettbearbeitung. Startpunkt weiter von der " +
        "Drehachse weg als " +
        "Q493: Außenbearbeitung. Näher daran: Innenbearbeitung.",
    ],
    ...own,
  },
  822: {
    name: "Absatz plan erweitert",
    summary: "Plant einen Absatz, mit Fasen, Winkeln und Eckenradius.",
    description: [
      "Dreht einen Absatz in Planrichtung. Die Kanten an Konturstart und Konturende können eine Fase oder einen " +
        "Radius haben, Planfläche und Umfangsfläche können geneigt, die Innenecke verrundet sein.",
      "Schruppen achsparallel in Planrichtung, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als " +
        "Enddurchmesser: " +
        "Außenbearbeitung. Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in Z, dann in X auf Sicherheitsabstand.",
    ],
    ...own,
  },
  823: {
    name: "Drehen Eintauchen plan",
    summary: "Dreht hinter einer Flanke in eine Planfläche ein, quer zur Drehachse.",
    description: [
      "Dreht einen Bereich in einer Planfläche, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart " +
        "hinab, über " +
        "einen Grund und bis an eine rechtwinklige Wand am Ende.",
      "Material neben dem Konturstart wird nicht bearbeitet; es bleibt in der Ebene von Q492.",
      "Schruppen achsparallel in Planrichtung, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als " +
        "Enddurchmesser: " +
        "Außenbearbeitung. Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in Z, dann in X auf Sicherheitsabstand " +
        "neben den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "Drehen Eintauchen plan erweitert",
    summary: "Dreht hinter einer Flanke in eine Planfläche ein, mit Fasen, Radien und geneigter Wand.",
    description: [
      "Dreht einen Bereich in einer Planfläche, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart " +
        "hinab, über " +
        "einen Grund und eine Wand am Ende hinauf. Die Kanten an beiden Enden können eine Fase oder einen Radius " +
        "haben, beide Ecken am Grund können verrundet, die Wand kann geneigt sein.",
      "Material neben dem Konturstart wird nicht bearbeitet; es bleibt in der Ebene von Q492.",
      "Schruppen achsparallel in Planrichtung, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als " +
        "Enddurchmesser: " +
        "Außenbearbeitung. Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in Z, dann in X auf Sicherheitsabstand " +
        "neben den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
