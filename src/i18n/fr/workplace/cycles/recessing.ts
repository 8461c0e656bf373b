import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "plongée en pleine matière à l’avance réduite, jusqu’à la surépaisseur",
  "temporisation au fond, puis retrait",
  "décalage latéral du recouvrement, devant la pièce",
  "plongée à côté de la précédente, à l’avance d’ébauche",
  "répéter jusqu’à la largeur, puis coupe le long des parois inclinées ou courbes",
  "retour au départ du cycle en avance rapide",
];
const finish = [
  "avance rapide au premier côté",
  "finition de la première paroi",
  "finition de la moitié du fond, puis relever",
  "sortie de la gorge en avance rapide",
  "avance rapide au deuxième côté",
  "finition de la deuxième paroi",
  "finition de l’autre moitié du fond, puis relever",
  "retour au départ du cycle en avance rapide",
];
const order =
  "Ébauche du fond vers une paroi puis vers l’autre, finition, ou les deux. Pour le plongeage en peigne, d’abord " +
  "les coupes pleines, puis les nervures intermédiaires.";
const notes = [
  turnMode,
  safePosition,
  "Si la partie plate de l’arête (largeur moins deux fois le rayon) atteint au moins la moitié de la largeur, le " +
    "décalage entre deux plongées ne la dépasse jamais : il ne reste pas de crêtes.",
  "Une gorge plus profonde que CUTLENGTH n’est usinée que jusqu’à cette profondeur, avec un message.",
  "La liste des paramètres et les étapes ne sont pas vérifiées dans un manuel ; à vérifier sur la commande.",
];
const sections =
  "Un contour à plusieurs creux est usiné section par section : fond et parois d’une section avant la suivante.";

export const recessing = {
  860: {
    name: "Gorge de contour radiale",
    summary: "Usine en plongée un contour dans un cylindre ou un alésage, avec un nombre quelconque de gorges.",
    description: [
      "Enlève la matière entre le contour d’un sous-programme et le point de départ, par plongées vers l’axe ; " +
        "dans un alésage, en s’éloignant de l’axe. Le cycle 14 sélectionne d’abord le contour.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "Gorge radiale simple",
    summary:
      "Usine en plongée une gorge à parois perpendiculaires dans un cylindre ou un alésage, du point de départ à " +
      "un coin.",
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
    summary:
      "Usine en plongée une gorge dans un cylindre ou un alésage, avec flancs inclinés, chanfreins et rayons de " +
      "fond.",
    description: [
      "Réalise une gorge dans un cylindre ou un alésage par plongées côte à côte. Les arêtes peuvent avoir un " +
        "chanfrein ou un arrondi, les deux flancs peuvent être inclinés, les coins du fond arrondis.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  870: {
    name: "Gorge de contour axiale",
    summary: "Usine en plongée un contour dans une face, avec un nombre quelconque de gorges.",
    description: [
      "Enlève la matière entre le contour d’un sous-programme et le point de départ, par plongées le long de " +
        "l’axe. Le cycle 14 sélectionne d’abord le contour.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  871: {
    name: "Gorge axiale simple",
    summary: "Usine en plongée une gorge à parois perpendiculaires dans une face, du point de départ à un coin.",
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
    summary: "Usine en plongée une gorge dans une face, avec flancs inclinés, chanfreins et rayons de fond.",
    description: [
      "Réalise une gorge dans une face par plongées côte à côte. Les arêtes peuvent avoir un chanfrein ou un " +
        "arrondi, les deux flancs peuvent être inclinés, les coins du fond arrondis.",
      order,
    ],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
