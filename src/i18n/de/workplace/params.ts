import type { ParamsTexts } from "../../param-text.ts";
import { turning } from "./params/turning.ts";
import { recessing } from "./params/recessing.ts";
import { threads } from "./params/threads.ts";
import { special } from "./params/special.ts";

const printed = false;
const element = { 0: "kein Element", 1: "Fase", 2: "Radius" };

export const params = {
  operation: {
    prompt: "Bearbeitungs-Umfang (0/1/2/3)?",
    printed,
    label: "Bearbeitungs-Umfang",
    explanation: "Bearbeitungsumfang des Zyklus: Schruppen, Schlichten oder beides.",
    choices: {
      0: "Schruppen und Schlichten",
      1: "nur Schruppen",
      2: "nur Schlichten auf Fertigmaß",
      3: "nur Schlichten auf Aufmaß",
    },
  },
  clearance: {
    prompt: "Sicherheitsabstand?",
    printed,
    label: "Sicherheitsabstand",
    explanation: "Abstand zum Material beim Vorpositionieren und beim Rückzug.",
  },
  clearanceReserved: {
    prompt: "Sicherheitsabstand?",
    printed,
    label: "Sicherheitsabstand (reserviert)",
    explanation: "Reserviert: In diesem Zyklus hat der Wert keine Funktion. Abheben mit festem Abstand.",
  },
  startDiameter: {
    prompt: "Durchmesser Konturstart?",
    printed,
    label: "Start ⌀",
    explanation:
      "X des Konturstarts als Durchmesser. Größer als Q493: Außenbearbeitung. Kleiner als Q493: Innenbearbeitung.",
  },
  startZ: {
    prompt: "Konturstart Z?",
    printed,
    label: "Start Z",
    explanation: "Z des Konturstarts.",
  },
  endDiameter: {
    prompt: "Durchmesser Konturende?",
    printed,
    label: "Ende ⌀",
    explanation:
      "X des Konturendes als Durchmesser. Zusammen mit dem Startdurchmesser entscheidet er zwischen Außen- und " +
      "Innenbearbeitung.",
  },
  endZ: {
    prompt: "Konturende Z?",
    printed,
    label: "Ende Z",
    explanation: "Z des Konturendes.",
  },
  surfaceAngle: {
    prompt: "Winkel Umfangsfläche?",
    printed,
    label: "Winkel Umfangsfläche",
    explanation:
      "Winkel zwischen Umfangsfläche und Drehachse; 0 ist ein Zylinder. Die Fläche neigt sich in den " +
      "Zerspanbereich hinein, nie " +
      "darunter.",
  },
  flankAngle: {
    prompt: "Winkel Flanke?",
    printed,
    label: "Flankenwinkel",
    explanation:
      "Winkel zwischen der Flanke am Konturstart und der Parallelen zur Drehachse. Der Einstich wird zum Grund " +
      "hin schmaler.",
  },
  faceAngle: {
    prompt: "Winkel Planfläche?",
    printed,
    label: "Winkel Planfläche",
    explanation:
      "Neigung der Planfläche; 0 steht rechtwinklig zur Drehachse. Die Fläche neigt sich in den Zerspanbereich hinein.",
  },
  secondFlankAngle: {
    prompt: "Winkel zweite Flanke?",
    printed,
    label: "Winkel zweite Flanke",
    explanation: "Winkel zwischen der Flanke am Konturende und der Parallelen zur Drehachse.",
  },
  startElement: {
    prompt: "Typ Startelement (0/1/2)?",
    printed,
    label: "Startelement",
    explanation: "Element an der Kante am Konturstart.",
    choices: element,
  },
  startElementSize: {
    prompt: "Größe Startelement?",
    printed,
    label: "Größe Startelement",
    explanation: "Schenkellänge der Fase oder Radius am Konturstart. Ohne Element (Q501 = 0) ohne Wirkung.",
  },
  cornerRadius: {
    prompt: "Radius Konturecke?",
    printed,
    label: "Eckenradius",
    explanation:
      "Radius in der Innenecke. 0 oder keine Eingabe: scharfe Ecke, in der der Schneidenradius des Werkzeugs bleibt.",
  },
  endElement: {
    prompt: "Typ Endelement (0/1/2)?",
    printed,
    label: "Endelement",
    explanation: "Element an der Kante am Konturende.",
    choices: element,
  },
  endElementSize: {
    prompt: "Größe Endelement?",
    printed,
    label: "Größe Endelement",
    explanation: "Schenkellänge der Fase oder Radius am Konturende. Ohne Element (Q503 = 0) ohne Wirkung.",
  },
  infeedRadial: {
    prompt: "Maximale Schnitttiefe?",
    printed,
    label: "Max. Zustellung",
    explanation:
      "Größte Zustellung je Schnitt, auf den Radius. Die Tiefe wird gleichmäßig aufgeteilt; die tatsächliche " +
      "Zustellung ist oft kleiner, Schleifschnitte entfallen.",
  },
  infeedAxial: {
    prompt: "Maximale Schnitttiefe?",
    printed,
    label: "Max. Zustellung",
    explanation:
      "Größte Zustellung je Schnitt, in Z. Die Tiefe wird gleichmäßig aufgeteilt; die tatsächliche Zustellung " +
      "ist oft kleiner, Schleifschnitte entfallen. 0: ein Schnitt.",
  },
  infeedGroove: {
    prompt: "Maximale Schnitttiefe?",
    printed,
    label: "Max. Zustellung",
    explanation:
      "Größte Zustellung je Schnitt, in Z, gleichmäßig aufgeteilt. Das Handbuch nennt die Zustellung radial, ein " +
      "axialer Einstich hat seine Zustellung aber in Z; nicht geprüft.",
  },
  roughingFeed: {
    prompt: "Vorschub Schruppen?",
    printed,
    label: "Vorschub Schruppen",
    explanation:
      "Vorschub der Schruppschnitte: mit M136 in mm pro Umdrehung, sonst in mm pro Minute. FAUTO übernimmt den " +
      "Vorschub aus dem Werkzeugaufruf.",
  },
  oversizeDiameter: {
    prompt: "Aufmaß Durchmesser?",
    printed,
    label: "Aufmaß ⌀",
    explanation: "Schlichtaufmaß auf den Durchmesser; je Seite bleibt die Hälfte.",
  },
  oversizeZ: {
    prompt: "Aufmaß Z?",
    printed,
    label: "Aufmaß Z",
    explanation: "Schlichtaufmaß auf Planflächen, in Z.",
  },
  finishingFeed: {
    prompt: "Vorschub Schlichten?",
    printed,
    label: "Vorschub Schlichten",
    explanation:
      "Vorschub des Schlichtschnitts: mit M136 in mm pro Umdrehung, sonst in mm pro Minute. FAUTO übernimmt den " +
      "Vorschub aus dem Werkzeugaufruf.",
  },
  smoothing: {
    prompt: "Konturglättung (0/1/2)?",
    printed,
    label: "Konturglättung",
    explanation: "Wie die Stufen zwischen den Schnitten abgetragen werden und wie das Werkzeug abhebt.",
    choices: {
      0: "nach jedem Schnitt entlang der Kontur, innerhalb der Zustellung",
      1: "einmal nach dem letzten Schnitt entlang der ganzen Kontur; hebt unter 45° ab",
      2: "keine Glättung; hebt unter 45° ab",
    },
  },
  reverseContour: {
    prompt: "Kontur umkehren (0-2)?",
    printed,
    label: "Kontur umkehren",
    explanation: "Richtung, in der die Kontur bearbeitet wird.",
    choices: {
      0: "wie programmiert",
      1: "gegen die programmierte Richtung",
      2:
        "gegen die programmierte Richtung, Schneide in Vorschubrichtung gespiegelt (Werkzeugorientierung 1 " +
        "schneidet als 7)",
    },
  },
  plunging: {
    prompt: "Eintauchen erlauben (0/1)?",
    printed,
    label: "Eintauchen",
    explanation: "Ob eintauchende Konturelemente bearbeitet werden.",
    choices: { 0: "eintauchende Elemente nicht bearbeiten", 1: "eintauchende Elemente bearbeiten" },
  },
  plungingFeed: {
    prompt: "Vorschub Eintauchen (0=auto)?",
    printed,
    label: "Vorschub Eintauchen",
    explanation: "Vorschub auf eintauchenden Konturelementen. 0 oder keine Eingabe: Vorschub der Drehbearbeitung.",
  },
  limits: {
    prompt: "Schnittbegrenzung (0/1)?",
    printed,
    label: "Schnittbegrenzung",
    explanation:
      "Begrenzt die bearbeitete Kontur auf eine Seite von Q480 und Q482: die Seite, auf der das Werkzeug beim " +
      "Aufruf steht. An- " +
      "und Abfahrwege dürfen die Grenzen überschreiten.",
    choices: { 0: "keine Begrenzung", 1: "Begrenzung bei Q480 und Q482" },
  },
  limitDiameter: {
    prompt: "Grenzwert Durchmesser?",
    printed,
    label: "Grenze ⌀",
    explanation: "Grenze in X als Durchmesser. Wirkt mit Q479 = 1.",
  },
  limitZ: {
    prompt: "Grenzwert Z?",
    printed,
    label: "Grenze Z",
    explanation: "Grenze in Z. Wirkt mit Q479 = 1.",
  },
  direction: {
    prompt: "Bearbeitungsrichtung (0=bidir./1=unidir.)?",
    printed,
    label: "Bearbeitungsrichtung",
    explanation: "Ob die Schnitte zwischen beiden Richtungen wechseln.",
    choices: { 0: "beide Richtungen", 1: "eine Richtung, die der Kontur" },
  },
  offsetWidth: {
    prompt: "Versatzbreite?",
    printed,
    label: "Versatzbreite",
    explanation:
      "Verkürzt ab der zweiten Zustellung jeden Schnitt und verringert so den seitlichen Druck auf die Schneide. " +
      "0: 0,1 mm je Schnitt. Das Restmaterial an den Flanken wird am Ende des Schruppens abgetragen. Die Summe " +
      "je Seite darf 80 % der wirksamen Breite erreichen.",
  },
  depthCompensation: {
    prompt: "Tiefenkorrektur Schlichten?",
    printed,
    label: "Tiefenkorrektur",
    explanation:
      "Verschiebt den Grund beim Schlichten und gleicht so das Kippen der Schneide beim seitlichen Drehen aus: " +
      "positiv wird der Einstich flacher, negativ tiefer.",
  },
  ...turning,
  ...recessing,
  ...threads,
  ...special,
} satisfies ParamsTexts;
