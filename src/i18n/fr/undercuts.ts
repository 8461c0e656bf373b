import type { UndercutTexts } from "../en/undercuts.ts";

export const undercuts: UndercutTexts = {
  label: "Dégagement",
  of: (element) => `Élément ${element}, dégagement par désignation`,
  sizes: "Tailles",
  example: "p. ex. F0,8×0,3 ou DIN 76-A",
  none: "Désignation inconnue. Connues : DIN 509 et ISO 18388 E, F, H avec r×t1 ; DIN 76 A à D avec le pas.",
  noPlace: "Le diamètre est connu dès qu’un cylindre et une face se rencontrent ici.",
  taken: (name) => `${name} : mots renseignés`,
  load: { usual: "charge usuelle", fatigue: "résistance à la fatigue accrue" },
  source:
    "D’après des tableaux publics de DIN 509:2006-12 et DIN 76-1:2004-06, cotes nominales. Non imprimé pour cette commande.",
  notes: {
    nearest: (asked, taken) => `${asked} n’existe pas dans la norme. Taille la plus proche : ${taken}.`,
    diameter: (from, to) =>
      to === null
        ? `La norme le prévoit au-dessus de ⌀${from}.`
        : `La norme le prévoit au-dessus de ⌀${from} jusqu’à ⌀${to}.`,
    side: (asked, taken) => `La forme ${asked} concerne l’autre côté, la forme ${taken} est prise.`,
    pitch: (pitch) => `DIN 76 ne contient pas le pas ${pitch}.`,
    formG: "UDC n’a pas de forme G : la dessiner par droites et arcs.",
    faceOfF:
      "Le cycle laisse le dégagement de la face (t2). « Dégagement normalisé », inséré comme opération, l’usine avec des séquences de contour.",
    faceOfH: (t2) => `TYPE_H n’usine pas t2 = ${t2} dans la face.`,
    allowance: (z) => `Cotes avant rectification avec z = ${z} : programmer aussi le contour avec cette surépaisseur.`,
  },
};
