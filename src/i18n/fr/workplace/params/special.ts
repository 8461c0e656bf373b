import type { SomeParamTexts } from "../../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Surépaisseur du brut?",
    printed: false,
    label: "Surépaisseur brut",
    explanation:
      "Surépaisseur sur le contour avant le cycle, mesurée perpendiculairement au contour, aussi sur les faces.",
  },
  cuttingLines: {
    prompt: "Type de lignes de coupe (0/1)?",
    printed: false,
    label: "Lignes de coupe",
    explanation: "Comment la surépaisseur est divisée en passes.",
    choices: {
      0: "section de copeau constante : les passes plus longues sont plus minces, chacune enlève la même aire",
      1: "équidistantes : toutes les passes de même épaisseur",
    },
  },
  infeedParallel: {
    prompt: "Plongée max.?",
    printed: false,
    label: "Passe max.",
    explanation: "Passe maximale, mesurée perpendiculairement au contour. 0 : une seule passe.",
  },
  precessionAngle: {
    prompt: "Angle de précession?",
    printed: false,
    label: "Angle de précession",
    explanation:
      "Fait pivoter le système de coordonnées autour de l’axe de broche Z. Si les deux broches sont parallèles, " +
      "tout angle est possible ; " +
      "sinon, deux angles seulement conviennent.",
  },
  reverseTool: {
    prompt: "Inverser outil (0=non/1=oui)?",
    printed: false,
    label: "Inverser outil",
    explanation: "Tourne l’outil de 180° autour de son axe ; l’arête est alors en miroir.",
    choices: { 0: "non inversé", 1: "tourné de 180°" },
  },
  inclinedMachining: {
    prompt: "Usinage incliné (0/1/2/3)?",
    printed: false,
    label: "Usinage incliné",
    explanation: "Comment les axes inclinés atteignent l’angle d’inclinaison.",
    choices: {
      0: "axes déjà positionnés : le système de coordonnées les suit ; la commande demande M144 ou M128/TCPM",
      1: "positionner les axes, avec mouvement de compensation de la pointe",
      2: "positionner les axes, sans mouvement de compensation",
      3: "calculer seulement les angles des axes (Q120, Q121, Q122), sans mouvement ; positionner les axes ensuite",
    },
  },
  incidenceAngle: {
    prompt: "Angle d'inclinaison?",
    printed: false,
    label: "Angle d’inclinaison",
    explanation: "Angle dont l’outil est incliné par rapport à la pièce.",
  },
  tiltingFeed: {
    prompt: "Avance de positionnement?",
    printed: false,
    label: "Avance de positionnement",
    explanation: "Avance des axes inclinés, en mm/min.",
  },
  preferredDirection: {
    prompt: "Direction privilégiée angle incl.?",
    printed: false,
    label: "Direction privilégiée",
    explanation: "Laquelle des positions possibles les axes inclinés prennent.",
    choices: {
      0: "la plus proche",
      1: "entre 0° et +180°",
      2: "entre +90° et +180°",
      [-2]: "entre −90° et −180°",
      [-1]: "entre 0° et −180°",
    },
  },
  eccentricTurning: {
    prompt: "Tournage excentré (0-3)?",
    printed: false,
    label: "Tournage excentré",
    explanation:
      "Couple les axes pour tourner hors du centre de la table. Les valeurs autres que 0 et 3 sont conservées, " +
      "mais non vérifiées.",
    choices: {
      0: "couplages désactivés",
      1: "couplages activés, rotation autour du point d’origine",
      2: "couplages activés, rotation autour du point zéro",
      3: "couplages inchangés",
    },
  },
  eccentricWithoutStop: {
    prompt: "Tournage excentré sans arrêt (0/1)?",
    printed: false,
    label: "Excentré sans arrêt",
    explanation: "Si le programme s’arrête avant le tournage excentré.",
    choices: { 0: "arrêt d’abord", 1: "sans arrêt" },
  },
} satisfies SomeParamTexts;
