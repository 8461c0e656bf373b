import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "Limite de profondeur de plongée?",
    printed: false,
    label: "Limite de profondeur",
    explanation:
      "Plus grande profondeur d’une prise. Une plongée plus profonde est divisée en parts égales ; entre deux, l’outil " +
      "recule de 0,5 mm pour briser le copeau. 0 : en une fois. Notre lecture ; à vérifier sur la commande.",
  },
  recessingOverlap: {
    prompt: "Recouvrement en plongée?",
    printed: false,
    label: "Recouvrement",
    explanation:
      "Décalage latéral d’une plongée à la suivante, en part de CUTWIDTH. Les pas sont égaux, de sorte que la dernière " +
      "plongée est à l’autre paroi. En peigne, c’est la largeur d’une nervure.",
  },
  solidFeed: {
    prompt: "Facteur d'avance en pleine matière?",
    printed: false,
    label: "Avance en plein",
    explanation:
      "Avance d’une plongée en pleine matière, en pour cent de l’avance d’ébauche Q478. À côté d’une plongée qu’elle " +
      "recouvre, elle va à l’avance entière.",
  },
  retraction: {
    prompt: "Mode de retrait (0/1)?",
    printed: false,
    label: "Retrait",
    explanation: "Comment l’outil quitte une plongée. Notre lecture ; à vérifier sur la commande.",
    choices: { 0: "droit, le long du contour", 1: "d’abord en biais, loin du flanc, puis dehors" },
  },
  dwellTurns: {
    prompt: "Temporisation en tours?",
    printed: false,
    label: "Temporisation",
    explanation: "Combien de tours fait la broche pendant que l’outil reste au fond d’une plongée, avant le retrait.",
  },
  combRecessing: {
    prompt: "Gorge en peigne (0/1)?",
    printed: false,
    label: "Peigne",
    explanation: "L’ordre des plongées.",
    choices: {
      0: "chacune à côté de la précédente, en recouvrement",
      1: "d’abord des coupes pleines, puis les nervures entre elles",
    },
  },
} satisfies SomeParamTexts;
