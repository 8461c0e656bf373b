import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "prise de passe paraxiale en rapide",
  "coupe longitudinale, avance d’ébauche",
  "retrait de la valeur de passe",
  "retour au début de la coupe en rapide",
  "répéter jusqu’au contour",
  "retour au départ du cycle en rapide",
];
const finish = [
  "prise de passe paraxiale en rapide",
  "finition du contour, du départ à la fin",
  "retrait de la distance d’approche",
  "retour au départ du cycle en rapide",
];
const notes = [turnMode, safePosition, edgeLength];

export const longitudinal = {
  810: {
    name: "Contour longitudinal",
    summary: "Tourne un contour libre d’un sous-programme, dans le sens longitudinal.",
    description: [
      "Tourne un contour quelconque le long de l’axe : arbres et alésages avec épaulements, cônes, arcs, dégagements et " +
        "gorges. Le contour est un sous-programme, désigné par le cycle 14 ou par SEL CONTOUR.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que le contour : usinage " +
        "extérieur. Plus près : usinage intérieur. Entre les deux, c’est l’outil qui décide, selon la direction de sa pointe. " +
        "Notre lecture ; à vérifier sur la commande.",
      "Le contour est usiné dans le sens où il est programmé. Si le X du point de départ est sous le départ du contour, " +
        "l’outil va d’abord en X au départ du contour ; pour la finition, à la distance d’approche.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  811: {
    name: "Épaulement longitudinal",
    summary: "Tourne un épaulement droit dans le sens longitudinal, depuis la position de l’outil.",
    description: [
      "Tourne un cylindre et la face qui le termine. La position de l’outil à l’appel est un coin de la zone à usiner, la " +
        "fin programmée est l’autre ; il n’y a ni angle ni arête cassée.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : usinage extérieur. " +
        "Plus près : usinage intérieur.",
    ],
    rough,
    finish,
    notes,
  },
  812: {
    name: "Épaulement longitudinal étendu",
    summary: "Tourne un épaulement dans le sens longitudinal, avec chanfreins, angles et rayon de coin.",
    description: [
      "Tourne un épaulement le long de l’axe. Les arêtes au départ et à la fin du contour peuvent recevoir un chanfrein ou un " +
        "arrondi, le pourtour et la face peuvent être inclinés, le coin intérieur peut être arrondi.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. " +
        "Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en X, puis en Z, à la distance d’approche ; " +
        "pour la finition, d’abord en Z.",
    ],
    rough,
    finish,
    notes,
  },
  813: {
    name: "Tournage en plongée longitudinal",
    summary: "Descend derrière un flanc dans un cylindre, dans le sens longitudinal.",
    description: [
      "Tourne une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un cylindre, puis jusqu’à une " +
        "face droite à la fin.",
      "Ce qui se trouve devant le départ du contour reste, à la hauteur de Q491. Notre lecture ; à vérifier sur la commande.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en X, puis en Z, à la distance d’approche " +
        "devant le départ du contour.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  814: {
    name: "Tournage en plongée longitudinal étendu",
    summary: "Descend derrière un flanc dans un cylindre, avec arêtes cassées, rayons de coin et face inclinée.",
    description: [
      "Tourne une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un cylindre, puis en remontant " +
        "une face à la fin. Les arêtes des deux extrémités peuvent recevoir un chanfrein ou un arrondi, les deux coins du " +
        "cylindre peuvent être arrondis et la face peut être inclinée.",
      "Ce qui se trouve devant le départ du contour reste, à la hauteur de Q491. Notre lecture ; à vérifier sur la commande.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en X, puis en Z, à la distance d’approche " +
        "devant le départ du contour.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  815: {
    name: "Tournage parallèle au contour",
    summary: "Usine un contour libre par des passes parallèles à celui-ci, comme sur une pièce moulée ou forgée.",
    description: [
      "Tourne un contour d’un sous-programme. Le brut est supposé être le contour avec une surépaisseur tout autour ; les passes " +
        "suivent le contour, chacune plus près, au lieu de suivre l’axe.",
      "Ébauche, finition, ou les deux. Le sens dans lequel le contour est programmé est le sens d’usinage. Le point de départ décide entre " +
        "extérieur et intérieur.",
      "Si le point de départ se trouve derrière le début du contour, l’outil va d’abord en Z à la distance d’approche devant celui-ci, en " +
        "ébauche comme en finition.",
    ],
    rough: [
      "prise de passe en rapide devant la passe",
      "passe le long du contour à l’avance d’ébauche",
      "retour en X à la position de départ à l’avance d’ébauche",
      "en rapide au début de la passe suivante",
      "répéter jusqu’à la surépaisseur",
      "retour au départ du cycle en rapide",
    ],
    finish: [
      "prise de passe en rapide",
      "finition du contour, du départ à la fin",
      "retrait de la distance d’approche",
      "retour au départ du cycle en rapide",
    ],
    notes: [
      turnMode,
      "Le cycle 14 doit nommer le sous-programme du contour avant l’appel.",
      "La première passe se trouve une valeur de passe sous la surépaisseur du brut, où que soit le point de départ : là où le brut est " +
        "plus épais, elle est plus profonde. Notre lecture ; à vérifier sur la commande.",
      "La page du manuel distingue extérieur et intérieur par le début et la fin du contour. Ici, c’est le côté du point de départ qui " +
        "décide : selon la page, un arbre qui s’épaissit vers le mandrin serait un usinage intérieur. À vérifier sur la commande.",
      "Dans un angle rentrant du contour, une passe prend un instant plus que sa valeur : jusqu’à un sixième pour un angle droit.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
