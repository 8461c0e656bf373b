import type { FilesTexts } from "../en/files.ts";

export const files: FilesTexts = {
  changed: {
    title: (file) => `${file} hat sich auf dem Gerät geändert`,
    text: "Die Datei enthält etwas anderes, als hier gelesen oder gespeichert wurde. Es wurde nichts geschrieben.",
  },
  gone: {
    title: (file) => `${file} ist nicht mehr da`,
    text: "Die Datei wurde verschoben, umbenannt oder gelöscht. Es wurde nichts geschrieben.",
  },
  refused: {
    title: (file) => `${file} darf nicht geschrieben werden`,
    text: "Der Browser hat das Recht dazu nicht bekommen.",
  },
  failed: {
    title: (file) => `${file} ließ sich nicht schreiben`,
    text: "Das Gerät hat die Datei nicht angenommen. Das Programm ist noch hier.",
  },
  compare: "Damit vergleichen",
  overwrite: "Überschreiben",
  elsewhere: "Als andere Datei speichern",
  download: "Herunterladen",
  cancel: "Abbrechen",
  choose: {
    title: "Welches Programm?",
    lead: (programs) =>
      `${programs} Programme, die kein anderes ruft. Jedes wird eine eigene Arbeit, mit den Dateien, die es ruft.`,
    open: (file) => `${file} öffnen`,
    with: (count) => (count === 1 ? "mit 1 Datei" : `mit ${count} Dateien`),
    alone: "ruft nichts",
    all: (count) => `Alle ${count} öffnen`,
    together: "Alle als eine Arbeit öffnen",
    skipped: (count) =>
      count === 1
        ? "1 Datei ist kein Programmtext und blieb weg."
        : `${count} Dateien sind keine Programmtexte und blieben weg.`,
    cut: "Der Ordner enthält mehr, als auf einmal geöffnet wird. Der Rest blieb weg.",
  },
};
