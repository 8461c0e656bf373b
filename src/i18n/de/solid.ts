import type { SolidTexts } from "../en/solid.ts";

export const solid: SolidTexts = {
  title: "3D-Ansicht",
  picture: (cut, state) => `Das Drehteil in 3D${cut ? ", Viertelschnitt" : ""}, Z nach rechts. ${state}`,
  keys: "Pfeiltasten drehen die Ansicht, mit Umschalt verschieben sie; Plus und Minus zoomen, 0 zeigt alles; 1, 2 und 3 sind die Ansichten isometrisch, vorn und Planfläche.",
  views: "Ansichten",
  quarter: "Viertelschnitt",
  quarterShort: "Schnitt",
  iso: "Isometrisch",
  front: "Vorn",
  end: "Planfläche",
  threads: "Gewinde sind als Ringe gezeichnet, ohne Steigung.",
  left: "Linksgewinde: M4, oder Vorschub vom Futter weg.",
  milled: "Fräsbearbeitung fehlt in diesem Körper: siehe Bearbeitungsebene.",
  noBlank: "Kein Rohteil definiert: Nur die Bahn wird gezeigt.",
  surfaces: "Oberflächen",
  textures: { raw: "unbearbeitet", rough: "geschruppt", thread: "Gewinde", finished: "geschlichtet" },
  marked: { residual: "Restmaterial", gouge: "Konturverletzung, Kollision" },
  missing: "Dieser Browser kann hier kein 3D zeigen (kein WebGL). Stattdessen wird der Schnitt gezeigt.",
  lost: "Die Verbindung zur Grafikkarte ist unterbrochen. Bis 3D wieder da ist, wird der Schnitt gezeigt.",
  again: "3D erneut versuchen",
};
