import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

const rough = [
  "auf die erste Tiefe einstechen",
  "seitlich zwischen Start und Ende schneiden mit Schruppvorschub",
  "fallende Elemente mit eigenem Vorschub schneiden",
  "eine Richtung: abheben, neu anfahren; beide: an beiden Enden zustellen",
  "auf die nächste Tiefe schneiden",
  "wiederholen, bis die Einstichtiefe erreicht ist",
  "im Eilgang auf Abstand, dann ein Schnitt an jeder Flanke",
  "im Eilgang zum Zyklusstart",
];
const finish = [
  "im Eilgang zur ersten Flanke",
  "erste Flanke schlichten",
  "Grund schlichten; mit Eckenradius den ganzen Einstich in einem Zug",
  "im Eilgang freifahren",
  "im Eilgang zur zweiten Flanke",
  "zweite Flanke schlichten",
  "im Eilgang zum Zyklusstart",
];
const shortened =
  "Ab der zweiten Zustellung wird jeder Schnitt um 0,1 mm kürzer, oder um Q508; das entlastet das Werkzeug seitlich. Was " +
  "stehen bleibt, wird am Ende des Schruppens in einem Schnitt abgetragen.";
const tooFar =
  "Überschreitet der Versatz 80 % der wirksamen Breite (Schneidenbreite minus zweimal Schneidenradius), meldet die Steuerung " +
  "einen Fehler.";
const recalled = [
  "Parameterliste und Schritte sind aus der Erinnerung, nach dem gedruckten Gegenstück. Unsere Auslegung; an der Steuerung prüfen.",
  "Q460 gilt wie in Zyklus 852 als reserviert; statt seiner wird ein fester Abstand gehalten.",
];
const notes = [turnMode, safePosition, shortened, tooFar, edgeLength, ...recalled];

export const recessTurning = {
  840: {
    name: "Stechdrehen Kontur radial",
    summary: "Dreht die Einstiche einer programmierten Kontur in einen Zylinder oder eine Bohrung, Tal für Tal.",
    description: [
      "Trägt das Material über einer Kontur aus einem Unterprogramm (Zyklus 14 oder SEL CONTOUR) durch Stechdrehen ab: Das " +
        "Werkzeug sticht ein und dreht dann seitlich. Eine Kontur mit mehreren Tälern wird Abschnitt für Abschnitt " +
        "bearbeitet, vom Konturstart an.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startpunkt weiter außen als die Kontur: Außenbearbeitung. Näher an " +
        "der Achse: Innenbearbeitung.",
      "Liegt X des Startpunkts näher am Grund als der höchste Punkt der Kontur, fährt das Werkzeug zuerst in X dorthin.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 verschiebt die ganze Kontur in der Tiefe, da sie mehr als einen Grund haben kann; beim Schlichten wird eine steile Flanke " +
        "aus einer scharfen Ecke von oben nach unten geschnitten. Unsere Auslegung; an der Steuerung prüfen.",
    ],
  },
  841: {
    name: "Stechdrehen einfach radial",
    summary:
      "Dreht einen Einstich mit senkrechten Flanken in einen Zylinder oder eine Bohrung, vom Startpunkt bis zu einer Ecke.",
    description: [
      "Fertigt einen Einstich in einem Zylinder oder in einer Bohrung zwischen dem Startpunkt des Zyklus und der Ecke Q493, " +
        "Q494. Der Startpunkt ist die erste Ecke des Einstichs: Sein X ist die Öffnung, sein Z die erste Flanke.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startpunkt weiter außen als Q493: Außenbearbeitung. Näher an der " +
        "Achse: Innenbearbeitung.",
    ],
    rough,
    finish,
    notes,
  },
  842: {
    name: "Stechdrehen erweitert radial",
    summary: "Dreht einen Einstich in einen Zylinder oder eine Bohrung, mit geneigten Flanken, Fasen und Eckenradien.",
    description: [
      "Fertigt einen Einstich in einem Zylinder oder in einer Bohrung durch Stechdrehen: Das Werkzeug sticht auf Tiefe und " +
        "dreht dann seitlich, mit wenigen Abhebebewegungen. Die Kanten können eine Fase oder einen Radius bekommen, beide Flanken " +
        "können geneigt, die Ecken am Grund verrundet sein.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt X des Startpunkts näher am Grund als der Startdurchmesser Q491, fährt das Werkzeug zuerst in X auf Q491.",
    ],
    rough,
    finish,
    notes,
  },
  850: {
    name: "Stechdrehen Kontur axial",
    summary: "Dreht die Einstiche einer programmierten Kontur in eine Planfläche, Tal für Tal.",
    description: [
      "Trägt das Material über einer Kontur aus einem Unterprogramm (Zyklus 14 oder SEL CONTOUR) durch Stechdrehen ab: Das " +
        "Werkzeug sticht ein und dreht dann seitlich. Eine Kontur mit mehreren Tälern wird Abschnitt für Abschnitt " +
        "bearbeitet, vom Konturstart an.",
      "Schruppt achsparallel, schlichtet oder macht beides. Die Fläche wird von +Z bearbeitet; von −Z, wenn das Werkzeug nach " +
        "+Z zeigt und hinter der Kontur steht.",
      "Liegt Z des Startpunkts unter dem höchsten Punkt der Kontur, fährt das Werkzeug zuerst in Z dorthin.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 verschiebt die ganze Kontur in der Tiefe, da sie mehr als einen Grund haben kann; beim Schlichten wird eine steile Flanke " +
        "aus einer scharfen Ecke von oben nach unten geschnitten. Unsere Auslegung; an der Steuerung prüfen.",
    ],
  },
  851: {
    name: "Stechdrehen einfach axial",
    summary: "Dreht einen Einstich mit senkrechten Flanken in eine Planfläche, vom Startpunkt bis zu einer Ecke.",
    description: [
      "Fertigt einen Einstich in der Planfläche zwischen dem Startpunkt des Zyklus und der Ecke Q493, Q494. Der Startpunkt ist " +
        "die erste Ecke des Einstichs: Sein Z ist die Öffnung, sein X die erste Flanke.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startpunkt weiter außen als Q493: Bearbeitung nach innen. Näher an " +
        "der Achse: Bearbeitung nach außen.",
    ],
    rough,
    finish,
    notes,
  },
  852: {
    name: "Stechdrehen erweitert axial",
    summary: "Dreht einen Einstich in eine Planfläche, mit geneigten Flanken, Fasen und Eckenradien.",
    description: [
      "Fertigt einen Einstich in der Planfläche durch Stechdrehen: Das Werkzeug sticht auf Tiefe und dreht dann seitlich, mit " +
        "wenigen Abhebebewegungen. Die Kanten können eine Fase oder einen Radius bekommen, beide Flanken können geneigt, die Ecken am " +
        "Grund verrundet sein.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt Z des Startpunkts unter dem Konturstart Q492, fährt das Werkzeug zuerst in Z auf Q492.",
    ],
    rough,
    finish,
    notes: [
      turnMode,
      safePosition,
      shortened,
      tooFar,
      edgeLength,
      "Die Handbuchseite nennt Q460 reserviert, den Sicherheitsabstand aber in zwei Schritten; dort gilt hier ein fester Abstand.",
    ],
  },
} satisfies CycleTexts;
