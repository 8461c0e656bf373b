import type { HandedTexts } from "../en/handed.ts";

const tools = (n: number) => (n === 1 ? "1 Werkzeug" : `${n} Werkzeuge`);

export const handed = {
  title: "Weitergeben",
  lead:
    "Wer es öffnet, sieht dasselbe Bild, dieselben Zahlen und dasselbe Urteil. Kein Server ist beteiligt: Alles steht im Link oder in " +
    "der Datei.",
  working: "Welche Werkzeuge es braucht, wird ermittelt …",
  along: "Was mitgeht",
  facts: {
    name: "Name",
    kind: "Art",
    blocks: "Sätze",
    files: "Dateien daneben",
    tools: "Werkzeuge",
    control: "Steuerung",
    machine: "Maschine",
    size: "Größe",
  },
  program: "Ganzes Programm",
  cycle: (number, name) => `Zyklus ${number}, ${name}`,
  none: "keine",
  kilobytes: (n) => `${n} kB`,
  link: "Link",
  copyLink: "Link kopieren",
  linkLong: "Viele Mailprogramme und Messenger kürzen so lange Links. Besser die Datei weitergeben.",
  hereOnly:
    "Diese Seite gibt es nur auf diesem Gerät: Ein anderes kann den Link nicht öffnen. Besser die Datei weitergeben.",
  linkTooLong: "Der Link wird so lang, dass Browser ihn nicht öffnen. Stattdessen die Datei weitergeben.",
  qr: "QR-Code",
  qrName: (name) => `QR-Code des Links zu ${name}`,
  qrHint: "Die Kamera eines Tablets darauf richten.",
  qrTooLong: (length, most) =>
    `Mit ${length} Zeichen ist der Link zu lang für einen Code, den eine Kamera liest; höchstens ${most} sind möglich.`,
  share: "Teilen …",
  files: "Dateien",
  file: "Als Datei",
  report: "Bericht (JSON)",
  reportHint:
    "Der Bericht ist bis aufs Byte gleich, wo immer diese Arbeit geöffnet wird und unverändert bleibt: die beiden Dateien " +
    "vergleichen.",
  noReport: "Die Berechnung gab keinen Bericht; deshalb gehen alle Werkzeuge der Tabelle mit.",

  inside: (name) => `${name} öffnen?`,
  from: { link: "Dieser Link enthält eine Arbeit.", file: "Diese Datei enthält eine Arbeit." },
  open: "Öffnen",
  notNow: "Jetzt nicht",
  ofItsOwn: "Sie wird eine eigene Arbeit; an den vorhandenen ändert sich nichts.",
  bare: "keine: läuft mit den Werkzeugen dieses Geräts",
  tool: (number, name) => `T${number} ${name}`.trim(),
  state: {
    same: "wie in der eigenen Tabelle",
    free: "nicht in der eigenen Tabelle",
    differs: "andere Werte als die eigenen",
  },
  sameControl: "wie auf diesem Gerät",
  otherControl: (mine) => `dieses Gerät: ${mine}`,

  bar: (n) => `Die offene Arbeit läuft mit ${n === 1 ? "1 eigenen Werkzeug" : `${n} eigenen Werkzeugen`}.`,
  barControl: (control) => `Die offene Arbeit läuft wie auf einer ${control}, so wie sie weitergegeben wurde.`,
  barMachine: (machine) =>
    `Die Zeiten des geöffneten Programms gelten für andere Maschinendaten als die dieses Geräts: ${machine}.`,
  ofWork: "Werkzeuge dieser Arbeit",
  ofWorkLead: "Sie wurde mit diesen Werkzeugen weitergegeben und läuft mit ihnen, nicht mit der Tabelle dieses Geräts.",
  theirs: "Mit der Arbeit",
  mine: "Eigene Tabelle",
  column: "Spalte",
  becomes: (tool) => `Was aus ${tool} wird`,
  as: { mine: "Eigenes behalten", theirs: "Mitgekommenes nehmen", free: "Mitgekommenes auf freie Nummer" },
  keep: "Diese Werkzeuge in meine Tabelle übernehmen",
  kept: (added, replaced) =>
    [
      added > 0 && `${tools(added)} in die eigene Tabelle übernommen`,
      replaced > 0 && `${tools(replaced)} darin ersetzt`,
    ]
      .filter(Boolean)
      .join(", ") + ".",
  nothingToKeep: "Nichts zu tun: Die eigene Tabelle bleibt, wie sie ist.",
  allMine: "Die eigene Tabelle hat sie alle, so wie sie hier stehen.",
  moved: (from, to) =>
    `Werkzeug ${from} der Arbeit steht in der eigenen Tabelle als Werkzeug ${to}: Dort muss TOOL CALL ${to} nennen.`,
  changeCalls: (n) => (n === 1 ? "In 1 TOOL CALL ändern" : `In ${n} TOOL CALL ändern`),
  callsChanged: "Das Programm ruft die neuen Nummern auf.",
  useMine: "Stattdessen meine Tabelle verwenden",
  control: (its, mine) => `Steuerung dieser Arbeit: ${its}. Dieses Gerät: ${mine}.`,
  useControl: (mine) => `Stattdessen ${mine} verwenden`,
  machine: (its, mine) => `Maschine dieses Programms: ${its}. Dieses Gerät: ${mine}.`,
  useMachine: "Maschinendaten dieses Geräts verwenden",
  noMachine: "keine",
} satisfies HandedTexts;
