import type { DrawingImportTexts } from "../en/drawing-import.ts";

export const drawingImport = {
  title: "Kontur aus einer Zeichnung",
  choose: "Zeichnung wählen",
  chooseOther: "Andere Zeichnung",
  drop: (endings) => `Zeichnung wählen oder hier ablegen: ${endings}.`,
  reading: "Zeichnung wird gelesen …",
  cancel: "Abbrechen",
  take: "Kontur übernehmen",
  replaces: (elements) =>
    elements === 1
      ? "Ersetzt das Element der Tabelle; Rückgängig stellt es wieder her."
      : `Ersetzt die ${elements} Elemente der Tabelle; Rückgängig stellt sie wieder her.`,
  newProgram: "Programm anlegen",
  cycle: "Zyklus",
  sheet: "Zeichnung",
  sheetKeys:
    "Pfeiltasten wählen die nächste Kontur, Achse oder den nächsten Nullpunkt, wie oben eingestellt; Plus und Minus zoomen, 0 zeigt alles, Umschalt mit Pfeiltasten verschiebt.",
  picture: (elements) =>
    elements === 0
      ? "Zeichnung ohne gewählte Kontur"
      : `Zeichnung mit einer Kontur aus ${elements === 1 ? "1 Element" : `${elements} Elementen`}`,
  pick: {
    label: "Antippen in der Zeichnung wählt",
    contour: "Kontur",
    axis: "Achse",
    zero: "Z0",
    how: {
      contour: "Eine Linie der Kontur antippen: Außen- oder Innenkontur, Hälfte und Linienzug ergeben sich.",
      axis: "Eine Linie auf der Drehachse antippen oder die Achse ziehen.",
      zero: "Einen Punkt oder eine Linie bei Z0 antippen oder den Nullpunkt ziehen.",
    },
  },
  showContour: "Auf die Kontur zoomen",
  refused: {
    notStraight: "Die Drehachse ist eine waagrechte oder senkrechte Linie.",
    nothingHere: "Hier ist nichts zu wählen.",
    notOfContour: "Bei dieser Achse gehört die Linie zu keiner Kontur.",
  },
  chosen: "Gewählt",
  proposed: "vorgeschlagen",
  useProposal: "Vorschlag wiederherstellen",
  body: "Körper",
  bodyOf: (number: number, name: string, across: string, length: string) =>
    `${number}: ${name} ⌀ ${across} × ${length} mm`.replace("  ", " "),
  unit: "Einheit der Zeichnung",
  units: { mm: "Millimeter", inch: "Zoll" },
  source: {
    file: "in der Datei angegeben",
    measurement: "aus dem Maßsystem der Datei",
    assumed: "angenommen: Die Datei nennt keine Einheit",
    chosen: "gewählt",
  },
  size: (width, height, unit) => `Zeichnung ${width} × ${height} ${unit}`,
  partSize: (across, length) => `⌀ ${across} × ${length} mm`,
  axis: "Drehachse",
  level: "Waagrecht",
  upright: "Senkrecht",
  axisAt: { x: "bei y", y: "bei x" },
  zero: "Werkstück-Nullpunkt Z0",
  zeroAt: { x: "bei x", y: "bei y" },
  atEnd: { x: { low: "Linkes Ende", high: "Rechtes Ende" }, y: { low: "Unteres Ende", high: "Oberes Ende" } },
  zWay: "Z+ zeigt",
  zWays: { x: { forward: "nach rechts", back: "nach links" }, y: { forward: "nach oben", back: "nach unten" } },
  half: "Hälfte",
  halves: {
    x: { upper: "Obere Hälfte", lower: "Untere Hälfte" },
    y: { upper: "Rechte Hälfte", lower: "Linke Hälfte" },
  },
  side: "Kontur",
  sides: { outside: "Außenkontur", bore: "Innenkontur" },
  piece: "Linienzug",
  pieceOf: (number, all, length) => `${number} von ${all}, Länge ${length} mm`,
  diameters: "X als Durchmesser gezeichnet",
  thin: "Auch verdeckte und schmale Linien",
  layers: "Layer",
  reversed: "Richtung umkehren",
  gap: "Lückentoleranz (mm)",
  more: "Weitere Optionen",
  result: "Kontur in der Tabelle",
  resultHow: "Pfeiltasten zeigen jedes Element in der Zeichnung.",
  moreRows: (count) => `${count} weitere Elemente`,
  noContour: "Mit dieser Auswahl ergibt sich keine Kontur.",
  notes: "Hinweise zur Zeichnung",
  leftOut: (count) =>
    count === 1
      ? "1 Hinweis zu ausgelassenen oder umgewandelten Linien"
      : `${count} Hinweise zu ausgelassenen oder umgewandelten Linien`,
  closeGap: "Lücke schließen",
  closeGapOf: (note) => `Lücke von Hinweis ${note} schließen`,
  moreNotes: (count) => (count === 1 ? "1 weiterer Hinweis" : `${count} weitere Hinweise`),
} satisfies DrawingImportTexts;
