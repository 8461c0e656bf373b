import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) =>
    `L’angle et DR ont des signes différents (${word}) : la commande refuse l’arc. Leur donner le même signe.`,
  zeroBehindCorner: (word: string) =>
    `Cette séquence après ${word} ne déplace rien : la commande ne peut ni arrondir ni chanfreiner un angle avec un élément de longueur 0.`,
  emptyCentre: (word: string) =>
    `${word} sans coordonnées reprend le dernier point, mais la séquence précédente ne nomme ` +
    `qu’un axe : y programmer les deux coordonnées, ou dans ${word}.`,
  sideOnArc: (word: string) =>
    `La correction de rayon ne peut pas commencer sur un arc (${word}) : programmer RL ou RR dans une séquence droite avant celui-ci.`,
  toolCallCompensated: (word: string) =>
    `${word} est actif à ce TOOL CALL : la commande le refuse. Programmer R0 avant.`,
};

/** What holds while a program runs: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : ` à la séquence ${block}`;
    return {
      stopped:
        block === undefined
          ? "La broche ne tourne pas ici : aucun M3, M4, M303 ou M304 ne l’a démarrée."
          : `La broche ne tourne pas ici : la séquence ${block} l’a arrêtée. Programmer M3, M4, M303 ou M304 avant cette passe.`,
      noSpeed: "La broche n’a pas de vitesse ici : programmer FUNCTION TURNDATA SPIN avant cette passe.",
      hand: `La broche tourne dans le mauvais sens pour cet outil, sens fixé${by}. Programmer l’autre sens.`,
    }[how];
  },
  holeMissing: ({ tool, diameter, z }, w) =>
    `L’outil ${tool} avance jusqu’à Z${w.signed(z)} où il n’y a pas de trou : percer d’abord à ${w.diameter(diameter)} au moins.`,
  speedUnlimited: ({ diameter, block }, w) =>
    `La vitesse de coupe constante n’a pas de SMAX, et la séquence ${block} vient à ${w.diameter(
      diameter,
    )} : la vitesse de rotation y monte sans limite. ` + "Programmer SMAX.",
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `Une vitesse de coupe de ${w.number(speed)} m/min dépasse ce que les matières permettent en tournage (${w.number(most)} m/min).`
      : `${w.number(speed)} tr/min dépassent ce que permet la broche de la machine (${w.number(most)} tr/min).`,
  offCentre: ({ y }, w) =>
    `L’outil tourne à ${w.length(y)} du centre en Y : ce qu’il y usine n’est pas contrôlé. Programmer Y+0 et annuler le décalage en Y.`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `L’outil ${w.text(tool)} n’est pas dans le tableau : ${
      rows.length > 0 ? `de cet outil, il contient ${rows.join(", ")}` : "il n’a aucune ligne de cet outil"
    }.`,
  firstElement: ({ word }, w) =>
    `Un contour ne peut pas commencer par ${w.text(
      word,
    )} : la commande ne connaît aucun point avant. Commencer par une séquence droite qui nomme X et Z.`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;
