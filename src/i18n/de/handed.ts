import type { HandedTexts } from "../en/handed.ts";

const tools = (n: number) => (n === 1 ? "1 Werkzeug" : `${n} Werkzeuge`);

export const handed = {
  title: "Teilen",
  lead: "Der Empfänger sieht dieselbe Simulation und dasselbe Prüfergebnis. Kein Server ist beteiligt.",
  working: "Benötigte Werkzeuge werden ermittelt …",
  contents: "Inhalt",
  facts: {
    name: "Name",
    kind: "Art",
    blocks: "Sätze",
    files: "Weitere Dateien",
    tools: "Werkzeuge",
    control: "Steuerung",
    machine: "Maschine",
    size: "Größe",
  },
  program: "NC-Programm",
  cycle: (number, name) => `Zyklus ${number}, ${name}`,
  none: "keine",
  kilobytes: (n) => `${n} kB`,
  link: "Link",
  copyLink: "Link kopieren",
  linkLong: "Viele Mailprogramme und Messenger kürzen Links dieser Länge. Stattdessen die Datei teilen.",
  hereOnly:
    "Diese Seite gibt es nur auf diesem Gerät: Andere Geräte können den Link nicht öffnen. Stattdessen die Datei teilen.",
  linkTooLong: "Der Link ist für Browser zu lang. Stattdessen die Datei teilen.",
  qr: "QR-Code",
  qrName: (name) => `QR-Code des Links zu ${name}`,
  qrEnlarge: "QR-Code im Vollbild zeigen",
  qrHint: "Mit der Kamera eines Tablets scannen.",
  qrTooLong: (length, most) =>
    `Der Link ist zu lang für einen QR-Code: ${length} Zeichen, höchstens ${most}. Link oder Datei teilen.`,
  share: "Teilen …",
  files: "Dateien",
  file: "Als Datei",
  report: "Bericht (JSON)",
  reportHint:
    "Der Bericht ist überall byteweise gleich, wo dieses Programm unverändert geöffnet wird: die beiden Dateien vergleichen.",
  noReport: "Kein Bericht verfügbar; daher sind alle Werkzeuge der Tabelle enthalten.",

  inside: (name) => `${name} öffnen?`,
  from: { link: "Dieser Link enthält ein Programm.", file: "Diese Datei enthält ein Programm." },
  open: "Öffnen",
  notNow: "Jetzt nicht",
  opensSeparately: "Wird als eigenes Programm geöffnet; vorhandene Programme bleiben unverändert.",
  bare: "keine: verwendet die Werkzeuge dieses Geräts",
  tool: (number, name) => `T${number} ${name}`.trim(),
  state: {
    same: "wie in der eigenen Tabelle",
    free: "nicht in der eigenen Tabelle",
    differs: "andere Werte als die eigenen",
  },
  sameControl: "wie auf diesem Gerät",
  otherControl: (mine) => `dieses Gerät: ${mine}`,

  bar: (n) => `Das geöffnete Programm verwendet ${n === 1 ? "1 eigenes Werkzeug" : `${n} eigene Werkzeuge`}.`,
  barControl: (control) => `Das geöffnete Programm wird wie geteilt für eine ${control} simuliert.`,
  barMachine: (machine) =>
    `Die Zeiten des geöffneten Programms gelten für andere Maschinendaten als die dieses Geräts: ${machine}.`,
  ofWork: "Werkzeuge dieses Programms",
  ofWorkLead: "Dieses Programm wurde mit diesen Werkzeugen geteilt und verwendet sie, nicht die Tabelle dieses Geräts.",
  theirs: "Mit dem Programm",
  mine: "Eigene Tabelle",
  column: "Spalte",
  becomes: (tool) => `Aktion für ${tool}`,
  as: { mine: "Eigenes behalten", theirs: "Geteiltes verwenden", free: "Geteiltes auf freie Nummer" },
  keep: "Diese Werkzeuge in meine Tabelle übernehmen",
  kept: (added, replaced) =>
    [
      added > 0 && `${tools(added)} in die eigene Tabelle übernommen`,
      replaced > 0 && `${tools(replaced)} darin ersetzt`,
    ]
      .filter(Boolean)
      .join(", ") + ".",
  nothingToKeep: "Die eigene Tabelle bleibt unverändert.",
  allMine: "Die eigene Tabelle enthält diese Werkzeuge bereits mit denselben Werten.",
  moved: (from, to) =>
    `Werkzeug ${from} des Programms ist in der eigenen Tabelle Werkzeug ${to}: TOOL CALL muss dort ${to} nennen.`,
  changeCalls: (n) => (n === 1 ? "1 TOOL CALL ändern" : `${n} TOOL CALL ändern`),
  callsChanged: "Das Programm ruft die neuen Nummern auf.",
  useMine: "Stattdessen meine Tabelle verwenden",
  control: (its, mine) => `Steuerung dieses Programms: ${its}. Dieses Gerät: ${mine}.`,
  useControl: (mine) => `Stattdessen ${mine} verwenden`,
  machine: (its, mine) => `Maschine dieses Programms: ${its}. Dieses Gerät: ${mine}.`,
  useMachine: "Maschinendaten dieses Geräts verwenden",
  noMachine: "keine",
} satisfies HandedTexts;
