import type { AdviceTexts } from "../en/advice.ts";

export const advice = {
  title: "Hinweise",
  lead: "Faustregeln, auf Ihre Werte angewandt. Es sind Schätzungen: Maschine, Beschichtung und Spannung kennt hier niemand.",
  none: "Zu diesen Werten gibt es nichts anzumerken.",
  nothingOpen: "Öffnen Sie eine Arbeit, um Hinweise zu ihren Werten zu erhalten.",
  mark: (n) => (n === 1 ? "1 Hinweis" : `${n} Hinweise`),
  show: "Hinweise geben",
  take: (value) => `${value} übernehmen`,
  operation: (n, cycle) => `Bearbeitung ${n}, Zyklus ${cycle}`,
  of: {
    depthOverEdge: (depth, edge, most) =>
      `Der Schnitt ist ${depth} mm tief, die Schneide ${edge} mm lang. Zwei Drittel davon, ${most} mm, sollte sie tragen.`,
    feedOverNose: (feed, nose, most) =>
      `Ein Vorschub von ${feed} mm ist mehr als 0,8 des Schneidenradius ${nose} mm. Bis ${most} mm hält die Ecke.`,
    rough: (rz, feed, nose, wanted, better) =>
      `Vorschub ${feed} mm und Radius ${nose} mm lassen Rz ${rz} µm (f² / 8r). Für Rz ${wanted} µm sind es ${better} mm.`,
    power: (power, most, speed, better) =>
      `Etwa ${power} kW bei ${speed} m/min (Kienzle); die Spindel hat ${most} kW. Mit ${better} mm Zustellung reicht das.`,
    speedLimited: (limit, held, smallest, left) =>
      `Mit SMAX ${limit} wird die Schnittgeschwindigkeit bis ⌀ ${held} gehalten. Bei ⌀ ${smallest} sind es nur noch ${left} m/min.`,
    noLimit: (speed) =>
      `${speed} m/min ohne SMAX: Zur Achse hin dreht die Spindel, so schnell sie kann. Geben Sie eine Grenze an.`,
    speedFar: (speed, usual) =>
      `${speed} m/min liegen weit von den ${usual} m/min, mit denen man bei diesem Werkstoff beginnt.`,
  },
  material: "Werkstoff",
  ofDevice: "wie auf diesem Gerät",
  deviceMaterial: "Werkstoff der Arbeiten, die keinen nennen",
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
    "Für beschichtetes Hartmetall, bei gehärtetem Stahl für CBN, zum Anfangen; der Hersteller der Platte weiß es besser.",
  start: (material, speeds) => `${material}: zu Beginn ${speeds}.`,
  startSource: "Schätzwert aus Handbüchern: beschichtetes Hartmetall, CBN für gehärteten Stahl.",
  startOwn: "Aus Ihrer eigenen Tabelle.",
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
      "Ersetzen Sie die Werte durch Ihre eigenen; sie bleiben auf diesem Gerät und kommen in die Gesamtdatei. " +
      "kc1.1 und mc folgen ab Werk Tabellen von Röhm (Stahl, Grauguss) und Iscar (die übrigen): Schätzwerte.",
    name: "Werkstoff",
    group: "Gruppe",
    power: "Leistung der Spindel, kW",
    add: "Werkstoff hinzufügen",
    remove: (name) => `${name} entfernen`,
    reset: "Zurück zu den mitgelieferten Werten",
    save: "Als Datei sichern",
    open: "Aus einer Datei",
    taken: "Die Datei wurde übernommen.",
    wrong: "Diese Datei enthält keine Schnittdaten.",
    cell: (what, name) => `${what}, ${name}`,
    newName: "Neuer Werkstoff",
    refused: "Dieser Wert kann hier nicht stehen; es gilt der letzte mögliche.",
  },
} satisfies AdviceTexts;
