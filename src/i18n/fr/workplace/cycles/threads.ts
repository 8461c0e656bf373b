import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const steps = [
  "avance rapide à la distance d’approche et à la profondeur de la passe",
  "filetage, avance synchronisée avec la broche",
  "retrait de la distance d’approche en avance rapide",
  "retour en avance rapide, prise de passe selon Q467",
  "répéter jusqu’à la profondeur",
  "passes à vide à la profondeur finie",
  "de même pour le filet suivant",
  "retour au départ du cycle en avance rapide",
];
const thread = [
  "Chaque passe va de l’engagement à la fin du filetage, synchronisée avec la broche ; entre les passes, l’outil " +
    "revient en avance rapide. À section de copeau constante, la profondeur croît comme la racine carrée du numéro " +
    "de passe.",
  "Le diamètre nominal est le sommet d’un filetage extérieur et le fond d’un filetage intérieur. L’usinage va du " +
    "Z de départ au Z de fin ; ce sens et le sens de rotation de la broche déterminent un filetage à droite ou à " +
    "gauche.",
];
const notes = [
  turnMode,
  safePosition,
  "Le potentiomètre d’avance est sans effet pendant le filetage.",
  "L’outil est de TYPE THREAD et sa pointe est perpendiculaire à la matière.",
];

export const threads = {
  830: {
    name: "Filetage parallèle au contour",
    summary: "Usine un filetage le long d’un contour libre.",
    description: [
      ...thread,
      "Le contour est la ligne du diamètre nominal ; il doit avancer dans un seul sens le long de l’axe " +
        "synchronisé. Les arcs sont usinés en cordes. Le cycle 14 sélectionne le contour.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  831: {
    name: "Filetage longitudinal",
    summary: "Usine un filetage sur un cylindre, extérieur ou intérieur.",
    description: [...thread, "L’engagement est la distance d’approche Q460, le dépassement un tour de broche."],
    rough: steps,
    finish: [],
    notes,
  },
  832: {
    name: "Filetage étendu",
    summary:
      "Usine un filetage sur un cylindre, un cône ou une face, avec courses d’engagement et de dépassement propres.",
    description: [...thread, "Le cône est donné par deux points ou par un point et un angle (Q464)."],
    rough: steps,
    finish: [],
    notes,
  },
} satisfies CycleTexts;
