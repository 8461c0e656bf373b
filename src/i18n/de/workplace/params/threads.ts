import type { SomeParamTexts } from "../../../param-text.ts";

const printed = false;

export const threads = {
  clearanceRunIn: {
    prompt: "Sicherheitsabstand?",
    printed,
    label: "Sicherheitsabstand",
    explanation:
      "Abstand beim Abheben zwischen den Schnitten. In diesem Zyklus zugleich der Anlaufweg: So weit vor dem " +
      "Start beginnt jeder Schnitt.",
  },
  threadPosition: {
    prompt: "Gewindelage (0=außen/1=innen)?",
    printed,
    label: "Gewindelage",
    explanation:
      "Ob das Gewinde außen oder innen geschnitten wird. Der Nenndurchmesser liegt außen an der Spitze, innen am " +
      "Grund.",
    choices: { 0: "Außengewinde", 1: "Innengewinde" },
  },
  threadOrientation: {
    prompt: "Gewindeorientierung (0=längs/1=plan)?",
    printed,
    label: "Gewindeorientierung",
    explanation: "Achse, die synchron zur Spindel läuft: Die Steigung wird entlang dieser Achse gemessen.",
    choices: { 0: "längs, parallel zur Achse", 1: "plan, in einer Stirnfläche" },
  },
  threadDiameter: {
    prompt: "Gewindedurchmesser?",
    printed,
    label: "Gewinde ⌀",
    explanation: "Nenndurchmesser: beim Außengewinde an der Spitze, beim Innengewinde am Grund.",
  },
  threadStartDiameter: {
    prompt: "Durchmesser Gewindestart?",
    printed,
    label: "Start ⌀",
    explanation: "Nenndurchmesser am Gewindestart. Mit Q464 = 2 ergibt er sich aus Ende und Winkel.",
  },
  threadEndDiameter: {
    prompt: "Durchmesser Gewindeende?",
    printed,
    label: "Ende ⌀",
    explanation: "Nenndurchmesser am Gewindeende. Mit Q464 = 4 ergibt er sich aus Start und Winkel.",
  },
  threadPitch: {
    prompt: "Gewindesteigung?",
    printed,
    label: "Steigung",
    explanation:
      "Weg des Werkzeugs in einer Spindelumdrehung. Beim mehrgängigen Gewinde ist das die Steigung eines Gangs; " +
      "der Abstand von Gang zu Gang ist die Teilung: Steigung durch Anzahl der Gänge.",
  },
  threadDepth: {
    prompt: "Gewindetiefe?",
    printed,
    label: "Tiefe",
    explanation:
      "Tiefe auf den Radius. 0: aus der Steigung, wie bei metrischem ISO-Gewinde (außen 0,6134, innen 0,5413 × " +
      "Steigung).",
  },
  threadRunOut: {
    prompt: "Gewindeauslauf?",
    printed,
    label: "Auslauf",
    explanation:
      "Weg am Gewindeende, auf dem das Werkzeug von der Tiefe zur Spitze ansteigt. 0: Das Werkzeug hebt erst " +
      "nach dem Überlaufweg ab, aus voller Tiefe.",
  },
  threadRunIn: {
    prompt: "Anlaufweg?",
    printed,
    label: "Anlaufweg",
    explanation: "Weg vor dem Gewinde, auf dem die Achse auf den Vorschub beschleunigt.",
  },
  threadOverrun: {
    prompt: "Überlaufweg?",
    printed,
    label: "Überlaufweg",
    explanation:
      "Weg hinter dem Gewinde, auf dem die Achse abbremst. Ohne Auslauf wird der Überlaufweg in voller Tiefe " +
      "gefahren: Ein Freistich ist nötig.",
  },
  taperForm: {
    prompt: "Maßangabe Kegel (0-4)?",
    printed,
    label: "Kegel durch",
    explanation:
      "Werte, die die Gewindelinie festlegen. Der Winkel Q469 zählt von einer Parallelen zur Achse in Schnittrichtung.",
    choices: {
      0: "Start- und Endpunkt",
      1: "Endpunkt, Startdurchmesser, Winkel",
      2: "Endpunkt, Start-Z, Winkel",
      3: "Startpunkt, Enddurchmesser, Winkel",
      4: "Startpunkt, End-Z, Winkel",
    },
  },
  taperAngle: {
    prompt: "Kegelwinkel?",
    printed,
    label: "Kegelwinkel",
    explanation:
      "Winkel zwischen Gewindelinie und Achse, positiv, wo der Durchmesser in Schnittrichtung wächst. Ohne " +
      "Wirkung mit Q464 = 0.",
  },
  firstInfeed: {
    prompt: "Maximale Schnitttiefe?",
    printed,
    label: "Erste Zustellung",
    explanation:
      "Tiefe des ersten Schnitts auf den Radius. Bei konstantem Spanquerschnitt wird jede weitere Zustellung " +
      "kleiner, aber nie kleiner als ein Zwanzigstel der ersten.",
  },
  infeedAngle: {
    prompt: "Zustellwinkel?",
    printed,
    label: "Zustellwinkel",
    explanation:
      "Richtung der Zustellung gegen die Senkrechte auf das Gewinde: Das Werkzeug verfährt auch seitlich, vor " +
      "allem die vordere Flanke schneidet. Höchstens der halbe Spitzenwinkel der Schneidplatte.",
  },
  infeedType: {
    prompt: "Zustellart (0/1)?",
    printed,
    label: "Zustellart",
    explanation: "Wie die Tiefe auf die Schnitte verteilt wird.",
    choices: { 0: "konstanter Spanquerschnitt", 1: "konstante Eindringtiefe" },
  },
  startingAngle: {
    prompt: "Startwinkel?",
    printed,
    label: "Startwinkel",
    explanation: "Spindelwinkel, bei dem das Gewinde beginnt: Er dreht das Gewinde um die Achse.",
  },
  threadStarts: {
    prompt: "Anzahl Gewindegänge?",
    printed,
    label: "Gänge",
    explanation: "Anzahl der Gänge nebeneinander; jeder beginnt 360° geteilt durch diese Zahl nach dem vorigen.",
  },
  airCuts: {
    prompt: "Anzahl Leerschnitte?",
    printed,
    label: "Leerschnitte",
    explanation: "Schnitte auf Fertigtiefe ohne Zustellung, je Gang.",
  },
} satisfies SomeParamTexts;
