import type { ExportTexts } from "../en/export.ts";
import { typeset } from "./typography/typeset.ts";

export const exported: ExportTexts = typeset({
  title: "Exporter la pièce",
  lead: "Longueurs en millimètres. Z est le long de la broche, le zéro est celui de la pièce.",
  leadInches:
    "DXF en pouces, comme compte le programme ; STL et SVG en millimètres. Z est le long de la broche, le zéro est celui de la pièce.",
  bodies: "Volumes",
  bodiesHint:
    "STL en millimètres, surfaces fermées, cordes à 0,02 mm au plus de l’arrondi. Les filetages sont des hélices, à droite.",
  body: { part: "Pièce finie", blank: "Brut", stock: "Matière telle qu’elle est maintenant" },
  bodyHint: {
    part: "Le brut moins tout ce qu’enlèvent les cycles et les déplacements entre eux.",
    left: "Aucun cycle n’indique de contour : ce que tous les déplacements laissent du brut à la fin.",
    blank: "Tel que le programme l’indique.",
    stock: (step: string, steps: string) => `Après ${step} déplacements sur ${steps}, là où en est la lecture.`,
  },
  file: { part: "piece", blank: "brut", stock: "matiere" },
  contour: "Contour",
  which: "Quel contour",
  all: "Tous, chacun sur son calque",
  one: (block: string, cycle: string) => `Séquence ${block}, cycle ${cycle}`,
  milled: (block: string) => `Séquence ${block}, plan d’usinage`,
  across: "X dans le fichier DXF",
  radius: "En rayon, les arcs restent des arcs",
  diameter: (within: string) => `En diamètre, arcs en cordes à ${within}`,
  acrossHint: "Le dessin montre la demi-coupe. Celui qui le lit doit savoir lequel des deux est choisi.",
  svgHint: "SVG : grandeur réelle, X en rayon, les arcs restent des arcs.",
  planeHint: "Grandeur réelle, X vers la droite, Y vers le haut, les arcs restent des arcs.",
  older: "C’est plus ancien que la saisie : les dernières valeurs ne donnent pas de trajectoire.",
  beginning: "Le programme est encore en cours de calcul.",
  lack: {
    noBlank: "Le programme n’indique pas de brut.",
    noTurning: "Le programme ne fait que fraiser : il n’y a pas de volume tourné.",
    nothingLeft: "Il ne reste rien de la matière ici.",
    noCycle: "Rien n’est enlevé au brut.",
    noContour: "Il n’y a pas encore de contour.",
  },
  milling: "Les volumes montrent la pièce tournée, sans ce qui est fraisé.",
  unproved: "Une partie du programme n’est pas simulée. Les volumes montrent le reste.",
  save: (what: string, format: string) => `${what} en ${format}`,
  saved: (file: string, volume: string) => `${file} enregistré, ${volume}.`,
  savedFile: (file: string) => `${file} enregistré.`,
  rings: "Ses filetages sont des anneaux : ils n’ont pas pu devenir des hélices.",
});
