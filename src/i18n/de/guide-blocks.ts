import type { GuideBlocksTexts } from "../en/guide-blocks.ts";
import { blockKinds } from "./guide-blocks/kinds.ts";
import { blockWords } from "./guide-blocks/words.ts";

export const guideBlocks: GuideBlocksTexts = {
  title: "Blöcke eines Programms",
  lead: "Was jeder Satz tut, und eine Seite für jedes seiner Wörter.",
  words: "Seine Wörter",
  toBlock: "Der Satz",
  inProgram: "Im Programm",
  rule: "An der Steuerung",
  recalled: "Aus der Erinnerung, nicht an einer gedruckten Seite geprüft: an der Steuerung nachsehen.",
  sampleLead: "Der Kern hat ein kleines Programm mit jedem davon laufen lassen.",
  ownLead: "Der Kern hat Ihr Programm mit jedem davon laufen lassen; Ihre Arbeit bleibt, wie sie ist.",
  why: {
    name: "Es gibt kein bewegtes Bild: Ein Name bewegt nichts. Er muss nur der sein, der anderswo gemeint ist.",
    axis: "Es gibt kein bewegtes Bild: Der Kern schneidet in der Ebene Z/X, und diese Achse liegt nicht darin.",
    milling: "Es gibt kein bewegtes Bild: Das zählt beim Fräsen, und der Kern zeigt, was das Drehen schneidet.",
    free: "Es gibt kein bewegtes Bild: Eine freie Kontur wird hier aufbewahrt und nicht ausgeführt.",
    choice:
      "Es gibt kein bewegtes Bild: Eine andere Wahl braucht andere Sätze um sich, und mit denselben zeigt sie nichts.",
    together:
      "Es gibt kein bewegtes Bild: Dieser Wert gehört mit anderen zusammen. Allein geändert nähme ihn die Steuerung nicht an.",
    compensation:
      "Hier gibt es kein bewegtes Bild: Die Korrektur beginnt und endet mit einem Geradensatz. Die Seite von L zeigt sie.",
    functions:
      "Hier gibt es kein bewegtes Bild: Von den M-Funktionen ändern M136 und M137 den Schnitt. Die Seite der M-Funktionen" +
      " zeigt es.",
    same: "Es gibt kein bewegtes Bild: Mit anderen Werten fährt das Werkzeug denselben Weg und lässt dasselbe Teil.",
    yours:
      "Ihr eigener Satz wird nicht gezeigt: Mit anderen Werten wird dort dasselbe geschnitten oder nichts, was der Kern" +
      " schneiden kann, wie in einer gefrästen Ebene.",
  },
  functions: "M-Funktionen",
  kinds: blockKinds,
  of: blockWords,
  rules: {
    "blankCylinder.outside": "D ist der ⌀, R der Radius. Er muss größer als die Bohrung sein.",
    "blankCylinder.length": "L zählt von der Planfläche zum Futter.",
    "blankCylinder.distance": "DIST kann fehlen: Die Planfläche liegt dann in Z0.",
    "blankCylinder.inside": "DI kann fehlen, wenn es Vollmaterial ist.",
    "toolCall.tool":
      "Eine Nummer, ein Name in Anführungszeichen oder ein QS-Parameter; 5.1 ist ein Index von Werkzeug 5.",
    "spin.cuttingSpeed": "VC zählt, solange VCONST an ist.",
    "spin.speed": "S zählt, solange VCONST aus ist.",
    "spin.speedLimit": "SMAX gilt, bis ein anderer SPIN-Satz eines nennt.",
    feed: "Ein Vorschub gilt bis zum nächsten; ein Satz ohne F behält ihn.",
    X: "I vor der Achse macht sie inkremental.",
    compensation: "Sie beginnt und endet mit einer Geraden. CC, RND und CHF behalten sie.",
    label: "LBL 0 darf so oft stehen wie nötig; kein anderes zweimal.",
    repeat: "Bis 65534.",
    target: "Q0 bis Q99 sind für den Bediener frei.",
    functions: "Höchstens vier; M-Funktionen einer Gruppe lösen einander ab.",
    polarAngle: "Zwischen −360° und +360°.",
    toolAxis: "Sie entscheidet die Ebene: Mit Z ist es beim Fräsen X/Y, beim Drehen Z/X.",
  },
  m: {
    M0: "Hält an; NC-Start geht weiter.",
    M1: "Hält an, wenn der Bediener das eingeschaltet hat.",
    M3: "Spindel an, im Uhrzeigersinn.",
    M4: "Spindel an, gegen den Uhrzeigersinn.",
    M5: "Spindel aus.",
    M8: "Kühlmittel an.",
    M9: "Kühlmittel aus.",
    M13: "Spindel im Uhrzeigersinn und Kühlmittel an.",
    M14: "Spindel gegen den Uhrzeigersinn und Kühlmittel an.",
    M30: "Programmende, zurück an den Anfang.",
    M89: "Ruft den Zyklus hinter jedem Positioniersatz.",
    M91: "Die Koordinaten dieses Satzes zählen vom Maschinen-Nullpunkt. Wo der liegt, weiß hier niemand.",
    M92: "Die Koordinaten dieses Satzes zählen von einem Punkt des Maschinenherstellers.",
    M99: "Ruft den Zyklus hinter diesem Satz.",
    M136: "Vorschübe zählen in mm je Umdrehung.",
    M137: "Vorschübe zählen wieder in mm je Minute.",
    M140: "In der Werkzeugachse um MB zurück.",
    M303: "Spindel des Drehteils an; den Drehsinn legt der Maschinenhersteller fest.",
    M304: "Spindel des Drehteils an, andersherum.",
  },
};
