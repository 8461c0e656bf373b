import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) =>
    `L’angle et DR ont des signes différents (${word}) : la commande refuse l’arc. Programmer le même signe.`,
  zeroBehindCorner: (word: string) =>
    `Cette séquence après ${word} a une longueur 0 : la commande ne peut pas y arrondir ni chanfreiner un coin.`,
  emptyCentre: (word: string) =>
    `${word} sans coordonnées reprend le dernier point, mais la séquence précédente n’a qu’un axe : y programmer les deux coordonnées, ou dans ${word}.`,
  sideOnArc: (word: string) =>
    `La correction de rayon ne peut pas commencer sur un arc (${word}) : programmer RL ou RR dans une séquence droite avant celui-ci.`,
  toolCallCompensated: (word: string) =>
    `${word} est actif à ce TOOL CALL : la commande le refuse. Programmer R0 avant.`,
};

/** Messages about a running program: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : ` à la séquence ${block}`;
    return {
      stopped:
        block === undefined
          ? "La broche est arrêtée ici : M3, M4, M303 ou M304 manque."
          : `La broche est arrêtée ici, par la séquence ${block}. Programmer M3, M4, M303 ou M304 avant cette passe.`,
      noSpeed: "La broche n’a pas de vitesse ici : programmer FUNCTION TURNDATA SPIN avant cette passe.",
      hand: `Sens de broche incorrect pour cet outil, défini${by}. Programmer le sens inverse.`,
    }[how];
  },
  toolLimit: ({ tool, column, value, limit, x, z }, w) =>
    ({
      DAXN: `L’outil ${tool} usine une gorge axiale de ${w.diameter(value)} ; la lame convient à partir de ${w.diameter(limit)} (DAXN) et frotte sur la paroi extérieure.`,
      DAXX: `L’outil ${tool} usine une gorge axiale de ${w.diameter(value)} ; la lame convient jusqu’à ${w.diameter(limit)} (DAXX) et frotte sur la paroi intérieure.`,
      CDX: `L’outil ${tool} est à ${w.length(value)} de profondeur dans la matière en ${w.place(x, z)} ; sa profondeur de coupe est ${w.length(limit)} (CDX).`,
      CUTDIA: `L’outil ${tool} tronçonne ${w.diameter(value)} ; il convient jusqu’à ${w.diameter(limit)} (CUTDIA).`,
      DMIN: `L’outil ${tool} est dans un alésage de ${w.diameter(value)} en ${w.place(x, z)} ; il lui faut ${w.diameter(limit)} (DMIN).`,
    })[column],
  holeMissing: ({ tool, diameter, z }, w) =>
    `L’outil ${tool} avance jusqu’à Z${w.signed(z)} où il n’y a pas de trou : percer d’abord à ${w.diameter(diameter)} au moins.`,
  speedUnlimited: ({ diameter, block }, w) =>
    `Vitesse de coupe constante sans SMAX, et la séquence ${block} atteint ${w.diameter(
      diameter,
    )} : la vitesse de rotation y est illimitée. ` + "Programmer SMAX.",
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `Vitesse de coupe ${w.number(speed)} m/min supérieure au maximum en tournage (${w.number(most)} m/min).`
      : `${w.number(speed)} tr/min dépassent la vitesse maximale de la broche (${w.number(most)} tr/min).`,
  offCentre: ({ y }, w) =>
    `L’outil est à ${w.length(y)} du centre en Y : la coupe n’est pas vérifiée. Programmer Y+0 et annuler le décalage en Y.`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `L’outil ${w.text(tool)} n’est pas dans le tableau : ${
      rows.length > 0 ? `de cet outil, seulement ${rows.join(", ")}` : "aucune ligne de cet outil"
    }.`,
  firstElement: ({ word }, w) =>
    `Un contour ne peut pas commencer par ${w.text(
      word,
    )} : aucun point n’est connu avant. Commencer par une séquence droite avec X et Z.`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;
