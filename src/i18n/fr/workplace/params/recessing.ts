import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "Limite de profondeur de plongée?",
    printed: false,
    label: "Limite de profondeur",
    explanation:
      "Profondeur maximale par passe. Une plongée plus profonde est répartie uniformément ; entre deux passes, " +
      "l’outil recule de 0,5 mm pour briser le copeau. 0 : en une passe.",
  },
  recessingOverlap: {
    prompt: "Recouvrement en plongée?",
    printed: false,
    label: "Recouvrement",
    explanation:
      "Décalage latéral d’une plongée à la suivante, en facteur de CUTWIDTH. Les décalages sont répartis " +
      "uniformément, la dernière plongée est à l’autre paroi. Pour le plongeage en peigne : largeur d’une " +
      "nervure.",
  },
  solidFeed: {
    prompt: "Facteur d'avance en pleine matière?",
    printed: false,
    label: "Avance en plein",
    explanation:
      "Avance d’une plongée en pleine matière, en pour cent de l’avance d’ébauche Q478. Une plongée qui recouvre " +
      "la précédente se fait à l’avance entière.",
  },
  retraction: {
    prompt: "Mode de retrait (0/1)?",
    printed: false,
    label: "Retrait",
    explanation: "Comment l’outil quitte une plongée.",
    choices: { 0: "droit, le long du contour", 1: "d’abord en biais, à l’écart du flanc, puis vers l’extérieur" },
  },
  dwellTurns: {
    prompt: "Temporisation en tours?",
    printed: false,
    label: "Temporisation",
    explanation: "Tours de broche pendant lesquels l’outil reste au fond d’une plongée avant le retrait.",
  },
  combRecessing: {
    prompt: "Gorge en peigne (0/1)?",
    printed: false,
    label: "Peigne",
    explanation: "Ordre des plongées.",
    choices: {
      0: "chacune à côté de la précédente, en recouvrement",
      1: "d’abord des coupes pleines, puis les nervures intermédiaires",
    },
  },
} satisfies SomeParamTexts;
