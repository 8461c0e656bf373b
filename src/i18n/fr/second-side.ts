import type { SecondSideTexts } from "../en/second-side.ts";
import { typeset } from "./typography/typeset.ts";

export const secondSide = typeset<SecondSideTexts>({
  title: "Second côté",
  lead: "Le résultat de ce programme devient le brut d’un nouveau programme : inversé, point zéro sur la nouvelle face. Ce programme reste inchangé.",
  piece: "Pièce",
  held: (size) => `Dans le mandrin, ${size}`,
  off: (size) => `Tronçonnée, ${size}`,
  allowance: (unit) => `Surépaisseur sur la nouvelle face, ${unit}`,
  allowanceHint: "Distance de Z0 derrière la nouvelle face. 0 : la face n’est pas dressée.",
  allowanceWrong: (most) => `Une longueur de 0 à ${most}`,
  blank: "Brut",
  name: "Nouveau programme",
  open: "Ouvrir le nouveau programme",
  lack: {
    beginning: "Le programme est encore en cours de calcul.",
    older: "Les dernières valeurs ne donnent pas de trajectoire : le résultat est inconnu.",
    faults: "Le programme contient des erreurs : son résultat n’est pas la pièce. Voir les messages.",
    noBlank: "Le programme ne définit pas de brut.",
    nothingLeft: "Il n’y a plus de matière.",
  },
  unproved: "Une partie du programme n’est pas simulée et manque dans le nouveau brut.",
  milling: "Sans le fraisage : le nouveau brut est la pièce tournée.",
});
