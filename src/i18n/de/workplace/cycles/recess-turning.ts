import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

const rough = [
  "auf die erste Tiefe einstechen",
  "seitlicher Schnitt zwischen Start und Ende mit Vorschub Schruppen",
  "eintauchende Elemente mit Vorschub Eintauchen",
  "unidirektional: abheben, zurück, neu anfahren; bidirektional: Zustellung an beiden Enden",
  "auf die nächste Tiefe schneiden",
  "wiederholen, bis die Einstichtiefe erreicht ist",
  "im Eilgang auf Sicherheitsabstand, dann ein Schnitt an jeder Flanke",
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
  "Ab der zweiten Zustellung wird jeder Schnitt um 0,1 mm kürzer, oder um Q508; das verringert den seitlichen " +
  "Druck auf das Werkzeug. Das Restmaterial wird am Ende des Schruppens in einem Schnitt abgetragen.";
const tooFar =
  "Überschreitet der Versatz 80 % der wirksamen Breite (Schneidenbreite minus zweimal Schneidenradius), meldet " +
  "die Steuerung " +
  "einen Fehler.";
const unverified = [
  "Parameterliste und Schritte folgen dem verwandten gedruckten Zyklus und sind nicht am Handbuch geprüft; an " +
    "der Steuerung prüfen.",
  "Q460 gilt wie in Zyklus 852 als reserviert; verwendet wird ein fester Abstand.",
];
const notes = [turnMode, safePosition, shortened, tooFar, edgeLength, ...unverified];

export const recessTurning = {
  840: {
    name: "Stechdrehen Kontur radial",
    summary:
      "Dreht die Einstiche einer programmierten Kontur in einen Zylinder oder eine Bohrung, ein Konturtal nach dem " +
      "anderen.",
    description: [
      "Trägt das Material über einer Kontur aus einem Unterprogramm (Zyklus 14 oder SEL CONTOUR) durch " +
        "Stechdrehen ab: Das " +
        "Werkzeug sticht ein und dreht dann seitlich. Eine Kontur mit mehreren Konturtälern wird Abschnitt für " +
        "Abschnitt " +
        "bearbeitet, vom Konturstart an.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startpunkt weiter außen als die Kontur: " +
        "Außenbearbeitung. Näher an " +
        "der Achse: Innenbearbeitung.",
      "Liegt X des Startpunkts näher am Grund als der höchste Punkt der Kontur, fährt das Werkzeug zuerst in X " +
        "dorthin.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 verschiebt die ganze Kontur in der Tiefe, da ihr Grund nicht überall gleich tief ist; beim " +
        "Schlichten wird eine steile Flanke an einer scharfen Ecke von oben nach unten bearbeitet.",
    ],
  },
  841: {
    name: "Stechdrehen einfach radial",
    summary:
      "Dreht einen Einstich mit senkrechten Flanken in einen Zylinder oder eine Bohrung, vom Startpunkt bis zu " +
      "einer Ecke.",
    description: [
      "Fertigt einen Einstich in einem Zylinder oder in einer Bohrung zwischen dem Startpunkt des Zyklus und der " +
        "Ecke Q493, " +
        "Q494. Der Startpunkt ist die erste Ecke des Einstichs: Sein X ist die Öffnung, sein Z die erste Flanke.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startpunkt weiter außen als Q493: " +
        "Außenbearbeitung. Näher an der " +
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
      "Fertigt einen Einstich in einem Zylinder oder in einer Bohrung durch Stechdrehen: Das Werkzeug sticht auf " +
        "Tiefe und " +
        "dreht dann seitlich, mit wenigen Abhebebewegungen. Die Kanten können eine Fase oder einen Radius haben, " +
        "beide Flanken " +
        "können geneigt, die Ecken am Grund verrundet sein.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. " +
        "Kleiner: Innenbearbeitung.",
      "Liegt X des Startpunkts näher am Grund als der Startdurchmesser Q491, fährt das Werkzeug zuerst in X auf Q491.",
    ],
    rough,
    finish,
    notes,
  },
  850: {
    name: "Stechdrehen Kontur axial",
    summary: "Dreht die Einstiche einer programmierten Kontur in eine Planfläche, ein Konturtal nach dem anderen.",
    description: [
      "Trägt das Material über einer Kontur aus einem Unterprogramm (Zyklus 14 oder SEL CONTOUR) durch " +
        "Stechdrehen ab: Das " +
        "Werkzeug sticht ein und dreht dann seitlich. Eine Kontur mit mehreren Konturtälern wird Abschnitt für " +
        "Abschnitt " +
        "bearbeitet, vom Konturstart an.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Die Planfläche wird von +Z bearbeitet; von " +
        "−Z, wenn das Werkzeug nach +Z zeigt und hinter der Kontur steht.",
      "Liegt Z des Startpunkts unter dem höchsten Punkt der Kontur, fährt das Werkzeug zuerst in Z dorthin.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 verschiebt die ganze Kontur in der Tiefe, da ihr Grund nicht überall gleich tief ist; beim " +
        "Schlichten wird eine steile Flanke an einer scharfen Ecke von oben nach unten bearbeitet.",
    ],
  },
  851: {
    name: "Stechdrehen einfach axial",
    summary: "Dreht einen Einstich mit senkrechten Flanken in eine Planfläche, vom Startpunkt bis zu einer Ecke.",
    description: [
      "Fertigt einen Einstich in der Planfläche zwischen dem Startpunkt des Zyklus und der Ecke Q493, Q494. Der " +
        "Startpunkt ist " +
        "die erste Ecke des Einstichs: Sein Z ist die Öffnung, sein X die erste Flanke.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startpunkt weiter außen als Q493: " +
        "Bearbeitung nach innen. Näher an " +
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
      "Fertigt einen Einstich in der Planfläche durch Stechdrehen: Das Werkzeug sticht auf Tiefe und dreht dann " +
        "seitlich, mit wenigen Abhebebewegungen. Die Kanten können eine Fase oder einen Radius haben, beide " +
        "Flanken können geneigt, die Ecken am " +
        "Grund verrundet sein.",
      "Schruppen achsparallel, Schlichten oder Komplettbearbeitung. Startdurchmesser größer als Enddurchmesser: " +
        "Außenbearbeitung. " +
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
      "Das Handbuch nennt Q460 reserviert, den Sicherheitsabstand aber in zwei Schritten; dort gilt hier ein " +
        "fester Abstand.",
      "Nicht gedruckt, daher nicht geprüft: die Richtung von Q495 und Q496, das Vorzeichen von Q509 und dass " +
        "Q508 je Seite summiert wird.",
    ],
  },
} satisfies CycleTexts;
