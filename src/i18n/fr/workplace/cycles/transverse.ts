import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "prise de passe paraxiale en avance rapide",
  "coupe transversale, avance d’ébauche",
  "retrait de la valeur de passe",
  "retour au début de la coupe en avance rapide",
  "répéter jusqu’au contour fini",
  "retour au départ du cycle en avance rapide",
];
const finish = [
  "prise de passe en avance rapide",
  "finition du contour, du départ à la fin",
  "retrait de la distance d’approche",
  "retour au départ du cycle en avance rapide",
];
/** Steps and notes of the cycles that describe the contour by parameters. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "Contour transversal",
    summary: "Tourne un contour libre d’un sous-programme, dans le sens transversal.",
    description: [
      "Tourne un contour quelconque dans le sens transversal. Le contour est un sous-programme de droites, " +
        "d’arrondis, de chanfreins et d’arcs, sélectionné par le cycle 14 ou SEL CONTOUR.",
      "Ébauche en passes paraxiales, finition, ou les deux. Départ du contour supérieur à la fin en X : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si la coordonnée Z du point de départ est inférieure au départ du contour, l’outil va d’abord en Z au " +
        "départ du contour ; pour la " +
        "finition, à la distance d’approche.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "Épaulement transversal",
    summary: "Dresse un épaulement droit dans le sens transversal, depuis la position de l’outil.",
    description: [
      "Tourne une face et le cylindre qui la termine. La position de l’outil à l’appel est un coin de la zone à " +
        "usiner, la fin programmée est l’autre, sans angle, chanfrein ni arrondi.",
      "Ébauche en passes transversales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : usinage " +
        "extérieur. Plus près : usinage intérieur.",
    ],
    ...own,
  },
  822: {
    name: "Épaulement transversal étendu",
    summary: "Dresse un épaulement dans le sens transversal, avec chanfreins, angles et rayon de coin.",
    description: [
      "Tourne un épaulement dans le sens transversal. Les arêtes au départ et à la fin du contour peuvent avoir " +
        "un chanfrein ou un arrondi, la face transversale et la surface périphérique peuvent être inclinées, le " +
        "coin intérieur peut être arrondi.",
      "Ébauche en passes transversales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : " +
        "usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en Z, puis en X, à la distance " +
        "d’approche.",
    ],
    ...own,
  },
  823: {
    name: "Tournage en plongée transversal",
    summary: "Descend derrière un flanc dans une face, dans le sens transversal.",
    description: [
      "Tourne dans une face une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un " +
        "fond, puis " +
        "jusqu’à une paroi perpendiculaire à la fin.",
      "La matière à côté du départ du contour n’est pas usinée ; elle reste dans le plan de Q492.",
      "Ébauche en passes transversales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : " +
        "usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en Z, puis en X, à la distance " +
        "d’approche à " +
        "côté du départ du contour.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "Tournage en plongée transversal étendu",
    summary: "Descend derrière un flanc dans une face, avec chanfreins, rayons et paroi inclinée.",
    description: [
      "Tourne dans une face une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un " +
        "fond, puis en " +
        "remontant une paroi à la fin. Les arêtes des deux extrémités peuvent avoir un chanfrein ou un arrondi, " +
        "les deux " +
        "coins du fond peuvent être arrondis et la paroi peut être inclinée.",
      "La matière à côté du départ du contour n’est pas usinée ; elle reste dans le plan de Q492.",
      "Ébauche en passes transversales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : " +
        "usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en Z, puis en X, à la distance " +
        "d’approche à " +
        "côté du départ du contour.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
