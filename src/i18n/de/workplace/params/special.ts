import type { SomeParamTexts } from "../../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Aufmaß Rohteil?",
    printed: false,
    label: "Aufmaß Rohteil",
    explanation: "Aufmaß auf der Kontur vor dem Zyklus, senkrecht zur Kontur gemessen, auch an Planflächen.",
  },
  cuttingLines: {
    prompt: "Art der Schnittlinien (0/1)?",
    printed: false,
    label: "Schnittlinien",
    explanation: "Wie das Aufmaß in Schnitte aufgeteilt wird.",
    choices: {
      0: "konstanter Spanquerschnitt: längere Schnitte sind dünner, jeder trägt dieselbe Fläche ab",
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
      "Dreht das Koordinatensystem um die Spindelachse Z. Stehen beide Spindeln parallel, ist jeder Winkel " +
      "möglich, sonst sind nur " +
      "zwei Winkel sinnvoll.",
  },
  reverseTool: {
    prompt: "Werkzeug umkehren (0=nein/1=ja)?",
    printed: false,
    label: "Werkzeug umkehren",
    explanation: "Dreht das Werkzeug um 180° um seine Achse; die Schneide ist dann gespiegelt.",
    choices: { 0: "nicht umgekehrt", 1: "um 180° gedreht" },
  },
  inclinedMachining: {
    prompt: "Angestellte Bearbeitung (0/1/2/3)?",
    printed: false,
    label: "Angestellte Bearbeitung",
    explanation: "Wie die Schwenkachsen den Anstellwinkel erreichen.",
    choices: {
      0:
        "Schwenkachsen sind bereits positioniert: Das Koordinatensystem folgt ihnen; die Steuerung verlangt M144 " +
        "oder M128/TCPM",
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
    explanation: "Welche von mehreren möglichen Stellungen die Schwenkachsen anfahren.",
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
      "Koppelt die Achsen zum Drehen außerhalb der Tischmitte. Andere Werte als 0 und 3 bleiben im Programm, " +
      "sind aber nicht geprüft.",
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
