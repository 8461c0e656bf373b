import type { ToolFileTexts } from "../tool-file-text.ts";

export const toolFiles: ToolFileTexts = {
  title: (files) => `Import aus ${files}`,
  fresh: (n) => `${n} neu`,
  changed: (n) => `${n} geändert`,
  same: (n) => `${n} unverändert`,
  wrong: (n) => `${n} mit Fehler`,
  nothing: "Keine Änderungen.",
  more: (n) => `und ${n} weitere`,
  empty: "leer",
  outline: "Umriss",
  newOutline: "neuer Umriss",
  takeAll: (n) => `Alle importieren (${n})`,
  takeNew: (n) => `Nur die neuen (${n})`,
  changeColumns: "Spalten ändern",
  cancel: "Abbrechen",
  keptInFile: (names) =>
    `Hier nicht gezeigte Spalten: ${names}. Sie bleiben bei der Datei und werden wieder exportiert.`,
  leftOut: (names) => `Unbekannte Spalten: ${names}.`,
  taken: (files, fresh, changed) => `${files}: ${fresh} neu, ${changed} geändert.`,
  export: "Exportieren",
  exportLong: "Werkzeugtabelle in eine Datei exportieren",
  exportTitle: "Welche Datei?",
  again: (file) => `${file} wie importiert, mit den Änderungen`,
  againHint:
    "Nur geänderte Werkzeuge werden neu geschrieben; alle anderen Zeilen, Spalten und Zeichen bleiben erhalten.",
  againDone: (file, changed, added, removed) =>
    `${file}: ${changed} geändert, ${added} hinzugefügt, ${removed} entfernt; alles andere unverändert.`,
  againShipped: (n) =>
    n === 1
      ? "1 Standardwerkzeug wird nicht in die Datei geschrieben."
      : `${n} Standardwerkzeuge werden nicht in die Datei geschrieben.`,
  tooLong: (cells) => `Länger als die Spalte, unverändert gelassen: ${cells}.`,
  notEncodable: "Dem Zeichensatz der Datei fehlen Zeichen eines Namens: als UTF-8 gespeichert.",
  turning: "TOOLTURN.TRN, Drehwerkzeuge",
  milling: "TOOL.T, Fräs- und Bohrwerkzeuge",
  sheet: "TOOLS.csv, für Tabellenprogramme",
  json: "TOOLS.json, alles",
  noHolders: "Halter und Einsatzgrenzen sind nicht enthalten.",
  roundsHint: "Längen mit vier, Winkel mit drei Nachkommastellen.",
  sheetHint: "Alle Spalten und Halter; Trennzeichen für Tabellenprogramme in Ihrer Sprache.",
  jsonHint: "Alle Spalten und Halter, nichts gerundet; auch für den Befehl verify.",
  noTools: "keine Werkzeuge",
  importLong: "Werkzeuge aus Dateien importieren: Werkzeugtabellen, Listen und Bibliotheken",
  notATable: (file) =>
    `${file} enthält keine Werkzeuge in bekannter Form: Tabelle der Steuerung, JSON, Liste mit Spalte T, LinuxCNC, Fusion, HSMWorks, FreeCAD, DIN 4000 oder ISO 13399.`,
};
