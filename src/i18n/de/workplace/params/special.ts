import type { SomeParamTexts } from "../../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Aufmaß Rohteil?",
    printed: false,
    label: "Aufmaß Rohteil",
    explanation:
      "Was vor dem Zyklus auf der Kontur steht, überall senkrecht zu ihr gemessen, auch an Planflächen. " +
      "Unsere Auslegung; an der Steuerung prüfen.",
  },
  cuttingLines: {
    prompt: "Art der Schnittlinien (0/1)?",
    printed: false,
    label: "Schnittlinien",
    explanation: "Wie das Aufmaß in Schnitte aufgeteilt wird.",
    choices: {
      0: "konstanter Spanquerschnitt: längere Schnitte sind dünner, jeder nimmt dieselbe Fläche",
      1: "äquidistant: jeder Schnitt gleich dick",
    },
  },
  infeedParallel: {
    prompt: "Maximale Schnitttiefe?",
    printed: false,
    label: "Max. Zustellung",
    explanation: "Größte Zustellung je Schnitt, senkrecht zur Kontur gemessen. 0: alles in einem Schnitt.",
  },
  precessionAngle: {
    prompt: "Präzessionswinkel?",
    printed: false,
    label: "Präzessionswinkel",
    explanation:
      "Dreht das Koordinatensystem um die Spindelachse Z. Stehen beide Spindeln parallel, ist jeder Winkel möglich, sonst sind nur " +
      "zwei Winkel sinnvoll.",
  },
  reverseTool: {
    prompt: "Werkzeug umkehren (0=nein/1=ja)?",
    printed: false,
    label: "Werkzeug umkehren",
    explanation: "Dreht das Werkzeug um seine Achse um; die Schneide liegt dann gespiegelt.",
    choices: { 0: "wie es steht", 1: "um 180° gedreht" },
  },
  inclinedMachining: {
    prompt: "Angestellte Bearbeitung (0/1/2/3)?",
    printed: false,
    label: "Angestellte Bearbeitung",
    explanation: "Wie die Schwenkachsen auf den Anstellwinkel fahren.",
    choices: {
      0: "Schwenkachsen stehen bereits: Das Koordinatensystem folgt ihnen; die Steuerung verlangt M144 oder M128/TCPM",
      1: "Schwenkachsen positionieren, mit Ausgleichsbewegung der Werkzeugspitze",
      2: "Schwenkachsen positionieren, ohne Ausgleichsbewegung",
      3: "Achswinkel nur berechnen (Q120, Q121, Q122), ohne Bewegung; danach die Schwenkachsen positionieren",
    },
  },
  incidenceAngle: {
    prompt: "Anstellwinkel?",
    printed: false,
    label: "Anstellwinkel",
    explanation: "Winkel, um den das Werkzeug gegen das Werkstück angestellt ist.",
  },
  tiltingFeed: {
    prompt: "Vorschub Positionieren?",
    printed: false,
    label: "Vorschub Positionieren",
    explanation: "Vorschub, mit dem die Schwenkachsen fahren, in mm/min.",
  },
  preferredDirection: {
    prompt: "Vorzugsrichtung Anstellwinkel?",
    printed: false,
    label: "Vorzugsrichtung",
    explanation: "Welche von mehreren Stellungen der Schwenkachsen genommen wird.",
    choices: {
      0: "die nächste",
      1: "zwischen 0° und +180°",
      2: "zwischen +90° und +180°",
      [-2]: "zwischen −90° und −180°",
      [-1]: "zwischen 0° und −180°",
    },
  },
  eccentricTurning: {
    prompt: "Exzentrisches Drehen (0-3)?",
    printed: false,
    label: "Exzentrisches Drehen",
    explanation:
      "Koppelt die Achsen zum Drehen außerhalb der Tischmitte. Andere Werte als 0 und 3 bleiben im Programm, sind aber nicht geprüft.",
    choices: {
      0: "Kopplungen aus",
      1: "Kopplungen ein, Drehung um den Bezugspunkt",
      2: "Kopplungen ein, Drehung um den Nullpunkt",
      3: "Kopplungen lassen, wie sie sind",
    },
  },
  eccentricWithoutStop: {
    prompt: "Exzentrisches Drehen ohne Stopp (0/1)?",
    printed: false,
    label: "Exzentrisch ohne Stopp",
    explanation: "Ob das Programm vor dem exzentrischen Drehen anhält.",
    choices: { 0: "erst anhalten", 1: "ohne Stopp" },
  },
} satisfies SomeParamTexts;
