import type { SomeParamTexts } from "../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Aufmaß Rohteil?",
    printed: false,
    label: "Aufmaß Rohteil",
    explanation: "Was vor dem Zyklus auf der Kontur steht, überall senkrecht zu ihr gemessen, auch an Planflächen. "
      + "Unsere Auslegung; an der Steuerung prüfen.",
  },
  cuttingLines: {
    prompt: "Art der Schnittlinien (0/1)?",
    printed: false,
    label: "Schnittlinien",
    explanation: "Wie das Aufmaß in Schnitte geteilt wird.",
    choices: {
      0: "konstanter Spanquerschnitt: längere Schnitte sind dünner, jeder nimmt dieselbe Fläche",
      1: "äquidistant: jeder Schnitt gleich dick",
    },
  },
  infeedParallel: {
    prompt: "Maximale Schnitttiefe?",
    printed: false,
    label: "Max. Zustellung",
    explanation: "Das Meiste, was ein Schnitt nimmt, senkrecht zur Kontur gemessen. 0: alles in einem Schnitt.",
  },
} satisfies SomeParamTexts;
