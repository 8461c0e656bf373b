import type { PageTexts } from "../../en/first/page.ts";

export const page = {
  product: "Turnwise",
  home: "Turnwise, Startseite",
  promise: "HEIDENHAIN-Drehzyklen programmieren: jeden Schnitt sehen, prüfen, Programm exportieren.",
  skipToPrompts: "Zu den Eingaben springen",
  header: "Programm und Einstellungen",
  keys: "Tastenkürzel",
  commands: "Befehle",
  undo: "Rückgängig",
  redo: "Wiederholen",
  newProgram: "Neues Programm",
  settings: "Einstellungen",
  close: "Schließen",
  screenLanguage: "Bildschirmsprache",
  control: "Steuerung (APPR und DEP mit Z)",
  controls: { "TNC 640": "TNC 640: erst in der Ebene, dann in Z", TNC7: "TNC7: in allen Achsen gleichzeitig" },
  theme: "Darstellung",
  themes: { system: "System", light: "Hell", dark: "Dunkel" },
  motion: "Bewegung",
  size: "Schriftgröße",
  sizes: { usual: "Standard", presentation: "Präsentation" },
  motions: { system: "System", reduced: "Keine" },
  gallery: "Zyklusübersicht",
  disclaimer:
    "Nach gedruckten Zyklenhandbüchern; kein Produkt von HEIDENHAIN. Jedes Programm vor der Bearbeitung an der Steuerung prüfen.",

  sections: "Teile des Programms",
  prompts: "Eingaben",
  setup: "Einrichten",
  contour: "Kontur",
  program: "Programm",
  lathe: "Drehmaschine",
  timeline: "Zeitleiste",

  columns: {
    left: "Breite der linken Spalte",
    right: "Breite des Programmtexts",
    hint: "Ziehen oder Pfeiltasten. Doppelklick oder Enter: Standardbreite",
  },

  start: {
    which: "Zyklus suchen",
    title: "HEIDENHAIN-Drehzyklen für TNC 640 und TNC7 programmieren und jeden Schnitt sehen",
    choose: "Zyklus wählen",
    chooseLead: "Zyklus wählen: beginnt mit Beispielwerten, „Ohne Werte“ beginnt leer.",
    search: "Zyklen, Beispiele und eigene Programme suchen",
    found: (n) => `${n} gefunden.`,
    foundWork: (name) => `Gespeichertes Programm: ${name}`,
    foundExample: (title) => `Beispiel: ${title}`,
    withExample: "Mit Beispielwerten beginnen",
    empty: "Ohne Werte beginnen",
    cycle: (number, name) => `Zyklus ${number}, ${name}`,
    kept: "Auf diesem Gerät gespeichert",
    allWorks: (n) => `Alle Programme (${n})`,
    isElsewhere: "in einem anderen Tab offen",
    task: "Aufgabe",
    program: "NC-Programm",
    exercises: (count) => `Aufgaben (${count})`,
    continueWork: (name) => `${name} fortsetzen`,
    forget: (name) => `${name} aus der Liste nehmen`,
    removed: (name) => `${name} wurde entfernt.`,
    changed: (when) => `geändert ${when}`,
  },

  programs: {
    title: "NC-Programme",
    openFile: "Programm öffnen",
    openFolder: "Ordner öffnen",
    paste: "Programm einfügen",
    create: "Neues Programm",
    drop: "oder Dateien hier ablegen, Text einfügen",
    dropHere: "Programm hier ablegen, mit den Dateien, die es aufruft",
    examples: "Beispiele",
    example: (title) => `Beispiel ${title} öffnen`,
    fromJob: "In NC-Programm umwandeln",
    fromJobLong: "In ein NC-Programm umwandeln; der Zyklus mit seinen Eingaben bleibt als eigenes Programm erhalten",
    pasteTitle: "Programm einfügen",
    pasteLabel: "Programmtext",
    pasteOpen: "Öffnen",
    cancel: "Abbrechen",
    unreadable: "Diese Datei konnte nicht gelesen werden.",
    tooLarge: "Größer als 20 MB.",
  },
  examples: {
    flange: "Flansch: sechs Werkzeuge, acht Zyklen",
    shaft: "Welle: zehn Bearbeitungen, zehn Werkzeuge; Kegel, Freistich, Einstiche, Außen- und Innengewinde",
    shoulder: "Handbuchbeispiel 812 (französisch)",
    contour: "Handbuchbeispiel 820 (französisch)",
    contourEnglish: "Handbuchbeispiel 820 (englisch)",
    groove: "Handbuchbeispiel 852 (französisch)",
    plate: "Gefräste Platte: An- und Wegfahren",
  },
  loading: "Editor wird geladen …",
  readingDevice: "Die Programme dieses Geräts werden gelesen …",
  tools: {
    title: "Werkzeugtabelle",
    open: "Werkzeuge",
    openLong: "Werkzeugtabelle öffnen",
  },
  own: { title: "Eigene Zyklen" },
  works: { title: "Alle Programme" },

  effect: {
    title: "Wirkung dieser Werte",
    passes: "Schnitte",
    infeed: "Zustellung",
    infeedUnit: "mm je Schnitt",
    time: "Zeit",
    chip: "Spanquerschnitt",
    residual: "Restmaterial",
    none: "keins",
    unknown: "–",
    waiting: "Mit diesen Werten entsteht keine Bahn; gezeigt wird die letzte gültige Simulation.",
    duration: (minutes, seconds) =>
      minutes < 60
        ? minutes > 0
          ? `${minutes} min ${seconds} s`
          : `${seconds} s`
        : `${Math.floor(minutes / 60)} h ${minutes % 60} min`,
    faults: "Konturverletzungen und Kollisionen",
    pin: {
      make: "Als Vergleich merken",
      title: "Vergleichsstand",
      pinned: "Vergleich",
      now: "Jetzt",
      back: "Vergleichsstand laden",
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
      "Darstellung wie im Handbuch gedruckt, ohne ~. Eine Steuerung lädt diese Form nicht; Kopieren und Herunterladen liefern die Datei.",
    showFile: "Datei zeigen",
    untied: "Zykluslisten ohne ~: Die Steuerung lädt dieses Programm nicht.",
    tie: "~ ergänzen",
    isoKept: (blocks) => `Ohne DIN/ISO-Wort, bleibt Klartext: ${blocks}.`,
    isoUnverified: "Reihenfolge der Wörter im Satz nicht geprüft; an der Steuerung vergleichen.",
    output: "NC-Ausgabe",
    asIso: "DIN/ISO-Datei",
    language: "Texte",
    languageLong: "Sprache des Programmtexts",
    noChinese: "Kein bekanntes Handbuch druckt chinesische Texte; das chinesische TNC7-Handbuch hat englische.",
    copy: "Kopieren",
    copyLong: "Programm kopieren",
    copied: "Kopiert",
    copiedLong: (blocks) => `Programm in die Zwischenablage kopiert: ${blocks} Sätze.`,
    download: (file) => `${file} herunterladen`,
    fold: "Programm einklappen",
    unfold: "Programm zeigen",
    exportMenu: "Exportieren",
    setupSheet: "Einrichteblatt",
    clamping: "Werkstoff, Spannung",
    workshopDrawing: "Werkstattzeichnung",
    handOn: "Teilen",
    exportPart: "Teil exportieren",
    turnRound: "Umspannen",
    makeTask: "Aufgabe erstellen",
    compare: "Vergleichen",
    blocks: "Sätze des Programms",
    running: "läuft",
    refusedTitle: "Von Hand kopieren",
    refused:
      "Der Browser erlaubt keinen Zugriff auf die Zwischenablage. Der Text unten ist markiert: Strg+C drücken oder gedrückt " +
      "halten und „Kopieren“ wählen.",
    incomplete: "Programm unvollständig",
  },

  notice: {
    dismiss: "Ausblenden",
    damaged: (n) =>
      n === 1
        ? "Ein gespeichertes Programm war nicht lesbar. Es wurde separat abgelegt, nichts wurde gelöscht."
        : `${n} gespeicherte Programme waren nicht lesbar. Sie wurden separat abgelegt, nichts wurde gelöscht.`,
    notKept:
      "Dieser Browser speichert nichts auf dem Gerät. Das Programm vor dem Schließen kopieren oder herunterladen.",
    storageFull:
      "Der Gerätespeicher ist voll: Die letzten Änderungen sind nicht gespeichert. Das Programm herunterladen oder auf der Startseite Programme entfernen.",
    storageSilent:
      "Der Speicher des Browsers antwortet nicht. Weiterarbeiten ist möglich, Änderungen bestehen aber nur auf dieser Seite, bis er antwortet: Das Programm vor dem Schließen herunterladen.",
    newerData:
      "Einige Daten auf diesem Gerät hat eine neuere Version dieser Seite gespeichert. Sie bleiben unverändert, und Änderungen daran werden nicht gespeichert. Die Seite neu laden, um diese Version zu erhalten.",
    rowsAside:
      "Einige Einträge Ihrer Tabellen waren nicht lesbar. Sie wurden zurückgelegt: siehe die Seite aller Programme. Nichts wurde gelöscht.",
    rowUnreadable: (name) => `${name} kann nicht angezeigt werden.`,
    newerWorks:
      "Einige gespeicherte Programme stammen aus einer neueren Version dieser Seite. Sie stehen unter der Liste aller Programme; nichts wurde gelöscht.",
    downloadUnkept: "Programm herunterladen",
    archiveUnkept: "In einer Datei sichern",
    copyOfOtherTab:
      "Dieses Programm ist in einem anderen Tab offen. Hier wird eine Kopie bearbeitet; beide bleiben erhalten.",
    workNotHere:
      "Das Programm dieser Adresse ist nicht auf diesem Gerät: anderer Browser, oder aus der Liste entfernt.",
    linkDamaged: "Der Link enthält keine lesbaren Daten.",
    linkNewer:
      "Der Link stammt aus einer neueren Version dieser Seite. Die Seite neu laden und den Link erneut öffnen.",
    linkTooLarge:
      "Das Programm im Link ist größer als 20 MB und wurde nicht geöffnet. Das eigene Programm ist unverändert.",
    fileTooLarge: "Die Datei ist größer als 20 MB und wurde nicht geöffnet. Das eigene Programm ist unverändert.",
    fileUnreadable: "Die Datei war nicht lesbar und wurde nicht geöffnet. Das eigene Programm ist unverändert.",
    engineFailed:
      "Die Berechnung wurde unerwartet abgebrochen. Die Werte bleiben erhalten; die Berechnung lässt sich neu starten.",
    toolsDamaged:
      "Die gespeicherte Werkzeugtabelle war nicht lesbar. Sie wurde separat abgelegt; es gelten die Standardwerkzeuge.",
    filesLeftOut:
      "Nicht alle Dateien des Ordners wurden geöffnet: Dateien ohne Programmtext oder über der Höchstzahl wurden ausgelassen.",
    isoRead: "Das DIN/ISO-Programm wurde zum Bearbeiten in Klartext umgewandelt. „DIN/ISO-Datei“ wandelt es zurück.",
    mainUnsure:
      "Kein Programm hier ruft alle anderen auf. Um ein anderes auszuführen, dieses in der Dateiliste über dem Text wählen.",
    toolsNotKept:
      "Dieser Browser speichert die Werkzeugtabelle nicht auf dem Gerät. Die Tabelle vor dem Schließen der Seite exportieren.",
    ownDamaged:
      "Die gespeicherten eigenen Zyklen waren nicht lesbar. Sie wurden separat abgelegt, nichts wurde gelöscht.",
    ownNotKept:
      "Dieser Browser speichert die eigenen Zyklen nicht auf dem Gerät. Die Zyklen vor dem Schließen der Seite exportieren.",
    crashTitle: "Auf dieser Seite ist ein Fehler aufgetreten",
    crash: "Das Programm ist auf diesem Gerät gespeichert.",
    missing: {
      offline:
        "Dieser Teil der Seite konnte nicht geladen werden: kein Netz. Geöffnete Programme bleiben erhalten; der Teil wird geladen, sobald ein Netz da ist.",
      gone: "Dieser Teil der Seite konnte nicht vom Server geladen werden. Geöffnete Programme bleiben erhalten, auch beim Neuladen der Seite.",
    },
    tryAgain: "Erneut versuchen",
    reload: "Seite neu laden",
    startOver: "Zur Startseite",
  },
} satisfies PageTexts;
