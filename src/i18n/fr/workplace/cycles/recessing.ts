import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "plongée en pleine matière à son avance, jusqu’à la surépaisseur",
  "temporisation au fond, puis sortie de la coupe",
  "décalage latéral du recouvrement, devant la pièce",
  "plongée à côté de ce qui est dégagé, à l’avance d’ébauche",
  "répéter jusqu’à la largeur, puis le long des parois inclinées ou rondes",
  "retour au départ du cycle en rapide",
];
const finish = [
  "rapide au premier côté",
  "finition de la première paroi",
  "finition de la moitié du fond, puis relever",
  "sortie de la gorge en rapide",
  "rapide au deuxième côté",
  "finition de la deuxième paroi",
  "finition de l’autre moitié du fond, puis relever",
  "retour au départ du cycle en rapide",
];
const order =
  "Ébauche du fond vers une paroi puis vers l’autre, finition, ou les deux. En peigne, d’abord les coupes pleines, " +
  "puis les nervures entre elles.";
const notes = [
  turnMode,
  safePosition,
  "Deux plongées ne sont jamais plus écartées que la partie plate de la dent (largeur moins deux fois le rayon), " +
    "si celle-ci en fait la moitié ou plus : il ne reste pas de crêtes.",
  "Une gorge plus profonde que CUTLENGTH n’est usinée que sur la longueur de la dent, avec un message.",
  "La liste des paramètres et les étapes viennent de mémoire ; aucune page que nous avons ne les imprime. Notre " +
    "lecture ; à vérifier sur la commande.",
];
const sections =
  "Un contour à plusieurs creux est usiné section par section, chacune jusqu’au fond et le long de ses parois " +
  "avant la suivante.";

export const recessing = {
  860: {
    name: "Gorge de contour radiale",
    summary: "Plonge un contour dans un cylindre ou un alésage, avec autant de gorges qu’on veut.",
    description: [
      "Enlève ce qui se trouve entre le contour d’un sous-programme et le point de départ, par plongées vers l’axe, ou " +
        "depuis lui dans un alésage. Le cycle 14 nomme d’abord le contour.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "Gorge radiale simple",
    summary: "Plonge une gorge à parois droites dans un cylindre ou un alésage, du point de départ à un coin.",
    description: [
      "Réalise une gorge dans un cylindre ou un alésage entre le point de départ du cycle et le coin Q493, Q494, par " +
        "plongées côte à côte. Le point de départ est le premier coin de la gorge.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  862: {
    name: "Gorge radiale étendue",
    summary: "Plonge une gorge dans un cylindre ou un alésage, avec flancs inclinés, chanfreins et rayons de fond.",
    description: [
      "Réalise une gorge dans un cylindre ou un alésage par plongées côte à côte. Les arêtes peuvent recevoir un " +
        "chanfrein ou un arrondi, les deux flancs peuvent être inclinés, les coins du fond arrondis.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  870: {
    name: "Gorge de contour axiale",
    summary: "Plonge un contour dans une face, avec autant de gorges qu’on veut.",
    description: [
      "Enlève ce qui se trouve entre le contour d’un sous-programme et le point de départ, par plongées le long de " +
        "l’axe. Le cycle 14 nomme d’abord le contour.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  871: {
    name: "Gorge axiale simple",
    summary: "Plonge une gorge à parois droites dans une face, du point de départ à un coin.",
    description: [
      "Réalise une gorge dans une face entre le point de départ du cycle et le coin Q493, Q494, par plongées côte à " +
        "côte. Le point de départ est le premier coin de la gorge.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  872: {
    name: "Gorge axiale étendue",
    summary: "Plonge une gorge dans une face, avec flancs inclinés, chanfreins et rayons de fond.",
    description: [
      "Réalise une gorge dans une face par plongées côte à côte. Les arêtes peuvent recevoir un chanfrein ou un " +
        "arrondi, les deux flancs peuvent être inclinés, les coins du fond arrondis.",
      order,
    ],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
