import type { SomeParamTexts } from "../../../param-text.ts";

export const turning = {
  reverseAlong: {
    prompt: "Inverser contour (0-2)?",
    printed: false,
    label: "Inverser contour",
    explanation: "Sens dans lequel le contour est usiné.",
    choices: {
      0: "sens programmé",
      1: "sens inverse",
      2: "sens inverse, pointe inversée dans le sens d’avance (l’orientation 1 usine comme 3)",
    },
  },
  flankAngleRadial: {
    prompt: "Angle du flanc?",
    printed: false,
    label: "Angle du flanc",
    explanation:
      "Angle entre le flanc au départ du contour et la perpendiculaire à l’axe rotatif. La gorge se resserre " +
      "vers le fond.",
  },
  secondFlankAngleRadial: {
    prompt: "Angle du deuxième flanc?",
    printed: false,
    label: "Angle du 2e flanc",
    explanation: "Angle entre le flanc en fin de contour et la perpendiculaire à l’axe rotatif.",
  },
  infeedFace: {
    prompt: "Plongée max.?",
    printed: false,
    label: "Passe max.",
    explanation:
      "Passe maximale, en Z. La profondeur est répartie uniformément : la passe réelle est souvent plus petite, sans " +
      "dernière passe trop mince.",
  },
  infeedContour: {
    prompt: "Plongée max.?",
    printed: false,
    label: "Passe max.",
    explanation:
      "Passe maximale, au rayon. La profondeur est répartie uniformément : la passe réelle est souvent plus petite, " +
      "sans dernière passe trop mince. 0 : une seule passe.",
  },
  plungeAngle: {
    prompt: "Angle du flanc?",
    printed: false,
    label: "Angle du flanc",
    explanation:
      "Angle entre le flanc au départ du contour et la perpendiculaire à l’axe rotatif. Le flanc descend du " +
      "départ du " +
      "contour dans la zone à usiner, jamais derrière l’arête.",
  },
  plungeAngleFace: {
    prompt: "Angle du flanc?",
    printed: false,
    label: "Angle du flanc",
    explanation:
      "Angle entre le flanc au départ du contour et la parallèle à l’axe rotatif. Le flanc descend du départ du " +
      "contour " +
      "dans la zone à usiner, jamais derrière l’arête.",
  },
} satisfies SomeParamTexts;
