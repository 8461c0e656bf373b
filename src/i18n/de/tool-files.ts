import type { ToolFileTexts } from "../tool-file-text.ts";

export const toolFiles: ToolFileTexts = {
  title: (files) => `Was ${files} bringt`,
  fresh: (n) => `${n} neu`,
  changed: (n) => `${n} geändert`,
  same: (n) => `${n} unverändert`,
  wrong: (n) => `${n} mit Fehler`,
  nothing: "Es würde sich nichts ändern.",
  more: (n) => `und ${n} weitere`,
  empty: "leer",
  outline: "Umriss",
  newOutline: "neuer Umriss",
  takeAll: (n) => `Alle übernehmen (${n})`,
  takeNew: (n) => `Nur die neuen (${n})`,
  cancel: "Abbrechen",
  keptInFile: (names) =>
    `Spalten ohne Platz hier: ${names}. Sie bleiben bei der Datei und gehen mit ihr wieder hinaus.`,
  leftOut: (names) => `Nicht verstandene Spalten: ${names}.`,
  taken: (files, fresh, changed) => `${files}: ${fresh} neu, ${changed} geändert.`,
  export: "Exportieren",
  exportLong: "Werkzeugtabelle in eine Datei exportieren",
  exportTitle: "Welche Datei?",
  again: (file) => `${file}, wie sie kam, mit den Änderungen`,
  againHint: "Nur geänderte Werkzeuge werden neu geschrieben; alle anderen Zeilen, Spalten und Zeichen bleiben.",
  againDone: (file, changed, added, removed) =>
    `${file}: ${changed} geändert, ${added} dazu, ${removed} entfernt; alles andere wie gekommen.`,
  againShipped: (n) =>
    n === 1 ? "1 mitgeliefertes Werkzeug kommt nicht hinein." : `${n} mitgelieferte Werkzeuge kommen nicht hinein.`,
  tooLong: (cells) => `Länger als die Spalte, blieb wie es war: ${cells}.`,
  notEncodable: "Ein Name hat Zeichen, die der Zeichensatz der Datei nicht kennt: als UTF-8 geschrieben.",
  turning: "TOOLTURN.TRN, Drehwerkzeuge",
  milling: "TOOL.T, Fräs- und Bohrwerkzeuge",
  sheet: "TOOLS.csv, für Tabellenprogramme",
  json: "TOOLS.json, alles",
  noHolders: "Halter haben darin keine Spalte.",
  roundsHint: "Längen mit vier, Winkel mit drei Nachkommastellen.",
  sheetHint: "Alle Spalten und Halter; Trennzeichen, wie Tabellenprogramme Ihrer Sprache sie lesen.",
  jsonHint: "Alle Spalten und Halter, nichts gerundet; auch für den Befehl verify.",
  noTools: "keine Werkzeuge",
  importLong: "Werkzeuge aus Dateien importieren: Tabellen der Steuerung, CSV oder JSON",
  notATable: (file) =>
    `${file} ist keine Werkzeugtabelle: weder JSON noch eine Tabelle mit BEGIN am Anfang noch eine Liste mit Spalte T.`,
};
