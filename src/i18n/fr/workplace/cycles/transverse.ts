import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "prise de passe paraxiale en rapide",
  "coupe transversale, avance d’ébauche",
  "retrait de la valeur de passe",
  "retour au début de la coupe en rapide",
  "répéter jusqu’au contour",
  "retour au départ du cycle en rapide",
];
const finish = [
  "prise de passe en rapide",
  "finition du contour, du départ à la fin",
  "retrait de la distance d’approche",
  "retour au départ du cycle en rapide",
];
/** Of the cycles that have a contour of their own. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "Contour transversal",
    summary: "Tourne un contour libre d’un sous-programme, dans le sens transversal.",
    description: [
      "Tourne un contour quelconque en travers de l’axe. Le contour est un sous-programme de droites, d’arrondis, de chanfreins " +
        "et d’arcs, désigné par le cycle 14 ou par SEL CONTOUR.",
      "Ébauche en passes paraxiales, finition, ou les deux. Premier point du contour plus grand en X que le dernier : usinage " +
        "extérieur. Plus petit : usinage intérieur.",
      "Si le Z du point de départ est sous le départ du contour, l’outil va d’abord en Z au départ du contour ; pour la " +
        "finition, à la distance d’approche.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "Épaulement transversal",
    summary: "Dresse un épaulement droit en travers de l’axe, depuis la position de l’outil.",
    description: [
      "Tourne une face et le cylindre qui la termine. La position de l’outil à l’appel est un coin de la zone à usiner, la " +
        "fin programmée est l’autre ; il n’y a ni angle ni arête cassée.",
      "Ébauche en passes transversales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : usinage " +
        "extérieur. Plus près : usinage intérieur.",
    ],
    ...own,
  },
  822: {
    name: "Épaulement transversal étendu",
    summary: "Dresse un épaulement en travers de l’axe, avec chanfreins, angles et rayon de coin.",
    description: [
      "Tourne un épaulement en travers de l’axe. Les arêtes au départ et à la fin du contour peuvent recevoir un chanfrein " +
        "ou un arrondi, la face et le pourtour peuvent être inclinés, le coin intérieur peut être arrondi.",
      "Ébauche en passes transversales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en Z, puis en X, à la distance d’approche.",
    ],
    ...own,
  },
  823: {
    name: "Tournage en plongée transversal",
    summary: "Descend derrière un flanc dans une face, en travers de l’axe.",
    description: [
      "Tourne dans une face une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un fond, puis " +
        "jusqu’à une paroi droite à la fin.",
      "Ce qui se trouve à côté du départ du contour reste, dans le plan de Q492. Notre lecture ; à vérifier sur la commande.",
      "Ébauche en passes transversales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en Z, puis en X, à la distance d’approche à " +
        "côté du départ du contour.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "Tournage en plongée transversal étendu",
    summary: "Descend derrière un flanc dans une face, avec arêtes cassées, rayons de coin et paroi inclinée.",
    description: [
      "Tourne dans une face une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un fond, puis en " +
        "remontant une paroi à la fin. Les arêtes des deux extrémités peuvent recevoir un chanfrein ou un arrondi, les deux " +
        "coins du fond peuvent être arrondis et la paroi peut être inclinée.",
      "Ce qui se trouve à côté du départ du contour reste, dans le plan de Q492. Notre lecture ; à vérifier sur la commande.",
      "Ébauche en passes transversales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en Z, puis en X, à la distance d’approche à " +
        "côté du départ du contour.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
