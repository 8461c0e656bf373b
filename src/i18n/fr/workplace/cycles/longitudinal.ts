import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, inclination, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "prise de passe paraxiale en avance rapide",
  "coupe longitudinale, avance d’ébauche",
  "retrait de la valeur de passe",
  "retour au début de la coupe en avance rapide",
  "répéter jusqu’au contour fini",
  "retour au départ du cycle en avance rapide",
];
const finish = [
  "prise de passe paraxiale en avance rapide",
  "finition du contour, du départ à la fin",
  "retrait de la distance d’approche",
  "retour au départ du cycle en avance rapide",
];
const notes = [turnMode, safePosition, edgeLength];

export const longitudinal = {
  810: {
    name: "Contour longitudinal",
    summary: "Tourne un contour libre d’un sous-programme, dans le sens longitudinal.",
    description: [
      "Tourne un contour quelconque dans le sens longitudinal : arbres et alésages avec épaulements, cônes, " +
        "arcs, dégagements et " +
        "gorges. Le contour est un sous-programme, sélectionné par le cycle 14 ou SEL CONTOUR.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que le contour : " +
        "usinage " +
        "extérieur. Plus près : usinage intérieur. Entre les deux, l’orientation de l’outil décide.",
      "Le contour est usiné dans le sens programmé. Si la coordonnée X du point de départ est inférieure au " +
        "départ du contour, " +
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
      "Tourne un cylindre et la face qui le termine. La position de l’outil à l’appel est un coin de la zone à " +
        "usiner, la fin programmée est l’autre, sans angle, chanfrein ni arrondi.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : " +
        "usinage extérieur. " +
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
      "Tourne un épaulement dans le sens longitudinal. Les arêtes au départ et à la fin du contour peuvent avoir " +
        "un chanfrein ou un arrondi, la surface périphérique et la face transversale peuvent être inclinées, le " +
        "coin intérieur peut être arrondi.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : " +
        "usinage extérieur. " +
        "Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en X, puis en Z, à la distance " +
        "d’approche ; " +
        "pour la finition, d’abord en Z.",
    ],
    rough,
    finish,
    notes: [...notes, inclination],
  },
  813: {
    name: "Tournage en plongée longitudinal",
    summary: "Descend derrière un flanc dans un cylindre, dans le sens longitudinal.",
    description: [
      "Tourne une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un cylindre, puis " +
        "jusqu’à une face perpendiculaire à la fin.",
      "La matière devant le départ du contour n’est pas usinée ; elle reste à la hauteur de Q491.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en X, puis en Z, à la distance " +
        "d’approche " +
        "devant le départ du contour.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  814: {
    name: "Tournage en plongée longitudinal étendu",
    summary: "Descend derrière un flanc dans un cylindre, avec chanfreins, rayons et face inclinée.",
    description: [
      "Tourne une zone où l’outil doit plonger : le long d’un flanc au départ du contour, sur un cylindre, puis " +
        "en remontant " +
        "une face à la fin. Les arêtes des deux extrémités peuvent avoir un chanfrein ou un arrondi, les deux " +
        "coins du " +
        "cylindre peuvent être arrondis et la face peut être inclinée.",
      "La matière devant le départ du contour n’est pas usinée ; elle reste à la hauteur de Q491.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage " +
        "extérieur. Inférieur : usinage intérieur.",
      "Si le point de départ se trouve dans la zone à usiner, l’outil va d’abord en X, puis en Z, à la distance " +
        "d’approche " +
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
      "Tourne un contour d’un sous-programme. La pièce brute est supposée être le contour avec une surépaisseur " +
        "tout autour ; les passes sont parallèles au contour, chacune plus proche, et non à l’axe.",
      "Ébauche, finition, ou les deux. Le sens programmé du contour est le sens d’usinage. Le point de départ " +
        "décide entre usinage extérieur et intérieur.",
      "Si le point de départ se trouve derrière le départ du contour, l’outil va d’abord en Z à la distance " +
        "d’approche devant le contour, en ébauche comme en finition.",
    ],
    rough: [
      "prise de passe en avance rapide devant la passe",
      "passe le long du contour à l’avance d’ébauche",
      "retour en X à la position de départ à l’avance d’ébauche",
      "en avance rapide au début de la passe suivante",
      "répéter jusqu’à la surépaisseur",
      "retour au départ du cycle en avance rapide",
    ],
    finish: [
      "prise de passe en avance rapide",
      "finition du contour, du départ à la fin",
      "retrait de la distance d’approche",
      "retour au départ du cycle en avance rapide",
    ],
    notes: [
      turnMode,
      "Avant l’appel, le cycle 14 doit sélectionner le sous-programme du contour.",
      "La première passe se trouve une valeur de passe sous la surépaisseur, quel que soit le point de départ : " +
        "là où la pièce brute est plus épaisse, la passe est plus profonde.",
      "Le manuel distingue usinage extérieur et intérieur par le départ et la fin du contour ; ici, le côté du " +
        "point de départ décide. Selon le manuel, un arbre qui s’épaissit vers le mandrin serait un usinage " +
        "intérieur. Non vérifié.",
      "Dans un coin intérieur du contour, une passe est brièvement plus profonde que sa valeur : jusqu’à un " +
        "sixième pour un angle droit.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
