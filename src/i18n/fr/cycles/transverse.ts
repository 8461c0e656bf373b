import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const transverse = {
  820: {
    name: "Contour transversal",
    summary: "Tourne un contour libre d'un sous-programme, dans le sens transversal.",
    description: [
      "Tourne un contour quelconque en travers de l'axe. Le contour est un sous-programme de droites, d'arrondis, de chanfreins "
      + "et d'arcs, désigné par le cycle 14 ou par SEL CONTOUR.",
      "Ébauche en passes paraxiales, finition, ou les deux. Premier point du contour plus grand en X que le dernier : usinage "
      + "extérieur. Plus petit : usinage intérieur.",
      "Si le Z du point de départ est sous le départ du contour, l'outil va d'abord en Z au départ du contour ; pour la "
      + "finition, à la distance d'approche.",
    ],
    rough: [
      "prise de passe paraxiale en rapide",
      "coupe transversale à l'avance d'ébauche",
      "retrait de la valeur de passe",
      "retour au début de la coupe en rapide",
      "répéter jusqu'au contour",
      "retour au départ du cycle en rapide",
    ],
    finish: [
      "prise de passe en rapide",
      "finition du contour, du départ à la fin",
      "retrait de la distance d'approche",
      "retour au départ du cycle en rapide",
    ],
    notes: [
      "Risque de collision : la limite d'usinage restreint le contour usiné, mais l'approche et la sortie peuvent la franchir. "
      + "Placer l'outil, avant l'appel, du côté de la limite qui doit être usiné.",
      turnMode,
      safePosition,
      "La forme de la plaquette est prise en compte pour ne blesser aucun élément. Ce que l'outil n'atteint pas reste, avec un "
      + "avertissement.",
      "Le cycle 14 avec le label du contour, ou SEL CONTOUR avec son fichier, doit précéder l'appel.",
      "Les paramètres locaux (QL) du contour doivent être affectés dans le sous-programme lui-même.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
