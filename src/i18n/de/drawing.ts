import type { DrawingTexts } from "../drawing-note.ts";

const many = (count: string, one: string, more: string) => (count === "1" ? `1 ${one}` : `${count} ${more}`);
const entities = (count: string) => many(count, "Objekt", "Objekte");
const lines = (count: string) => many(count, "Linie oder Bogen", "Linien und Bögen");

/** What of a solid is not turned. */
function milled(shape: string, count: string): string {
  if (shape === "flats") return many(count, "ebene Fläche", "ebene Flächen");
  if (shape === "holes") return many(count, "Bohrung neben der Achse", "Bohrungen neben der Achse");
  return shape === "crossHoles"
    ? many(count, "Querbohrung", "Querbohrungen")
    : many(count, "andere Fläche", "andere Flächen");
}

export const drawing: DrawingTexts = {
  unknownKind: ({ kinds }) => `Keine lesbare Zeichnung. Gelesen werden: ${kinds}.`,
  unreadable: ({ kind }) => `Diese Datei ist keine lesbare ${kind}-Zeichnung.`,
  tooLarge: ({ limit }) => `Diese Datei ist größer als ${limit} MB.`,
  tooMany: ({ limit }) =>
    `Die Zeichnung hat mehr als ${limit} Linien und Bögen. Nur den Umriss des Teils speichern und importieren.`,
  nothing: () => "Die Zeichnung enthält keine Linien, Bögen oder Kurven.",
  truncated: () => "Die Datei bricht vor ihrem Ende ab; bis dahin ist sie gelesen.",
  hiddenLayer: ({ layer, count }) => `Layer ${layer} ist aus oder gefroren: ${entities(count)} ausgelassen.`,
  invisible: ({ count }) => `Unsichtbar und ausgelassen: ${entities(count)}.`,
  paperSpace: ({ count }) => `Im Layout (Papierbereich) und ausgelassen: ${entities(count)}.`,
  paperUsed: () => "Der Modellbereich ist leer: das Layout ist gelesen. Maßstab prüfen.",
  skipped: ({ kind, count }) => `Nicht verwendet: ${count} × ${kind}.`,
  broken: ({ count }) => `Ausgelassen, Zahlen unvollständig: ${entities(count)}.`,
  missingBlock: ({ block }) => `Block ${block} fehlt in der Datei; externe Referenzen vorher binden.`,
  recursiveBlock: ({ block }) => `Block ${block} enthält sich selbst; ausgelassen.`,
  otherPlane: ({ count }) => `Nicht in der Zeichenebene und ausgelassen: ${entities(count)}.`,
  plane: ({ plane }) =>
    plane === "oblique" ? "In einer schrägen Ebene gezeichnet, von vorn gesehen." : `In der Ebene ${plane} gezeichnet.`,
  doubled: ({ count }) => `Übereinander gezeichnet und zusammengefasst: ${lines(count)}.`,
  fitted: ({ kind, count, tolerance }) =>
    `Durch Bögen und Linien auf ${tolerance} mm genau ersetzt: ${count} × ${kind}.`,
  unitAssumed: ({ width, height }) => `Keine Einheit in der Datei: mm angenommen, Größe ${width} × ${height} mm.`,
  unitConverted: ({ unit }) => `In ${unit} gezeichnet, in mm umgerechnet.`,
  unitsDisagree: ({ unit }) => `Die Datei nennt zwei Einheiten; ${unit} gilt. Größe prüfen.`,
  noContour: () => "Auf dieser Seite der Achse ist keine Kontur.",
  onlyAxis: () => "Alle Linien sind auf der Drehachse.",
  axisUnmarked: ({ x }) =>
    `Die Zeichnung zeigt keine Drehachse, ihre Lage ist ein Vorschlag. Kleinster ⌀ damit: ${x} mm.`,
  gapJoined: ({ width, x, z }) => `Lücke von ${width} mm bei X ⌀ ${x}, Z ${z} geschlossen.`,
  gapOpen: ({ width, x, z }) => `Lücke von ${width} mm bei X ⌀ ${x}, Z ${z} offen: Lückentoleranz erhöhen.`,
  axisLines: ({ count }) => `Auf der Drehachse und ausgelassen: ${many(count, "Linie", "Linien")}.`,
  otherHalf: ({ count }) => `Auf der anderen Seite der Achse: ${lines(count)}.`,
  otherPieces: ({ count }) => `Nicht mit der Kontur verbunden: ${many(count, "weiteres Stück", "weitere Stücke")}.`,
  insideLines: ({ count }) => `Innerhalb des Umrisses, nicht Teil der Kontur: ${lines(count)}.`,
  notOutline: ({ count }) => `Verdeckt oder schmal, nicht Teil der Kontur: ${lines(count)}.`,
  rearFace: ({ z }) => `Die hintere Planfläche bei Z ${z} ist ausgelassen.`,
  noSolid: () => "Die Datei enthält keinen Volumenkörper.",
  noRevolved: () => "Kein Körper der Datei hat Drehflächen.",
  otherBodies: ({ name, count, turned }) =>
    `${name === "" ? "Ein Körper" : `Körper ${name}`} übernommen; ${many(count, "weiterer Körper", "weitere Körper")} ausgelassen, ${turned === "0" ? "keiner davon gedreht" : `davon gedreht: ${turned}, wählbar unter „Körper“`}.`,
  notTurned: ({ shape, count }) => `Nicht gedreht und ausgelassen: ${milled(shape, count)}.`,
};
