import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const recessTurning = {
  852: {
    name: "Stechdrehen axial erweitert",
    summary: "Dreht einen Einstich in eine Planfläche, mit geneigten Flanken, Fasen und Eckenradien.",
    description: [
      "Fertigt einen Einstich in der Planfläche durch Stechdrehen: Das Werkzeug sticht auf Tiefe und dreht dann seitlich, mit "
      + "wenigen Abhebewegen. Die Kanten können eine Fase oder einen Radius bekommen, beide Flanken können geneigt, die Ecken am "
      + "Grund verrundet sein.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. "
      + "Kleiner: Innenbearbeitung.",
      "Liegt Z des Startpunkts unter dem Konturstart Q492, fährt das Werkzeug zuerst in Z auf Q492.",
    ],
    rough: [
      "auf die erste Tiefe einstechen",
      "seitlich zwischen Start und Ende schneiden mit Schruppvorschub",
      "fallende Elemente mit eigenem Vorschub",
      "abheben, zurückfahren und neu anfahren (eine Richtung) oder an beiden Enden zustellen (beide Richtungen)",
      "auf die nächste Tiefe schneiden",
      "wiederholen, bis die Einstichtiefe erreicht ist",
      "im Eilgang auf Abstand, dann ein Schnitt an jeder Flanke",
      "im Eilgang zum Zyklusstart",
    ],
    finish: [
      "im Eilgang zur ersten Flanke",
      "erste Flanke schlichten",
      "Grund schlichten; mit Eckenradius den ganzen Einstich in einem Zug",
      "im Eilgang freifahren",
      "im Eilgang zur zweiten Flanke",
      "zweite Flanke schlichten",
      "im Eilgang zum Zyklusstart",
    ],
    notes: [
      turnMode,
      safePosition,
      "Ab der zweiten Zustellung wird jeder Schnitt um 0,1 mm kürzer, oder um Q508; das entlastet das Werkzeug seitlich. Der "
      + "Rest fällt am Ende des Schruppens in einem Schnitt.",
      "Überschreitet der Versatz 80 % der wirksamen Breite (Schneidenbreite minus zweimal Schneidenradius), meldet die Steuerung "
      + "einen Fehler.",
      edgeLength,
      "Die Seite nennt Q460 reserviert und führt den Sicherheits-Abstand doch in zwei Schritten; wir nehmen dort einen festen Abstand.",
    ],
  },
} satisfies CycleTexts;
