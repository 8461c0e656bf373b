import type { FilesTexts } from "../en/files.ts";

export const files: FilesTexts = {
  changed: {
    title: (file) => `${file} hat sich auf dem Gerät geändert`,
    text: "Die Datei weicht vom hier geöffneten oder gespeicherten Stand ab. Es wurde nichts geschrieben.",
  },
  gone: {
    title: (file) => `${file} ist nicht mehr da`,
    text: "Die Datei wurde verschoben, umbenannt oder gelöscht. Es wurde nichts geschrieben.",
  },
  refused: {
    title: (file) => `Keine Schreibberechtigung für ${file}`,
    text: "Der Browser hat keine Berechtigung zum Schreiben der Datei.",
  },
  failed: {
    title: (file) => `${file} konnte nicht geschrieben werden`,
    text: "Das Gerät hat die Datei nicht angenommen. Das Programm ist hier noch geöffnet.",
  },
  compare: "Vergleichen",
  overwrite: "Überschreiben",
  elsewhere: "Als andere Datei speichern",
  download: "Herunterladen",
  cancel: "Abbrechen",
  choose: {
    title: "Welches Programm?",
    lead: (programs) =>
      `${programs} Programme werden von keinem anderen aufgerufen. Jedes wird ein eigenes Programm, mit den Dateien, die es aufruft.`,
    open: (file) => `${file} öffnen`,
    with: (count) => (count === 1 ? "mit 1 Datei" : `mit ${count} Dateien`),
    alone: "ruft keine Datei auf",
    all: (count) => `Alle ${count} öffnen`,
    together: "Alle als ein Programm öffnen",
    skipped: (count) =>
      count === 1
        ? "1 Datei ist kein Programmtext und wurde ausgelassen."
        : `${count} Dateien sind keine Programmtexte und wurden ausgelassen.`,
    cut: "Der Ordner enthält mehr Dateien, als auf einmal geöffnet werden. Der Rest wurde ausgelassen.",
  },
};
