import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "achsparallel zustellen im Eilgang",
  "längs schneiden mit Schruppvorschub",
  "um die Zustellung zurückziehen",
  "im Eilgang zum Anfang des Schnitts",
  "wiederholen, bis die Kontur erreicht ist",
  "im Eilgang zum Zyklusstart",
];
const finish = [
  "achsparallel zustellen im Eilgang",
  "Kontur von Start bis Ende schlichten",
  "um den Sicherheitsabstand zurückziehen",
  "im Eilgang zum Zyklusstart",
];
const notes = [turnMode, safePosition, edgeLength];

export const longitudinal = {
  810: {
    name: "Kontur längs",
    summary: "Dreht eine freie Kontur aus einem Unterprogramm, in Längsrichtung.",
    description: [
      "Dreht eine beliebige Kontur in Längsrichtung: Wellen und Bohrungen mit Absätzen, Kegeln, Bögen, Freistichen und " +
        "Einstichen. Die Kontur steht in einem Unterprogramm und wird mit Zyklus 14 oder SEL CONTOUR benannt.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startpunkt weiter von der Drehachse weg als die Kontur: " +
        "Außenbearbeitung. Näher daran: Innenbearbeitung. Dazwischen entscheidet das Werkzeug, je nachdem wohin seine Spitze " +
        "zeigt. Unsere Auslegung; an der Steuerung prüfen.",
      "Die Kontur wird in der programmierten Richtung zerspant. Liegt X des Startpunkts unter dem Konturstart, fährt das " +
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
      "Dreht einen Zylinder und die Planfläche dahinter. Die Position des Werkzeugs beim Aufruf ist die eine Ecke des " +
        "Zerspanbereichs, das programmierte Ende die andere; Winkel und gebrochene Kanten gibt es nicht.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startpunkt weiter von der Drehachse weg als Q493: " +
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
      "Dreht einen Absatz in Längsrichtung. Die Kanten an Konturstart und Konturende können eine Fase oder einen Radius " +
        "bekommen, Umfangsfläche und Planfläche können geneigt, die Innenecke kann verrundet sein.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheitsabstand; beim " +
        "Schlichten zuerst in Z auf Sicherheitsabstand.",
    ],
    rough,
    finish,
    notes,
  },
  813: {
    name: "Drehen Eintauchen längs",
    summary: "Dreht hinter einer Flanke in einen Zylinder ein, in Längsrichtung.",
    description: [
      "Dreht einen Bereich, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart hinab, einen Zylinder entlang " +
        "und bis an eine rechtwinklige Planfläche am Ende.",
      "Was vor dem Konturstart steht, bleibt in der Höhe von Q491 stehen. Unsere Auslegung; an der Steuerung prüfen.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheitsabstand vor den " +
        "Konturstart.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  814: {
    name: "Drehen Eintauchen längs erweitert",
    summary:
      "Dreht hinter einer Flanke in einen Zylinder ein, mit gebrochenen Kanten, Eckenradien und geneigter Planfläche.",
    description: [
      "Dreht einen Bereich, in den das Werkzeug eintauchen muss: eine Flanke am Konturstart hinab, einen Zylinder entlang " +
        "und eine Planfläche am Ende hinauf. Die Kanten an beiden Enden können eine Fase oder einen Radius bekommen, beide " +
        "Ecken am Zylinder können verrundet, die Planfläche kann geneigt sein.",
      "Was vor dem Konturstart steht, bleibt in der Höhe von Q491 stehen. Unsere Auslegung; an der Steuerung prüfen.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheitsabstand vor den " +
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
      "Dreht eine Kontur aus einem Unterprogramm. Als Rohteil gilt die Kontur mit einem Aufmaß ringsum; die Schnitte laufen an der Kontur " +
        "entlang, jeder näher an ihr, statt längs der Achse.",
      "Schruppt, schlichtet oder macht beides. Die Richtung, in der die Kontur programmiert ist, ist die Bearbeitungsrichtung. Der " +
        "Startpunkt entscheidet zwischen außen und innen.",
      "Liegt der Startpunkt hinter dem Konturanfang, fährt das Werkzeug zuerst in Z auf den Sicherheitsabstand davor, beim Schruppen wie " +
        "beim Schlichten.",
    ],
    rough: [
      "im Eilgang zustellen vor den Schnitt",
      "entlang der Kontur schneiden mit Schruppvorschub",
      "in X zurück zur Startposition mit Schruppvorschub",
      "im Eilgang zum Anfang des nächsten Schnitts",
      "wiederholen, bis das Aufmaß erreicht ist",
      "im Eilgang zum Zyklusstart",
    ],
    finish: [
      "zustellen im Eilgang",
      "Kontur von Start bis Ende schlichten",
      "um den Sicherheitsabstand abheben",
      "im Eilgang zum Zyklusstart",
    ],
    notes: [
      turnMode,
      "Zyklus 14 muss vor dem Aufruf das Unterprogramm der Kontur nennen.",
      "Der erste Schnitt liegt eine Zustellung unter dem Aufmaß, wo auch immer der Startpunkt steht: Wo das Rohteil dicker ist, wird er " +
        "tiefer. Unsere Auslegung; an der Steuerung prüfen.",
      "Die Handbuchseite unterscheidet außen und innen nach Konturanfang und Konturende. Hier entscheidet die Seite des Startpunkts: Nach " +
        "der Handbuchseite wäre eine Welle, die zum Futter hin dicker wird, eine Innenbearbeitung. An der Steuerung prüfen.",
      "In einer Innenecke der Kontur nimmt ein Schnitt kurz mehr als seine Zustellung: bei einem rechten Winkel bis zu einem Sechstel.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
