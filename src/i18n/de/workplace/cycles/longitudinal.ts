import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, inclination, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "achsparallele Zustellung im Eilgang",
  "Längsschnitt mit Vorschub Schruppen",
  "Rückzug um die Zustellung",
  "im Eilgang zum Anfang des Schnitts",
  "wiederholen, bis die Kontur erreicht ist",
  "im Eilgang zum Zyklusstart",
];
const finish = [
  "achsparallele Zustellung im Eilgang",
  "Kontur von Start bis Ende schlichten",
  "Rückzug um den Sicherheitsabstand",
  "im Eilgang zum Zyklusstart",
];
const notes = [turnMode, safePosition, edgeLength];

export const longitudinal = {
  810: {
    name: "Kontur längs",
    summary: "Dreht eine freie Kontur aus einem Unterprogramm, in Längsrichtung.",
    description: [
      "Dreht eine beliebige Kontur in Längsrichtung: Wellen und Bohrungen mit Absätzen, Kegeln, Kreisbögen, " +
        "Freistichen und " +
        "Einstichen. Die Kontur ist ein Unterprogramm, gewählt mit Zyklus 14 oder SEL CONTOUR.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startpunkt weiter von der Drehachse weg als " +
        "die Kontur: " +
        "Außenbearbeitung. Näher daran: Innenbearbeitung. Dazwischen entscheidet die Werkzeugorientierung.",
      "Die Kontur wird in der programmierten Richtung bearbeitet. Liegt X des Startpunkts unter dem Konturstart, " +
        "fährt das " +
        "Werkzeug zuerst in X auf den Konturstart; beim Schlichten auf Sicherheitsabstand.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  811: {
    name: "Absatz längs",
    summary: "Dreht einen rechtwinkligen Absatz längs, von der Werkzeugposition aus.",
    description: [
      "Dreht einen Zylinder und die Planfläche dahinter. Die Position des Werkzeugs beim Aufruf ist die eine " +
        "Ecke des " +
        "Zerspanbereichs, das programmierte Ende die andere, ohne Winkel, Fasen und Rundungen.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startpunkt weiter von der Drehachse weg als " +
        "Q493: " +
        "Außenbearbeitung. Näher daran: Innenbearbeitung.",
    ],
    rough,
    finish,
    notes,
  },
  812: {
    name: "Absatz längs erweitert",
    summary: "Dreht einen Absatz längs, mit Fasen, Winkeln und Eckenradius.",
    description: [
      "Dreht einen Absatz in Längsrichtung. Die Kanten an Konturstart und Konturende können eine Fase oder einen " +
        "Radius haben, Umfangsfläche und Planfläche können geneigt, die Innenecke verrundet sein.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheitsabstand; " +
        "beim " +
        "Schlichten zuerst in Z auf Sicherheitsabstand.",
    ],
    rough,
    finish,
    notes: [...notes, inclination],
  },
  813: {
    name: "Drehen Eintauchen längs",
    summary: "Dreht hinter einer Flanke in einen Zylinder ein, in Längsrichtung.",
    description: [
      "Dreht einen Bereich, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart hinab, einen " +
        "Zylinder entlang " +
        "und bis an eine rechtwinklige Planfläche am Ende.",
      "Material vor dem Konturstart wird nicht bearbeitet; es bleibt auf der Höhe von Q491.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheitsabstand " +
        "vor den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  814: {
    name: "Drehen Eintauchen längs erweitert",
    summary: "Dreht hinter einer Flanke in einen Zylinder ein, mit Fasen, Radien und geneigter Planfläche.",
    description: [
      "Dreht einen Bereich, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart hinab, einen " +
        "Zylinder entlang " +
        "und eine Planfläche am Ende hinauf. Die Kanten an beiden Enden können eine Fase oder einen Radius " +
        "haben, beide " +
        "Ecken am Zylinder können verrundet, die Planfläche kann geneigt sein.",
      "Material vor dem Konturstart wird nicht bearbeitet; es bleibt auf der Höhe von Q491.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheitsabstand " +
        "vor den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  815: {
    name: "Drehen konturparallel",
    summary: "Zerspant eine freie Kontur mit Schnitten parallel zu ihr, wie an einem Guss- oder Schmiedeteil.",
    description: [
      "Dreht eine Kontur aus einem Unterprogramm. Als Rohteil gilt die Kontur mit einem Aufmaß ringsum; die " +
        "Schnitte verlaufen konturparallel, jeder näher an der Kontur, statt achsparallel.",
      "Schruppen, Schlichten oder Komplettbearbeitung. Die programmierte Richtung der Kontur ist die " +
        "Bearbeitungsrichtung. Der Startpunkt entscheidet zwischen Außen- und Innenbearbeitung.",
      "Liegt der Startpunkt hinter dem Konturstart, fährt das Werkzeug zuerst in Z auf den Sicherheitsabstand " +
        "davor, beim Schruppen wie " +
        "beim Schlichten.",
    ],
    rough: [
      "Zustellung im Eilgang vor den Schnitt",
      "Schnitt entlang der Kontur mit Vorschub Schruppen",
      "in X zurück zur Startposition mit Vorschub Schruppen",
      "im Eilgang zum Anfang des nächsten Schnitts",
      "wiederholen, bis das Aufmaß erreicht ist",
      "im Eilgang zum Zyklusstart",
    ],
    finish: [
      "Zustellung im Eilgang",
      "Kontur von Start bis Ende schlichten",
      "Rückzug um den Sicherheitsabstand",
      "im Eilgang zum Zyklusstart",
    ],
    notes: [
      turnMode,
      "Vor dem Aufruf mit Zyklus 14 das Unterprogramm der Kontur wählen.",
      "Der erste Schnitt liegt unabhängig vom Startpunkt eine Zustellung unter dem Aufmaß: Wo das Rohteil dicker " +
        "ist, wird der Schnitt tiefer.",
      "Das Handbuch unterscheidet Außen- und Innenbearbeitung nach Konturstart und Konturende; hier entscheidet " +
        "die Seite des Startpunkts. Nach dem Handbuch wäre eine Welle, die zum Futter hin dicker wird, eine " +
        "Innenbearbeitung. Nicht geprüft.",
      "In einer Innenecke der Kontur ist der Schnitt kurzzeitig tiefer als die Zustellung: bei einem rechten " +
        "Winkel um bis zu ein Sechstel.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
