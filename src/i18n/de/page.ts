import type { PageTexts } from "../en/page.ts";

export const page = {
  product: "Turnwise",
  promise: "HEIDENHAIN-Drehzyklen im Dialog: Schnitt sehen, prüfen, Programm kopieren.",
  skipToPrompts: "Zu den Eingaben springen",
  header: "Arbeit und Einstellungen",
  undo: "Rückgängig",
  redo: "Wiederholen",
  newProgram: "Neues Programm",
  settings: "Einstellungen",
  close: "Schließen",
  screenLanguage: "Bildschirmsprache",
  control: "Steuerung (APPR und DEP mit Z)",
  controls: { "TNC 640": "TNC 640: erst in der Ebene, dann in Z", TNC7: "TNC7: in allen Achsen gleichzeitig" },
  theme: "Darstellung",
  themes: { system: "Wie das System", light: "Hell", dark: "Dunkel" },
  motion: "Bewegung",
  motions: { system: "Wie das System", reduced: "Keine" },
  disclaimer:
    "Nach den gedruckten Zyklenseiten gebaut; kein Produkt von HEIDENHAIN. Jedes Programm vor dem Zerspanen an der Steuerung prüfen.",
  savedHere: "Auf diesem Gerät gespeichert",

  sections: "Teile des Programms",
  prompts: "Eingaben",
  setup: "Einrichten",
  contour: "Kontur",
  program: "Programm",
  lathe: "Drehmaschine",
  timeline: "Zeitleiste",
  helpPicture: "Hilfsbild",

  start: {
    title: "Welcher Zyklus?",
    lead: "Zyklus wählen, Fragen beantworten, der Maschine zusehen, Programm kopieren.",
    withExample: "Mit Beispielwerten beginnen",
    empty: "Leer beginnen",
    cycle: (number, name) => `Zyklus ${number}, ${name}`,
    kept: "Auf diesem Gerät gespeichert",
    showAll: (n) => `Alle ${n} anzeigen`,
    continueWork: (name) => `${name} fortsetzen`,
    forget: (name) => `${name} aus der Liste nehmen`,
    removed: (name) => `${name} wurde entfernt.`,
    changed: (when) => `geändert ${when}`,
    unconfirmed: "Die Parameterliste dieses Zyklus ist aus der Erinnerung, nicht an einer gedruckten Seite geprüft.",
  },

  examples: {
    title: "Beispielprogramme",
    open: (name) => `Beispiel öffnen: ${name}`,
    names: {
      flange: "Flansch: sechs Werkzeuge, vom Rohteil zum Fertigteil",
      shoulder: "Absatz, Zyklus 812, wie für TNC 640 gedruckt (französische Texte)",
      contour: "Kontur, Zyklus 820, wie für TNC 640 gedruckt (französische Texte)",
      contourEnglish: "Kontur, Zyklus 820, wie für TNC7 gedruckt (englische Texte)",
      groove: "Einstich, Zyklus 852, wie für TNC 640 gedruckt (französische Texte)",
      plate: "Platte: An- und Wegfahren, gefräst",
    },
  },

  effect: {
    title: "Was diese Werte bewirken",
    passes: "Schnitte",
    infeed: "Zustellung",
    infeedUnit: "mm je Schnitt",
    time: "Zeit",
    chip: "Spanquerschnitt",
    residual: "Restmaterial",
    none: "keins",
    unknown: "–",
    waiting: "Die Werte ergeben noch keinen Weg. Das letzte mögliche Bild bleibt stehen.",
    duration: (minutes, seconds) => (minutes > 0 ? `${minutes} min ${seconds} s` : `${seconds} s`),
  },

  text: {
    title: "Programmtext",
    name: "Programmname",
    layout: "Schreibweise",
    layouts: { tnc640: "TNC 640", tnc7: "TNC7" },
    language: "Texte",
    languageLong: "Sprache des Programmtexts",
    copy: "Kopieren",
    copyLong: "Programm kopieren",
    copied: "Kopiert",
    copiedLong: (blocks) => `Das Programm liegt in der Zwischenablage: ${blocks} Sätze.`,
    download: (file) => `${file} herunterladen`,
    fold: "Programm einklappen",
    unfold: "Programm zeigen",
    blocks: "Sätze des Programms",
    running: "läuft",
    refusedTitle: "Von Hand kopieren",
    refused: "Der Browser erlaubt keinen Zugriff auf die Zwischenablage. Der Text unten ist markiert: Strg+C drücken oder gedrückt "
      + "halten und „Kopieren“ wählen.",
    incomplete: "Einige Eingaben haben noch keinen brauchbaren Wert; das Programm ist nicht vollständig.",
  },

  notice: {
    dismiss: "Ausblenden",
    damaged: (n) =>
      n === 1
        ? "Eine gespeicherte Arbeit war nicht lesbar. Sie wurde beiseitegelegt, nichts wurde gelöscht."
        : `${n} gespeicherte Arbeiten waren nicht lesbar. Sie wurden beiseitegelegt, nichts wurde gelöscht.`,
    notKept: "Dieser Browser speichert nichts auf dem Gerät. Das Programm vor dem Schließen kopieren oder herunterladen.",
    storageFull:
      "Auf dem Gerät ist kein Platz mehr: Die letzten Änderungen sind nicht gespeichert. Das Programm herunterladen oder auf der "
      + "Startseite Arbeiten entfernen.",
    newerWorks:
      "Einige gespeicherte Arbeiten stammen von einer neueren Ausgabe dieser Seite und sind nicht aufgeführt. Nichts wurde gelöscht.",
    downloadUnkept: "Programm herunterladen",
    copyOfOtherTab: "Diese Arbeit ist in einem anderen Tab offen. Hier wird eine Kopie bearbeitet; beide bleiben erhalten.",
    linkDamaged: "Der Link enthält kein lesbares Programm.",
    linkTooLarge: "Das Programm im Link ist größer als 20 MB und wurde nicht geöffnet. Die eigene Arbeit ist unverändert.",
    fileTooLarge: "Die Datei ist größer als 20 MB und wurde nicht geöffnet. Die eigene Arbeit ist unverändert.",
    fileUnreadable: "Die Datei war nicht lesbar und wurde nicht geöffnet. Die eigene Arbeit ist unverändert.",
    engineFailed: "Die Berechnung ist stehen geblieben und wurde neu gestartet. Die Werte sind sicher.",
    toolsDamaged:
      "Die gespeicherte Werkzeugtabelle ließ sich nicht lesen. Sie wurde beiseitegelegt; es gelten die mitgelieferten Werkzeuge.",
    toolsNotKept: "Dieser Browser speichert die Werkzeugtabelle nicht auf dem Gerät. Vor dem Schließen der Seite exportieren.",
    crashTitle: "Auf dieser Seite ist etwas schiefgegangen",
    crash: "Die Arbeit ist auf diesem Gerät gespeichert.",
    reload: "Seite neu laden",
    startOver: "Zur Startseite",
  },
} satisfies PageTexts;
