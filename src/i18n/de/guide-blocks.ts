import type { GuideBlocksTexts } from "../en/guide-blocks.ts";
import { blockKinds } from "./guide-blocks/kinds.ts";
import { blockWords } from "./guide-blocks/words.ts";

export const guideBlocks: GuideBlocksTexts = {
  title: "Programmsätze",
  lead: "Funktion jedes Satzes, und eine Seite für jedes Wort.",
  words: "Wörter",
  toBlock: "Satz",
  inProgram: "Im Programm",
  rule: "An der Steuerung",
  recalled: "Nicht am Handbuch geprüft; an der Steuerung prüfen.",
  sampleLead: "Ein kleines Programm, simuliert mit jedem dieser Werte.",
  ownLead: "Ihr Programm, simuliert mit jedem dieser Werte; Ihr Programm ändert sich nicht.",
  why: {
    name:
      "Keine Animation: Ein Name hat keine Wirkung auf die Bahn. Er muss mit dem Namen an anderer Stelle " +
      "übereinstimmen.",
    axis: "Keine Animation: Die Simulation zeigt die Ebene Z/X, diese Achse liegt nicht darin.",
    milling: "Keine Animation: Das gilt für das Fräsen; gezeigt wird nur das Drehen.",
    free: "Keine Animation: Eine freie Kontur bleibt erhalten, wird aber nicht simuliert.",
    choice: "Keine Animation: Eine andere Auswahl verlangt andere Sätze und hat mit diesen keine Wirkung.",
    together: "Keine Animation: Dieser Wert hängt von anderen ab. Allein geändert lehnt die Steuerung den Satz ab.",
    compensation: "Hier keine Animation: Die Korrektur beginnt und endet mit einem Geradensatz. Siehe Seite von L.",
    functions:
      "Hier keine Animation: Von den M-Funktionen ändern nur M136 und M137 den Schnitt. Siehe Seite der M-Funktionen.",
    same: "Keine Animation: Andere Werte ergeben dieselbe Bahn und dasselbe Teil.",
    yours:
      "Ihr Satz wird nicht gezeigt: Andere Werte ergeben denselben Schnitt oder einen Schnitt, der nicht " +
      "simuliert wird, wie beim Fräsen.",
  },
  functions: "M-Funktionen",
  kinds: blockKinds,
  of: blockWords,
  rules: {
    "blankCylinder.outside": "D ist der ⌀, R der Radius. Er muss größer als die Bohrung sein.",
    "blankCylinder.length": "L zählt von der Planfläche in Richtung Futter.",
    "blankCylinder.distance": "DIST kann entfallen: Die Planfläche liegt dann auf Z0.",
    "blankCylinder.inside": "DI kann bei Vollmaterial entfallen.",
    "toolCall.tool":
      "Eine Nummer, ein Name in Anführungszeichen oder ein QS-Parameter; 5.1 ist ein Index von Werkzeug 5.",
    "spin.cuttingSpeed": "VC gilt, solange VCONST aktiv ist.",
    "spin.speed": "S gilt, solange VCONST nicht aktiv ist.",
    "spin.speedLimit": "SMAX gilt, bis ein anderer SPIN-Satz den Wert ändert.",
    feed: "Der Vorschub wirkt modal; ein Satz ohne F behält ihn.",
    X: "I vor der Achse: Wert inkremental.",
    compensation: "Die Korrektur beginnt und endet mit einer Geraden. CC, RND und CHF behalten sie.",
    label: "LBL 0 beliebig oft; jedes andere Label nur einmal.",
    repeat: "Bis 65534.",
    target: "Q0 bis Q99 sind für den Bediener frei.",
    functions: "Max. vier; M-Funktionen einer Gruppe ersetzen einander.",
    polarAngle: "Zwischen −360° und +360°.",
    toolAxis: "Bestimmt die Ebene: mit Z beim Fräsen X/Y, beim Drehen Z/X.",
  },
  m: {
    M0: "Programmlauf-Halt; weiter mit NC-Start.",
    M1: "Wahlweiser Halt, falls vom Bediener aktiviert.",
    M3: "Spindel ein, im Uhrzeigersinn.",
    M4: "Spindel ein, gegen den Uhrzeigersinn.",
    M5: "Spindel aus.",
    M8: "Kühlmittel ein.",
    M9: "Kühlmittel aus.",
    M13: "Spindel im Uhrzeigersinn und Kühlmittel ein.",
    M14: "Spindel gegen den Uhrzeigersinn und Kühlmittel ein.",
    M30: "Programmende, zurück an den Anfang.",
    M89: "Modaler Zyklusaufruf nach jedem Positioniersatz.",
    M91: "Koordinaten im Satz beziehen sich auf den Maschinen-Nullpunkt. Seine Lage ist hier nicht bekannt.",
    M92: "Koordinaten im Satz beziehen sich auf eine vom Maschinenhersteller definierte Position.",
    M99: "Zyklusaufruf nach diesem Satz.",
    M136: "Vorschub in mm pro Umdrehung.",
    M137: "Vorschub wieder in mm pro Minute.",
    M140: "Rückzug in der Werkzeugachse um MB.",
    M303: "Drehspindel ein; den Drehsinn legt der Maschinenhersteller fest.",
    M304: "Drehspindel ein, Gegenrichtung.",
  },
};
