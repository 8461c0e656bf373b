import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const longitudinal = {
  812: {
    name: "Épaulement longitudinal étendu",
    summary: "Tourne un épaulement dans le sens longitudinal, avec chanfreins, angles et rayon de coin.",
    description: [
      "Tourne un épaulement le long de l'axe. Les arêtes au départ et à la fin du contour peuvent recevoir un chanfrein ou un "
      + "arrondi, le pourtour et la face peuvent être inclinés, le coin intérieur peut être arrondi.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. "
      + "Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l'outil va d'abord en X, puis en Z, à la distance d'approche ; "
      + "pour la finition, d'abord en Z.",
    ],
    rough: [
      "prise de passe paraxiale en rapide",
      "coupe longitudinale à l'avance d'ébauche",
      "retrait de la valeur de passe",
      "retour au début de la coupe en rapide",
      "répéter jusqu'au contour",
      "retour au départ du cycle en rapide",
    ],
    finish: [
      "prise de passe paraxiale en rapide",
      "finition du contour, du départ à la fin",
      "retrait de la distance d'approche",
      "retour au départ du cycle en rapide",
    ],
    notes: [turnMode, safePosition, edgeLength],
  },
} satisfies CycleTexts;
