import type { ExportTexts } from "../en/export.ts";
import { typeset } from "./typography/typeset.ts";

export const exported: ExportTexts = typeset({
  title: "Exporter la pièce",
  lead: "Longueurs en millimètres. Z est l’axe de broche, l’origine est le point zéro pièce.",
  leadInches:
    "DXF en pouces, comme dans le programme ; STL et SVG en millimètres. Z est l’axe de broche, l’origine est le point zéro pièce.",
  bodies: "Volumes",
  bodiesHint:
    "STL en millimètres, surfaces fermées, tolérance de corde 0,02 mm. Les filetages sont des hélices à droite.",
  body: { part: "Pièce finie", blank: "Brut", stock: "Matière actuelle" },
  bodyHint: {
    part: "Le brut moins la matière enlevée par tous les cycles et déplacements.",
    left: "Aucun cycle ne définit de contour : la matière après tous les déplacements.",
    blank: "Tel que défini dans le programme.",
    stock: (step: string, steps: string) => `Après ${step} déplacements sur ${steps}, à la position de lecture.`,
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
  acrossHint: "Le dessin montre la demi-coupe. À la lecture, il faut savoir si X est un rayon ou un diamètre.",
  svgHint: "SVG : grandeur réelle, X en rayon, les arcs restent des arcs.",
  planeHint: "Grandeur réelle, X vers la droite, Y vers le haut, les arcs restent des arcs.",
  older: "Dernier état valide : les dernières valeurs ne donnent pas de trajectoire.",
  beginning: "Le programme est encore en cours de calcul.",
  lack: {
    noBlank: "Le programme ne définit pas de brut.",
    noTurning: "Le programme ne fait que fraiser : il n’y a pas de pièce tournée.",
    nothingLeft: "Il n’y a plus de matière ici.",
    noCycle: "Rien n’est enlevé au brut.",
    noContour: "Il n’y a pas encore de contour.",
  },
  milling: "Sans le fraisage : les volumes montrent la pièce tournée.",
  unproved: "Une partie du programme n’est pas simulée et manque dans les volumes.",
  save: (what: string, format: string) => `${what} en ${format}`,
  saved: (file: string, volume: string) => `${file} enregistré, ${volume}.`,
  savedFile: (file: string) => `${file} enregistré.`,
  rings: "Les filetages sont exportés en anneaux, pas en hélices.",
});
