import type { SecondSideTexts } from "../en/second-side.ts";

export const secondSide: SecondSideTexts = {
  title: "Retourner la pièce",
  lead:
    "Ce que ce programme laisse devient la pièce brute d'un nouveau programme : inversée, point zéro sur la nouvelle face. Ce programme " +
    "reste tel quel.",
  piece: "Pièce",
  held: (size) => `Dans le mandrin, ${size}`,
  off: (size) => `Tronçonnée, ${size}`,
  allowance: (unit) => `Surépaisseur sur la nouvelle face, ${unit}`,
  allowanceHint: "Z0 se trouve à cette distance derrière la nouvelle face. 0 : elle n'est plus dressée.",
  allowanceWrong: (most) => `Une longueur de 0 à ${most}`,
  blank: "Pièce brute",
  name: "Nouveau programme",
  open: "Ouvrir le nouveau programme",
  lack: {
    beginning: "Le programme est encore en cours de calcul.",
    older: "Les valeurs les plus récentes ne donnent aucune trajectoire : on ne sait pas ce qu'elles laissent.",
    faults: "Le programme contient des erreurs : ce qu'il laisse n'est pas la pièce. Voir les constats.",
    noBlank: "Le programme n'indique pas de pièce brute.",
    nothingLeft: "Il ne reste rien de la matière.",
  },
  unproved: "Une partie du programme n'est pas simulée. Ce qu'elle fait manque dans la nouvelle pièce brute.",
  milling: "Ce qui est fraisé manque dans la nouvelle pièce brute : c'est la pièce telle qu'elle est tournée.",
};
