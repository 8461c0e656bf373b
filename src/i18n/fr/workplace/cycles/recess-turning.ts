import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

const rough = [
  "plongée à la première profondeur",
  "coupe latérale entre départ et fin à l’avance d’ébauche",
  "éléments en plongée à l’avance de plongée",
  "unidirectionnel : relever, revenir, approcher ; bidirectionnel : prise de passe aux deux bouts",
  "coupe à la profondeur suivante",
  "répéter jusqu’à la profondeur de la gorge",
  "à la distance d’approche en avance rapide, puis une coupe le long de chaque paroi",
  "retour au départ du cycle en avance rapide",
];
const finish = [
  "avance rapide à la première paroi",
  "finition de la première paroi",
  "finition du fond ; avec un rayon de coin, toute la gorge en une seule opération",
  "sortie de la gorge en avance rapide",
  "avance rapide à la deuxième paroi",
  "finition de la deuxième paroi",
  "retour au départ du cycle en avance rapide",
];
const shortened =
  "À partir de la deuxième passe, chaque coupe est raccourcie de 0,1 mm, ou de Q508 ; la pression latérale sur " +
  "l’outil diminue. La matière résiduelle est enlevée en une fois à la fin de l’ébauche.";
const tooFar =
  "Si le décalage dépasse 80 % de la largeur effective (largeur d’arête moins deux fois le rayon d’arête), la " +
  "commande émet un message d’erreur.";
const unverified = [
  "La liste des paramètres et les étapes suivent le cycle apparenté imprimé et ne sont pas vérifiées dans un " +
    "manuel ; à vérifier sur la commande.",
  "Q460 est considéré comme réservé, comme dans le cycle 852 ; une distance fixe est utilisée.",
];
const notes = [turnMode, safePosition, shortened, tooFar, edgeLength, ...unverified];

export const recessTurning = {
  840: {
    name: "Tournage de gorge radial, contour",
    summary: "Tourne les gorges d’un contour programmé dans un cylindre ou un alésage, un creux après l’autre.",
    description: [
      "Enlève la matière au-dessus d’un contour décrit dans un sous-programme (cycle 14 ou SEL CONTOUR) par " +
        "tournage de gorge : l’outil " +
        "plonge puis tourne latéralement. Un contour à plusieurs creux est usiné section par section, à partir " +
        "de son départ.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que le contour : " +
        "usinage " +
        "extérieur. Plus près de l’axe : usinage intérieur.",
      "Si la coordonnée X du point de départ est plus près du fond que le point le plus haut du contour, l’outil " +
        "va d’abord en X à ce point.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 décale tout le contour en profondeur, car son fond n’est pas partout à la même profondeur ; en " +
        "finition, une paroi raide à un coin vif est usinée de haut en bas.",
    ],
  },
  841: {
    name: "Tournage de gorge radial simple",
    summary: "Tourne une gorge à flancs perpendiculaires dans un cylindre ou un alésage, du point de départ à un coin.",
    description: [
      "Réalise une gorge dans un cylindre, ou dans un alésage, entre le point de départ du cycle et le coin " +
        "Q493, Q494. Le " +
        "point de départ est le premier coin de la gorge : son X est l’ouverture, son Z le premier flanc.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : " +
        "usinage extérieur. " +
        "Plus près de l’axe : usinage intérieur.",
    ],
    rough,
    finish,
    notes,
  },
  842: {
    name: "Tournage de gorge radial étendu",
    summary: "Tourne une gorge dans un cylindre ou un alésage, avec flancs inclinés, chanfreins et rayons de fond.",
    description: [
      "Réalise une gorge dans un cylindre, ou dans un alésage, par tournage de gorge : l’outil plonge à une " +
        "profondeur puis " +
        "tourne latéralement, avec peu de dégagements. Les arêtes peuvent avoir un chanfrein ou un arrondi, les deux " +
        "flancs peuvent être inclinés, les coins du fond arrondis.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : " +
        "usinage extérieur. " +
        "Inférieur : usinage intérieur.",
      "Si la coordonnée X du point de départ est plus près du fond que le diamètre de départ Q491, l’outil va " +
        "d’abord en X à Q491.",
    ],
    rough,
    finish,
    notes,
  },
  850: {
    name: "Tournage de gorge axial, contour",
    summary: "Tourne les gorges d’un contour programmé dans une face, un creux après l’autre.",
    description: [
      "Enlève la matière au-dessus d’un contour décrit dans un sous-programme (cycle 14 ou SEL CONTOUR) par " +
        "tournage de gorge : l’outil " +
        "plonge puis tourne latéralement. Un contour à plusieurs creux est usiné section par section, à partir " +
        "de son départ.",
      "Ébauche en passes paraxiales, finition, ou les deux. La face est usinée depuis +Z ; depuis −Z quand " +
        "l’outil pointe vers " +
        "+Z et se trouve derrière le contour.",
      "Si la coordonnée Z du point de départ est inférieure au point le plus haut du contour, l’outil va d’abord " +
        "en Z à ce point.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 décale tout le contour en profondeur, car son fond n’est pas partout à la même profondeur ; en " +
        "finition, une paroi raide à un coin vif est usinée de haut en bas.",
    ],
  },
  851: {
    name: "Tournage de gorge axial simple",
    summary: "Tourne une gorge à flancs perpendiculaires dans une face, du point de départ à un coin.",
    description: [
      "Réalise une gorge dans une face entre le point de départ du cycle et le coin Q493, Q494. Le point de " +
        "départ est le " +
        "premier coin de la gorge : son Z est l’ouverture, son X le premier flanc.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : " +
        "usinage vers l’axe. " +
        "Plus près de l’axe : en s’en éloignant.",
    ],
    rough,
    finish,
    notes,
  },
  852: {
    name: "Tournage de gorge axial étendu",
    summary: "Tourne une gorge dans une face, avec flancs inclinés, chanfreins et rayons de fond.",
    description: [
      "Réalise une gorge dans une face par tournage de gorge : l’outil plonge à une profondeur puis tourne " +
        "latéralement, avec peu de dégagements. Les arêtes peuvent avoir un chanfrein ou un arrondi, les deux " +
        "flancs peuvent être inclinés, les " +
        "coins du fond arrondis.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : " +
        "usinage extérieur. " +
        "Inférieur : usinage intérieur.",
      "Si la coordonnée Z du point de départ est inférieure au départ du contour Q492, l’outil va d’abord en Z à Q492.",
    ],
    rough,
    finish,
    notes: [
      turnMode,
      safePosition,
      shortened,
      tooFar,
      edgeLength,
      "Le manuel indique Q460 comme réservé, mais cite la distance d’approche dans deux étapes ; une distance " +
        "fixe y est utilisée.",
      "Non imprimé, donc non vérifié : le sens de Q495 et Q496, le signe de Q509 et le cumul de Q508 par côté.",
    ],
  },
} satisfies CycleTexts;
