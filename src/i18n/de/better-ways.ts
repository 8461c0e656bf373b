import type { BetterWaysTexts } from "../en/better-ways.ts";

export const betterWays: BetterWaysTexts = {
  title: "Verbesserungen",
  about: "Jeder Vorschlag ist simuliert: gleiches Teil, keine rauere Oberfläche, keine zusätzlichen Meldungen.",
  list: "Vorschläge",
  preparing: "Änderungen werden gesucht …",
  trying: (tried, of) => `${tried} von ${of} Änderungen simuliert`,
  found: (n, of) =>
    n === 1 ? `1 Verbesserung; ${of} Änderungen simuliert.` : `${n} Verbesserungen; ${of} Änderungen simuliert.`,
  none: (of) => `Keine Verbesserung gefunden; ${of} Änderungen simuliert.`,
  nothing: "In diesem Programm gibt es keine Änderung zu versuchen.",
  stopped: (tried, of) => `Angehalten: ${tried} von ${of} Änderungen simuliert.`,
  failed: "Das Programm ließ sich nicht berechnen.",
  stop: "Anhalten",
  again: "Erneut suchen",
  use: "Übernehmen",
  useLong: (what) => `Übernehmen: ${what}`,
  used: (what) => `Übernommen: ${what}.`,
  undo: "Rückgängig",
  updating: "Das geänderte Programm wird neu geprüft …",
  noTime: "Die Maschinendaten nennen keine Werkzeugwechselzeit: Ein Wechsel zählt 0 s.",
  faulty: "Das Programm hat Fehler: Vorgeschlagen wird nur, was das Prüfergebnis verbessert.",
  noMaterial: "Das Programm nennt keinen Werkstoff: keine Vorschläge zu Schnittdaten.",
  and: (first, last) => `${first} und ${last}`,
  operation: (n, title) => (title === "" ? `Bearbeitung ${n}` : `Bearbeitung ${n} „${title}“`),
  operations: (numbers) => `Bearbeitungen ${numbers}`,
  gains: {
    verdict: "Besseres Prüfergebnis",
    residualGone: (tool) => (tool === "" ? "Kein Restmaterial" : `Kein Restmaterial mit Werkzeug ${tool}`),
    bendsLess: (length) => `Werkstück biegt sich ${length} weniger durch`,
    residualLess: (area) => `${area} weniger Restmaterial`,
    toolGone: (tool) => `Werkzeug ${tool} entfällt`,
    toolsLess: (n) => (n === 1 ? "1 Werkzeug weniger" : `${n} Werkzeuge weniger`),
    changesLess: (n) => (n === 1 ? "1 Werkzeugwechsel weniger" : `${n} Werkzeugwechsel weniger`),
    shorter: (time) => `${time} kürzer`,
  },
  measures: {
    seconds: "Zeit",
    tools: "Werkzeuge",
    changes: "Werkzeugwechsel",
    residual: "Restmaterial",
    bending: "Durchbiegung",
  },
  kinds: {
    noCut: (operation) => `${operation} zerspant nichts und wird gelöscht.`,
    fewerTools: (operations, tool) => `${operations} mit Werkzeug ${tool}, das im Programm ohnehin vorkommt.`,
    severalTools: (operations, tools) =>
      `${operations} mit den Werkzeugen ${tools}, die im Programm ohnehin vorkommen.`,
    fewerChanges: (operation, next) => `${operation} wird neben ${next} verschoben: Beide haben dasselbe Werkzeug.`,
    restOperation: (operation, tool) =>
      `${operation}, danach eine weitere Bearbeitung mit Werkzeug ${tool} für das Restmaterial.`,
    otherTool: (operation, tool, instead) => `${operation} mit Werkzeug ${tool} statt ${instead}.`,
    otherCycle: (operation, cycle) => `${operation} mit Zyklus ${cycle}.`,
    otherCycleAndTool: (operation, cycle, tool) => `${operation} mit Zyklus ${cycle} und Werkzeug ${tool}.`,
    otherChoice: (operation, value) => `${operation}: ${value}.`,
    infeed: (operation, value, tool, most) =>
      `${operation}: ${value}. Vorsichtige Grenze für Werkzeug ${tool} aus Schneidenlänge, Spindelleistung und Steifigkeit: ${most}.`,
    stiffness: (operation, value, most) =>
      `${operation}: ${value}. Das Werkstück ist schlank; seine Durchbiegung erlaubt höchstens ${most}.`,
    start: (operation, axis, from, to) =>
      `${operation} schneidet zuerst in der Luft: Startpunkt ${axis} ${to} statt ${from}.`,
    oneCall: (operations) => `${operations} in einem Aufruf, Schruppen und Schlichten.`,
    cuttingSpeed: (operations, from, to, material) =>
      `${operations}: Schnittgeschwindigkeit ${from} → ${to} m/min, aus den Schnittdaten für ${material}.`,
    feed: (operation, value, material) =>
      `${operation}: ${value}, aus den Schnittdaten für ${material} und dem Schneidenradius.`,
  },
};
