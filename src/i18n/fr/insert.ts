import type { InsertTexts } from "../en/insert.ts";

export const insert: InsertTexts = {
  site: "Où",
  sites: { outside: "Extérieur", inside: "Intérieur", face: "Face" },
  surface: "Surface",
  cylinder: (across, from, to) => `⌀${across}, Z${from} à Z${to}`,
  face: (z, from, to) => `Z${z}, ⌀${from} à ⌀${to}`,
  picture: (surfaces) => `Brut avant cette opération, surfaces : ${surfaces}`,
  none: {
    outside: "Le brut n’a pas de cylindre ici.",
    inside: "Le brut n’a pas encore d’alésage. Percez d’abord, ou indiquez un diamètre intérieur dans le brut.",
    face: "Le brut n’a pas de face avant ici.",
  },
  noStock: "Brut inconnu : indiquez un brut (BLK FORM) pour obtenir des cotes proposées.",
  fromSurface: (sizes) => `De la surface : ${sizes}`,
  fromStock: (sizes) => `Proposé : ${sizes}`,
  open: (prompts) => `À renseigner : ${prompts}`,
  contour: "Contour",
  label: (label) => `LBL ${label}`,
  draw: "Dessiner un nouveau contour",
  undrawn: "Dessinez d’abord le contour.",
  unsuitable: (tools) => `Outils inadaptés (${tools})`,
  noTool: "Aucun outil du tableau n’atteint cet endroit.",
  hand: {
    title: "Sans cycle de tournage",
    of: {
      chamfer: "Chanfrein à la main (L)",
      partOff: "Tronçonner",
      partOffChamfered: "Tronçonner avec chanfrein arrière",
      drill: "Percer dans l’axe",
      tap: "Tarauder dans l’axe",
    },
    sizes: { size: "Chanfrein", z: "Face arrière en Z" },
    noTool: "Le tableau d’outils n’a pas d’outil pour cela.",
    tools: "Ouvrir le tableau d’outils",
  },
};
