import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

const rough = [
  "plongée à la première profondeur",
  "coupe latérale entre départ et fin à l’avance d’ébauche",
  "éléments plongeants à leur propre avance",
  "un sens : relever, revenir, aborder ; deux sens : passe aux deux bouts",
  "coupe à la profondeur suivante",
  "répéter jusqu’à la profondeur de la gorge",
  "rapide à la distance, puis une coupe le long de chaque paroi",
  "retour au départ du cycle en rapide",
];
const finish = [
  "rapide à la première paroi",
  "finition de la première paroi",
  "finition du fond ; avec un rayon de coin, toute la gorge d’un seul trait",
  "sortie de la gorge en rapide",
  "rapide à la deuxième paroi",
  "finition de la deuxième paroi",
  "retour au départ du cycle en rapide",
];
const shortened =
  "À partir de la deuxième passe, chaque coupe est raccourcie de 0,1 mm, ou de Q508 ; l’outil est ainsi soulagé " +
  "latéralement. Le reste part en une coupe à la fin de l’ébauche.";
const tooFar =
  "Si le décalage dépasse 80 % de la largeur effective (largeur de la dent moins deux fois son rayon), la commande signale " +
  "une erreur.";
const recalled = [
  "La liste des paramètres vient de mémoire, d’après le cycle jumeau imprimé, et les étapes aussi. Notre lecture ; à vérifier " +
    "sur la commande.",
  "Q460 est pris pour réservé, comme dans le cycle 852 ; une distance fixe est gardée à sa place.",
];
const notes = [turnMode, safePosition, shortened, tooFar, edgeLength, ...recalled];

export const recessTurning = {
  840: {
    name: "Tournage de gorge radial, contour",
    summary: "Tourne les gorges d’un contour programmé dans un cylindre ou un alésage, creux par creux.",
    description: [
      "Enlève la matière au-dessus d’un contour de sous-programme (cycle 14 ou SEL CONTOUR) par tournage de gorge : l’outil " +
        "plonge puis tourne latéralement. Un contour à plusieurs creux est usiné section par section, à partir du départ du " +
        "contour.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que le contour : usinage " +
        "extérieur. Plus près de l’axe : usinage intérieur.",
      "Si le X du point de départ est plus près du fond que le point le plus haut du contour, l’outil y va d’abord en X.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 décale tout le contour en profondeur, puisqu’il n’a pas un seul fond ; en finition, une paroi raide issue d’un coin " +
        "vif est coupée de haut en bas. Notre lecture ; à vérifier sur la commande.",
    ],
  },
  841: {
    name: "Tournage de gorge radial simple",
    summary: "Tourne une gorge à flancs droits dans un cylindre ou un alésage, du point de départ à un coin.",
    description: [
      "Réalise une gorge dans un cylindre, ou dans un alésage, entre le point de départ du cycle et le coin Q493, Q494. Le " +
        "point de départ est le premier coin de la gorge : son X est l’ouverture, son Z le premier flanc.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : usinage extérieur. " +
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
      "Réalise une gorge dans un cylindre, ou dans un alésage, par tournage de gorge : l’outil plonge à une profondeur puis " +
        "tourne latéralement, avec peu de dégagements. Les arêtes peuvent recevoir un chanfrein ou un arrondi, les deux " +
        "flancs peuvent être inclinés, les coins du fond arrondis.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. " +
        "Inférieur : usinage intérieur.",
      "Si le X du point de départ est plus près du fond que le diamètre de départ Q491, l’outil va d’abord en X à Q491.",
    ],
    rough,
    finish,
    notes,
  },
  850: {
    name: "Tournage de gorge axial, contour",
    summary: "Tourne les gorges d’un contour programmé dans une face, creux par creux.",
    description: [
      "Enlève la matière au-dessus d’un contour de sous-programme (cycle 14 ou SEL CONTOUR) par tournage de gorge : l’outil " +
        "plonge puis tourne latéralement. Un contour à plusieurs creux est usiné section par section, à partir du départ du " +
        "contour.",
      "Ébauche en passes paraxiales, finition, ou les deux. La face est usinée depuis +Z ; depuis −Z quand l’outil pointe vers " +
        "+Z et se trouve derrière le contour.",
      "Si le Z du point de départ est sous le point le plus haut du contour, l’outil y va d’abord en Z.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 décale tout le contour en profondeur, puisqu’il n’a pas un seul fond ; en finition, une paroi raide issue d’un coin " +
        "vif est coupée de haut en bas. Notre lecture ; à vérifier sur la commande.",
    ],
  },
  851: {
    name: "Tournage de gorge axial simple",
    summary: "Tourne une gorge à flancs droits dans une face, du point de départ à un coin.",
    description: [
      "Réalise une gorge dans une face entre le point de départ du cycle et le coin Q493, Q494. Le point de départ est le " +
        "premier coin de la gorge : son Z est l’ouverture, son X le premier flanc.",
      "Ébauche en passes paraxiales, finition, ou les deux. Point de départ plus loin de l’axe que Q493 : usinage vers l’axe. " +
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
      "Réalise une gorge dans une face par tournage de gorge : l’outil plonge à une profondeur puis tourne latéralement, avec " +
        "peu de dégagements. Les arêtes peuvent recevoir un chanfrein ou un arrondi, les deux flancs peuvent être inclinés, les " +
        "coins du fond arrondis.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. " +
        "Inférieur : usinage intérieur.",
      "Si le Z du point de départ est sous le départ du contour Q492, l’outil va d’abord en Z à Q492.",
    ],
    rough,
    finish,
    notes: [
      turnMode,
      safePosition,
      shortened,
      tooFar,
      edgeLength,
      "La page dit Q460 réservé et nomme pourtant la distance d’approche dans deux étapes ; nous y prenons une distance fixe.",
    ],
  },
} satisfies CycleTexts;
