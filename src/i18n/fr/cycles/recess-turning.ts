import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const recessTurning = {
  852: {
    name: "Tournage de gorge axial étendu",
    summary: "Tourne une gorge dans une face, avec flancs inclinés, chanfreins et rayons de fond.",
    description: [
      "Réalise une gorge dans une face par tournage de gorge : l'outil plonge à une profondeur puis tourne latéralement, avec "
      + "peu de dégagements. Les arêtes peuvent recevoir un chanfrein ou un arrondi, les deux flancs peuvent être inclinés, les "
      + "coins du fond arrondis.",
      "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. "
      + "Inférieur : usinage intérieur.",
      "Si le Z du point de départ est sous le départ du contour Q492, l'outil va d'abord en Z à Q492.",
    ],
    rough: [
      "plongée à la première profondeur",
      "coupe latérale entre départ et fin à l'avance d'ébauche",
      "éléments plongeants à leur propre avance",
      "relever, revenir et aborder de nouveau (un sens), ou prendre la passe aux deux bouts (deux sens)",
      "coupe à la profondeur suivante",
      "répéter jusqu'à la profondeur de la gorge",
      "rapide à la distance, puis une coupe le long de chaque paroi",
      "retour au départ du cycle en rapide",
    ],
    finish: [
      "rapide à la première paroi",
      "finition de la première paroi",
      "finition du fond ; avec un rayon de coin, toute la gorge d'un seul trait",
      "sortie de la gorge en rapide",
      "rapide à la deuxième paroi",
      "finition de la deuxième paroi",
      "retour au départ du cycle en rapide",
    ],
    notes: [
      turnMode,
      safePosition,
      "À partir de la deuxième passe, chaque coupe est raccourcie de 0,1 mm, ou de Q508 ; l'outil est ainsi soulagé "
      + "latéralement. Le reste part en une coupe à la fin de l'ébauche.",
      "Si le décalage dépasse 80 % de la largeur effective (largeur de la dent moins deux fois son rayon), la commande signale "
      + "une erreur.",
      edgeLength,
      "La page dit Q460 réservé et nomme pourtant la distance d'approche dans deux étapes ; nous y prenons une distance fixe.",
    ],
  },
} satisfies CycleTexts;
