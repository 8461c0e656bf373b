import type { SomeParamTexts } from "../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Surépaisseur du brut?",
    printed: false,
    label: "Surépaisseur brut",
    explanation: "Ce qui se trouve sur le contour avant le cycle, mesuré partout perpendiculairement à lui, aussi sur les faces. "
      + "Notre lecture ; à vérifier sur la commande.",
  },
  cuttingLines: {
    prompt: "Type de lignes de coupe (0/1)?",
    printed: false,
    label: "Lignes de coupe",
    explanation: "Comment la surépaisseur est divisée en passes.",
    choices: {
      0: "section de copeau constante : les passes plus longues sont plus minces, chacune prend la même aire",
      1: "équidistantes : toutes les passes de même épaisseur",
    },
  },
  infeedParallel: {
    prompt: "Plongée max.?",
    printed: false,
    label: "Plongée max.",
    explanation: "Le plus qu'une passe enlève, mesuré perpendiculairement au contour. 0 : tout en une passe.",
  },
} satisfies SomeParamTexts;
