import type { CourseTexts } from "../en/course.ts";

export const course = {
  title: "Kurs",
  lead:
    "Drehen mit den Zyklen der Steuerung, vom ersten Absatz bis zum fertigen Teil. Jede Lektion hat einige Seiten mit animiertem Bild und " +
    "Aufgaben im echten Editor.",
  entrance: {
    name: "Lernen",
    about: "Lektionen mit Aufgaben, vom ersten Absatz bis zum fertigen Teil",
    goOn: (lesson) => `Weiter mit Lektion ${lesson}`,
  },
  lessons: "Lektionen",
  lesson: (n) => `Lektion ${n}`,
  openLesson: (n, title) => `Lektion ${n}, ${title}`,
  begin: (n) => `Mit Lektion ${n} beginnen`,
  goOn: (n, title) => `Weiter: Lektion ${n}, ${title}`,
  passed: (n, of) => `${n} von ${of} Aufgaben gelöst`,
  read: "gelesen",
  states: {
    new: "nicht begonnen",
    tried: "versucht",
    alone: "ohne Hilfe gelöst",
    hints: "mit Tipps gelöst",
    solution: "mit gezeigter Lösung gelöst",
  },
  kinds: { make: "Programmieren", fault: "Fehler finden", predict: "Vorhersagen", drawing: "Nach Zeichnung" },

  missing: "Diese Lektion gehört nicht zum Kurs.",
  toList: "Alle Lektionen",
  pages: "Seiten der Lektion",
  page: (n) => `Seite ${n}`,
  pageOf: (n, of) => `Seite ${n} von ${of}`,
  tasks: "Aufgaben",
  previous: "Zurück",
  next: "Weiter",
  toTasks: "Zu den Aufgaben",
  nextLesson: (n, title) => `Nächste Lektion: ${n}, ${title}`,
  example: "Beispiel im Editor öffnen",
  exampleLead:
    "Das Programm dieser Lektion, um Werte auszuprobieren. Ihre Programme bleiben erhalten; Zurück führt wieder hierher.",
  noTasksYet: "Diese Lektion hat keine Aufgaben.",

  picture: {
    name: "Bild der Lektion",
    working: "Das Bild wird berechnet.",
    failed: "Das Bild konnte nicht berechnet werden.",
    play: "Wiedergabe",
    pause: "Pause",
    first: "An den Anfang",
    back: "Vorige Bewegung",
    forward: "Nächste Bewegung",
    scrub: "Position der Wiedergabe",
    program: "Das Programm zum Bild",
    openProgram: "Dieses Programm im Editor öffnen",
  },

  question: {
    name: "Frage",
    check: "Prüfen",
    checking: "Wird geprüft …",
    right: "Richtig.",
    wrong: "Noch nicht.",
    half: "Das ist die Hälfte: ein Radius?",
    twice: "Das ist das Doppelte: ein Durchmesser?",
    shown: "Das Bild zeigt jetzt diesen Fall.",
    failed: "Die Antwort konnte nicht geprüft werden. Versuchen Sie es noch einmal.",
    lacks: "Geben Sie eine Zahl ein.",
    answered: "Beantwortet",
    yours: "Ihre Antwort",
  },

  restart: "Kurs neu beginnen",
  cancel: "Abbrechen",
  restarted: "Der Kurs wurde neu begonnen. Rückgängig stellt Ihren Lernstand wieder her.",
  damaged: "Ihr Lernstand war nicht lesbar. Die beschädigten Daten wurden beiseitegelegt, der Kurs beginnt neu.",
  notKept:
    "Dieser Browser speichert Ihren Lernstand nicht. Sichern Sie Ihre Daten in den Einstellungen, bevor Sie die Seite schließen.",
} satisfies CourseTexts;
