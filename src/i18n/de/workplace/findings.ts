import type { FindingsTexts } from "../../en/workplace/findings.ts";

export const findings = {
  title: "Befunde",
  list: "Befunde, die schwersten zuerst",
  none: "Keine Befunde.",
  count: (n) => (n === 1 ? "1 Befund" : `${n} Befunde`),
  more: (n) =>
    n === 1 ? "1 weiterer Befund steht nicht in der Liste." : `${n} weitere Befunde stehen nicht in der Liste.`,
  severities: { error: "Fehler", warning: "Warnung", info: "Hinweis" },
  inBlock: (block) => `Satz ${block}`,
  blockOf: (block, file) => `Satz ${block} von ${file}`,
  lineOf: (line, file) => `Zeile ${line} von ${file}`,
  goTo: (place) => `Zu ${place}`,
  show: (mark) => `${mark} in der Drehansicht zeigen`,
  places: {
    tool: "Werkzeug",
    startX: "Start X",
    startZ: "Start Z",
    contour: "Kontur",
    blank: "Rohteil",
    spindle: "Spindel",
  },
  fix: "Berichtigen",
  insert: (text) => `${text} einfügen`,
  write: (text, block) => `${text} in Satz ${block} schreiben`,
  meant: "Dieser Schnitt ist gewollt",
  remove: (text) => `${text} entfernen`,
  residue: {
    askCycle: "Welcher Zyklus nimmt es weg?",
    thick: (mm) => `Es ist bis zu ${mm} mm dick.`,
    ask: "Welches Werkzeug nimmt es weg?",
    trying: "Die Werkzeuge der Tabelle werden ausprobiert.",
    all: (tool) => `Werkzeug ${tool} lässt hier nichts stehen.`,
    leaves: (tool, area) => `Werkzeug ${tool} lässt ${area} stehen.`,
    none: "Kein Werkzeug der Tabelle nimmt mehr davon weg.",
  },
  verdict: {
    title: "Prüfung",
    none: "–",
    proved: "Geprüft: keine Konturverletzung, kein Eilgang im Material",
    stays: (area) => `Geprüft; Restmaterial ${area}`,
    warnings: (n) => (n === 1 ? "Geprüft, mit 1 Warnung" : `Geprüft, mit ${n} Warnungen`),
    holderUnknown: "Bahn geprüft, Halter nicht geprüft",
    faults: (n) => (n === 1 ? "1 Fehler" : `${n} Fehler`),
    unproved: "Nicht alles wurde simuliert",
    nothingCut: "Eine Bearbeitung hat nichts abgetragen",
    noCycle: "Ohne Zyklus: kein Eilgang im Material",
    noOperation: "Nichts ist geprüft",
    milling: "Fräsen ist nicht geprüft",
    flanksUnknown: "Bahn geprüft, Flanken nicht geprüft",
    curvatureUnknown: "Bahn geprüft, Stecherkrümmung nicht geprüft",
    faultsIn: (n, file) => (n === 1 ? `1 Fehler, in ${file}` : `${n} Fehler, der erste in ${file}`),
    unprovedIn: (file) => `In ${file} wurde nicht alles simuliert`,
    notes: "Weg geprüft, Hinweise beachten",
    because: {
      notes: {
        feed: "Ein Vorschub ist kaum so gemeint.",
        air: "Die meisten Schnitte einer Bearbeitung gehen durch Luft.",
        residue: "Es bleibt mehr als 1 mm² Material, das nicht vorgegeben ist.",
        cutLength: "Die Schneide ist zu kurz für die Tiefe einer Bearbeitung.",
      },
      whatIn: (what, file) => `${what} in ${file}`,
      unproved: (what, block) => `Ab Satz ${block} ist nichts geprüft: ${what} wird nicht simuliert.`,
      unprovedAnywhere: (what) => `${what} wird nicht simuliert: Nichts ist geprüft.`,
      nothingCut: (cycle, block) => `Zyklus ${cycle}, aufgerufen in Satz ${block}, hat nichts abgetragen.`,
      milling: (block) => `Das Fräsen ab Satz ${block} ändert das Rohteil und ist nicht geprüft.`,
      noCycle:
        "Kein Drehzyklus wurde ausgeführt: Die Eilgänge sind geprüft, aber es ist keine Kontur bekannt, an der das Teil geprüft würde.",
      noOperation: "Kein Drehzyklus wurde ausgeführt: Es gibt nichts zu prüfen.",
      approachesClear: "An- und Wegfahren sind frei.",
      holderUnknown: (tools) => `Der Halter von Werkzeug ${tools} wurde nicht geprüft: Die Tabelle beschreibt keinen.`,
      flanksUnknown: (tools) =>
        `Die Flanken von Werkzeug ${tools} wurden nicht geprüft: T-ANGLE oder P-ANGLE ist leer.`,
      curvatureUnknown: (tools) => `Für den Axialstecher von Werkzeug ${tools} ist kein Durchmesserbereich angegeben.`,
    },
  },
  leaving: {
    title: "Dieses Programm hat Fehler",
    lead: (n) =>
      n === 1
        ? "So darf es nicht auf einer Maschine laufen. Ein Fehler wurde gefunden:"
        : `So darf es nicht auf einer Maschine laufen. ${n} Fehler wurden gefunden:`,
    unchecked: "Dieses Programm ist noch nicht geprüft",
    uncheckedLead: "Die Berechnung läuft noch. Ob das Programm Fehler hat, ist nicht bekannt.",
    go: {
      copy: "Trotzdem kopieren",
      save: "Trotzdem speichern",
      download: "Trotzdem herunterladen",
      share: "Trotzdem teilen",
    },
    look: "Befunde zeigen",
    cancel: "Abbrechen",
    withFaults: (n) => (n === 1 ? "Es hat 1 Fehler." : `Es hat ${n} Fehler.`),
  },
  done: {
    contour: "Die Kontur fehlt noch",
    toContour: "Kontur eingeben",
    faults: (n) =>
      n === 1
        ? "Alle Eingaben sind gemacht, aber 1 Fehler wurde gefunden"
        : `Alle Eingaben sind gemacht, aber ${n} Fehler wurden gefunden`,
  },
} satisfies FindingsTexts;
