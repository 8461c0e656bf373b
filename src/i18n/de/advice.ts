import type { AdviceTexts } from "../en/advice.ts";

export const advice = {
  title: "Hinweise",
  lead: "Faustregeln für Ihre Werte. Schätzwerte: Maschine, Beschichtung und Aufspannung sind nicht bekannt.",
  none: "Keine Hinweise zu diesen Werten.",
  nothingOpen: "Programm öffnen, um Hinweise zu seinen Werten zu erhalten.",
  mark: (n) => (n === 1 ? "1 Hinweis" : `${n} Hinweise`),
  show: "Hinweise zeigen",
  take: (value) => `${value} verwenden`,
  operation: (n, cycle) => `Bearbeitung ${n}, Zyklus ${cycle}`,
  of: {
    depthOverEdge: (depth, edge, most) =>
      `Der Schnitt ist ${depth} mm tief, die Schneide ${edge} mm lang. Max. zwei Drittel der Schneidenlänge: ${most} mm.`,
    feedOverNose: (feed, nose, most) =>
      `Vorschub ${feed} mm ist größer als 0,8 × Schneidenradius ${nose} mm. Max. ${most} mm.`,
    rough: (rz, feed, nose, wanted, better) =>
      `Vorschub ${feed} mm und Schneidenradius ${nose} mm ergeben Rz ${rz} µm (f² / 8r). Für Rz ${wanted} µm: ${better} mm.`,
    power: (power, most, speed, better) =>
      `Etwa ${power} kW bei ${speed} m/min (Kienzle); die Spindel hat ${most} kW. Ausreichend für ${better} mm Zustellung.`,
    speedLimited: (limit, held, smallest, left) =>
      `Mit SMAX ${limit} ist die Schnittgeschwindigkeit bis ⌀ ${held} konstant. Bei ⌀ ${smallest} bleiben nur ${left} m/min.`,
    noLimit: (speed) =>
      `${speed} m/min ohne SMAX: Zur Drehachse hin dreht die Spindel mit maximaler Drehzahl. Grenze eingeben.`,
    speedFar: (speed, usual) =>
      `${speed} m/min weichen stark vom üblichen Startwert für diesen Werkstoff ab: ${usual} m/min.`,
  },
  material: "Werkstoff",
  ofDevice: (material) => `Standard: ${material}`,
  deviceMaterial: "Standardwerkstoff",
  groups: {
    P: "Stahl",
    M: "Rostfreier Stahl",
    K: "Gusseisen",
    N: "NE-Metall",
    S: "Schwer zerspanbar",
    H: "Gehärteter Stahl",
  },
  starting: "Startwerte",
  startingLead:
    "Für beschichtetes Hartmetall, bei gehärtetem Stahl CBN. Startwerte; maßgeblich sind die Angaben des " +
    "Plattenherstellers.",
  start: (material, speeds) => `${material}: Startwert ${speeds}.`,
  startSource: "Schätzwert aus Handbüchern: beschichtetes Hartmetall, CBN für gehärteten Stahl.",
  startOwn: "Aus Ihrer Tabelle.",
  values: {
    roughSpeed: "vc Schruppen",
    roughFeed: "f Schruppen",
    finishSpeed: "vc Schlichten",
    finishFeed: "f Schlichten",
    kc11: "kc1.1",
    mc: "mc",
  },
  units: { speed: "m/min", feed: "mm/U", kc: "N/mm²" },
  spindle: "Schnittgeschwindigkeit",
  table: {
    title: "Schnittdaten der Werkstatt",
    lead:
      "Die Werte durch eigene ersetzen; sie sind auf diesem Gerät gespeichert und Teil der Sicherung. kc1.1 und " +
      "mc folgen standardmäßig Tabellen von Röhm (Stahl, Grauguss) und Iscar (die übrigen): Schätzwerte.",
    name: "Werkstoff",
    group: "Gruppe",
    power: "Spindelleistung, kW",
    add: "Werkstoff hinzufügen",
    remove: (name) => `${name} entfernen`,
    reset: "Standardwerte wiederherstellen",
    save: "Exportieren",
    open: "Importieren",
    taken: "Die Datei wurde importiert.",
    wrong: "Diese Datei enthält keine Schnittdaten.",
    cell: (what, name) => `${what}, ${name}`,
    newName: "Neuer Werkstoff",
    refused: "Ungültiger Wert; es gilt der letzte gültige.",
  },
} satisfies AdviceTexts;
