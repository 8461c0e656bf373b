import type { PageTexts } from "../../en/first/page.ts";

export const page = {
  product: "Turnwise",
  home: "Turnwise, Startseite",
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
  size: "Schriftgröße",
  sizes: { usual: "Üblich", presentation: "Groß, für den Unterricht" },
  motions: { system: "Wie das System", reduced: "Keine" },
  gallery: "Galerie: jeder Zyklus und jedes Programm der Prüfungen, gezeichnet",
  disclaimer:
    "Nach den gedruckten Zyklenseiten gebaut; kein Produkt von HEIDENHAIN. Jedes Programm vor dem Zerspanen an der Steuerung prüfen.",

  sections: "Teile des Programms",
  prompts: "Eingaben",
  setup: "Einrichten",
  contour: "Kontur",
  program: "Programm",
  lathe: "Drehmaschine",
  timeline: "Zeitleiste",

  start: {
    which: "Welcher Zyklus?",
    title: "HEIDENHAIN-Drehzyklen im Dialog",
    lead: "Für TNC 640 und TNC7. Fragen beantworten wie an der Steuerung, der Drehmaschine zusehen, den Schnitt prüfen, Programm mitnehmen.",
    choose: "Zyklus wählen",
    chooseLead: "Ein Tippen auf den Zyklus beginnt mit Beispielwerten, „Leer“ beginnt ohne Werte.",
    search: "Zyklen, Beispiele und eigene Arbeiten suchen",
    found: (n) => `${n} gefunden.`,
    foundWork: (name) => `Gespeicherte Arbeit: ${name}`,
    foundExample: (title) => `Beispiel: ${title}`,
    beyond: "Was keine Steuerung zeigt",
    beyondAll: {
      typing: { what: "Beim Eingeben", how: "Schnitte, wirkliche Zustellung, Zeit und Spanquerschnitt" },
      residue: { what: "Restmaterial", how: "wo, warum, und welches Werkzeug hinkommt" },
      proof: {
        what: "Prüfung",
        how: "keine Konturverletzung, kein Eilgang im Material; sonst der Satz, der es verursacht",
      },
      steps: { what: "Schritt für Schritt", how: "der Ablauf aus dem Handbuch läuft mit dem Werkzeug mit" },
      approach: { what: "APPR und DEP", how: "alle acht Formen, an der eigenen Kontur" },
    },
    live: {
      name: (cycle) => `Zyklus ${cycle} dreht sein Beispiel: Das Werkzeug läuft, das Material wird abgetragen`,
      play: "Bild abspielen",
      pause: "Bild anhalten",
      pass: (n, of) => `Schnitt ${n} von ${of}`,
      finish: "Schlichten",
      position: "Positionieren",
      proved: "geprüft",
    },
    withExample: "Mit Beispielwerten beginnen",
    empty: "Leer beginnen",
    cycle: (number, name) => `Zyklus ${number}, ${name}`,
    kept: "Auf diesem Gerät gespeichert",
    allWorks: (n) => `Alle Arbeiten (${n})`,
    isElsewhere: "in einem anderen Tab offen",
    task: "Aufgabe",
    continueWork: (name) => `${name} fortsetzen`,
    forget: (name) => `${name} aus der Liste nehmen`,
    removed: (name) => `${name} wurde entfernt.`,
    changed: (when) => `geändert ${when}`,
    unconfirmed: "Die Parameterliste dieses Zyklus ist aus der Erinnerung, nicht an einer gedruckten Seite geprüft.",
  },

  programs: {
    title: "Ganze Programme",
    lead: "Ein Klartext-Programm öffnen, verstehen, im Dialog ändern und unversehrt wieder mitnehmen.",
    openFile: "Dateien öffnen",
    openFolder: "Ordner öffnen",
    paste: "Programm einfügen",
    create: "Neues leeres Programm",
    drop: "oder Dateien hier ablegen",
    dropHere: "Programm hier ablegen, mit den Dateien, die es aufruft",
    examples: "Beispiele",
    example: (title) => `Beispiel ${title} öffnen`,
    fromJob: "Als Programm öffnen",
    fromJobLong: "Dieses Programm als ganzes Programm öffnen; die Dialogwerte bleiben bei der bisherigen Arbeit",
    pasteTitle: "Programm einfügen",
    pasteLabel: "Programmtext",
    pasteOpen: "Öffnen",
    cancel: "Abbrechen",
    unreadable: "Diese Datei konnte nicht gelesen werden.",
    tooLarge: "Das sind mehr als 20 MB.",
  },
  examples: {
    flange: "Flansch: sechs Werkzeuge, acht Zyklen",
    shaft:
      "Welle: zehn Bearbeitungen mit sieben Werkzeugen, mit Kegel, Freistich, Einstichen und Gewinden außen und innen",
    shoulder: "Absatz, wie gedruckt (französisch)",
    contour: "Kontur plan, wie gedruckt (französisch)",
    contourEnglish: "Kontur plan, wie gedruckt (englisch)",
    groove: "Einstich, wie gedruckt (französisch)",
    plate: "Gefräste Platte: An- und Wegfahren",
  },
  loading: "Der Editor wird geladen.",
  tools: {
    title: "Werkzeugtabelle",
    open: "Werkzeuge",
    openLong: "Werkzeugtabelle öffnen",
  },
  own: { title: "Eigene Zyklen" },
  works: { title: "Alle Arbeiten" },

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
    waiting: "Die Werte ergeben noch keine Bahn. Das letzte mögliche Bild bleibt.",
    duration: (minutes, seconds) =>
      minutes < 60
        ? minutes > 0
          ? `${minutes} min ${seconds} s`
          : `${seconds} s`
        : `${Math.floor(minutes / 60)} h ${minutes % 60} min`,
    faults: "Konturverletzungen und Kollisionen",
    pin: {
      make: "Einstellung merken",
      title: "Gemerkte Einstellung",
      pinned: "Gemerkt",
      now: "Jetzt",
      back: "Zurück zur gemerkten",
      letGo: "Verwerfen",
      fold: "Vergleich einklappen",
      unfold: "Vergleich zeigen",
    },
  },

  text: {
    title: "Programmtext",
    name: "Programmname",
    layout: "Schreibweise",
    layouts: { tnc640: "TNC 640", tnc7: "TNC7", iso: "DIN/ISO", manual: "Wie im Handbuch" },
    files: { tnc640: "Klartext-Datei für TNC 640", tnc7: "Klartext-Datei für TNC7", iso: "DIN/ISO-Datei" },
    manualView:
      "Gezeigt wie im Handbuch gedruckt, ohne ~. So lädt es keine Steuerung; Kopieren und Herunterladen geben die Datei.",
    showFile: "Datei zeigen",
    untied: "Zykluslisten ohne ~: Eine Steuerung lädt dieses Programm nicht.",
    tie: "~ ergänzen",
    isoKept: (blocks) => `Ohne DIN/ISO-Wort, bleibt Klartext: ${blocks}.`,
    isoUnverified: "Die Reihenfolge der Wörter im Satz ist nicht am Handbuch geprüft: an der Steuerung vergleichen.",
    output: "NC-Ausgabe",
    asIso: "DIN/ISO-Datei",
    language: "Texte",
    languageLong: "Sprache des Programmtexts",
    noChinese: "Keine uns vorliegende Seite druckt chinesische Texte: die chinesische Seite der TNC7 hat englische.",
    copy: "Kopieren",
    copyLong: "Programm kopieren",
    copied: "Kopiert",
    copiedLong: (blocks) => `Das Programm liegt in der Zwischenablage: ${blocks} Sätze.`,
    download: (file) => `${file} herunterladen`,
    fold: "Programm einklappen",
    unfold: "Programm zeigen",
    setupSheet: "Einrichteblatt",
    clamping: "Spannung",
    workshopDrawing: "Werkstattzeichnung",
    handOn: "Weitergeben",
    exportPart: "Teil exportieren",
    turnRound: "Umspannen",
    makeTask: "Aufgabe aus diesem Programm machen",
    compare: "Vergleichen",
    blocks: "Sätze des Programms",
    running: "läuft",
    refusedTitle: "Von Hand kopieren",
    refused:
      "Der Browser erlaubt keinen Zugriff auf die Zwischenablage. Der Text unten ist markiert: Strg+C drücken oder gedrückt " +
      "halten und „Kopieren“ wählen.",
    incomplete: "Einige Eingaben haben noch keinen brauchbaren Wert; das Programm ist nicht vollständig.",
  },

  notice: {
    dismiss: "Ausblenden",
    damaged: (n) =>
      n === 1
        ? "Eine gespeicherte Arbeit war nicht lesbar. Sie wurde beiseitegelegt, nichts wurde gelöscht."
        : `${n} gespeicherte Arbeiten waren nicht lesbar. Sie wurden beiseitegelegt, nichts wurde gelöscht.`,
    notKept:
      "Dieser Browser speichert nichts auf dem Gerät. Das Programm vor dem Schließen kopieren oder herunterladen.",
    storageFull:
      "Auf dem Gerät ist kein Platz mehr: Die letzten Änderungen sind nicht gespeichert. Das Programm herunterladen oder auf der " +
      "Startseite Arbeiten entfernen.",
    newerWorks:
      "Einige gespeicherte Arbeiten stammen von einer neueren Version dieser Seite und sind nicht aufgeführt. Nichts wurde gelöscht.",
    downloadUnkept: "Programm herunterladen",
    archiveUnkept: "Als eine Datei sichern",
    copyOfOtherTab:
      "Diese Arbeit ist in einem anderen Tab offen. Hier wird eine Kopie bearbeitet; beide bleiben erhalten.",
    workNotHere:
      "Die Arbeit dieser Adresse liegt nicht auf diesem Gerät: anderer Browser, oder aus der Liste entfernt.",
    linkDamaged: "Der Link enthält nichts Lesbares.",
    linkNewer:
      "Den Link hat eine neuere Ausgabe dieser Seite gemacht. Die Seite neu laden und den Link noch einmal öffnen.",
    linkTooLarge:
      "Das Programm im Link ist größer als 20 MB und wurde nicht geöffnet. Die eigene Arbeit ist unverändert.",
    fileTooLarge: "Das sind mehr als 20 MB; es wurde nichts geöffnet. Die eigene Arbeit ist unverändert.",
    fileUnreadable: "Die Datei war nicht lesbar und wurde nicht geöffnet. Die eigene Arbeit ist unverändert.",
    engineFailed: "Die Berechnung ist abgebrochen. Die Werte sind sicher, und sie lässt sich neu starten.",
    toolsDamaged:
      "Die gespeicherte Werkzeugtabelle ließ sich nicht lesen. Sie wurde beiseitegelegt; es gelten die mitgelieferten Werkzeuge.",
    filesLeftOut:
      "Aus dem Ordner wurde nicht alles geöffnet: Dateien, die keine Programmtexte sind oder zu viele auf einmal wären, blieben weg.",
    isoRead:
      "Das DIN/ISO-Programm wurde in Klartext übersetzt und wird so bearbeitet. „DIN/ISO-Datei“ schreibt es zurück.",
    mainUnsure:
      "Kein Programm hier ruft alle anderen auf. Soll ein anderes laufen, dieses in der Dateiliste über dem Text wählen.",
    toolsNotKept:
      "Dieser Browser speichert die Werkzeugtabelle nicht auf dem Gerät. Vor dem Schließen der Seite exportieren.",
    ownDamaged:
      "Die gespeicherten eigenen Zyklen waren nicht lesbar. Sie wurden beiseitegelegt, nichts wurde gelöscht.",
    ownNotKept:
      "Dieser Browser speichert die eigenen Zyklen nicht auf dem Gerät. Vor dem Schließen der Seite exportieren.",
    crashTitle: "Auf dieser Seite ist etwas schiefgegangen",
    crash: "Die Arbeit ist auf diesem Gerät gespeichert.",
    missing: {
      offline:
        "Dieser Teil der Seite ließ sich nicht holen: kein Netz. Was offen ist, bleibt; der Teil kommt, sobald ein Netz da ist.",
      gone: "Dieser Teil der Seite ließ sich nicht vom Server holen. Was offen ist, bleibt, auch wenn die Seite neu geladen wird.",
    },
    tryAgain: "Noch einmal versuchen",
    reload: "Seite neu laden",
    startOver: "Zur Startseite",
  },
} satisfies PageTexts;
