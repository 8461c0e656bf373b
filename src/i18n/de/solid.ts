import type { SolidTexts } from "../en/solid.ts";

export const solid: SolidTexts = {
  title: "3D-Ansicht",
  picture: (cut, state) => `Der Drehkörper in 3D${cut ? ", ein Viertel weggeschnitten" : ""}, Z nach rechts. ${state}`,
  keys:
    "Pfeiltasten drehen die Ansicht, mit Umschalt verschieben sie; Plus und Minus zoomen, 0 zeigt alles; " +
    "1, 2 und 3 sind die Ansichten schräg, von vorn und auf die Planfläche.",
  views: "Ansichten",
  quarter: "Ein Viertel wegschneiden",
  quarterShort: "Viertel",
  iso: "Schräg",
  front: "Von vorn",
  end: "Auf die Planfläche",
  threads: "Die Gewinde sind hier als Ringe gezeichnet, ohne Steigung.",
  left: "Linksgewinde: M4, oder der Vorschub läuft vom Futter weg.",
  milled: "Gefrästes ist nicht in diesem Körper: siehe Arbeitsebene.",
  noBlank: "Kein Rohteil angegeben: Nur der Weg ist zu sehen.",
  surfaces: "Oberflächen",
  textures: { raw: "roh", rough: "geschruppt", thread: "Gewinde", finished: "geschlichtet" },
  marked: { residual: "Restmaterial", gouge: "Konturverletzung, Kollision" },
  missing: "Dieser Browser zeigt hier kein 3D: Er hat kein WebGL. An seiner Stelle steht der Schnitt.",
  lost: "Die Grafikkarte wurde entzogen. Bis 3D wieder da ist, steht hier der Schnitt.",
  again: "3D nochmals versuchen",
};
