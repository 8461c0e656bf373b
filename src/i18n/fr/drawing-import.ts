import type { DrawingImportTexts } from "../en/drawing-import.ts";

export const drawingImport = {
  title: "Contour à partir d’un dessin",
  choose: "Choisir un dessin",
  chooseOther: "Autre dessin",
  drop: (endings) => `Choisir un dessin ou le déposer ici : ${endings}.`,
  reading: "Lecture du dessin …",
  cancel: "Annuler",
  take: "Reprendre le contour",
  replaces: (elements) =>
    elements === 1
      ? "Remplace l’élément du tableau ; Annuler le rétablit."
      : `Remplace les ${elements} éléments du tableau ; Annuler les rétablit.`,
  newProgram: "Créer le programme",
  cycle: "Cycle",
  sheet: "Dessin",
  sheetKeys:
    "Les flèches sélectionnent le contour, l’axe ou le point zéro suivant, selon le réglage ci-dessus ; plus et moins zooment, 0 affiche tout, Maj avec les flèches déplace.",
  picture: (elements) =>
    elements === 0
      ? "Dessin sans contour sélectionné"
      : `Dessin avec un contour de ${elements === 1 ? "1 élément" : `${elements} éléments`}`,
  pick: {
    label: "Toucher le dessin sélectionne",
    contour: "Contour",
    axis: "Axe",
    zero: "Z0",
    how: {
      contour: "Toucher une ligne du contour : extérieur ou alésage, moitié et tracé en découlent.",
      axis: "Toucher une ligne sur l’axe de rotation ou déplacer l’axe.",
      zero: "Toucher un point ou une ligne à Z0 ou déplacer le point zéro.",
    },
  },
  showContour: "Zoomer sur le contour",
  refused: {
    notStraight: "L’axe de rotation est une ligne horizontale ou verticale.",
    nothingHere: "Rien à sélectionner ici.",
    notOfContour: "Avec cet axe, la ligne n’appartient à aucun contour.",
  },
  chosen: "Sélectionné",
  proposed: "proposé",
  useProposal: "Rétablir la proposition",
  body: "Solide",
  bodyOf: (number: number, name: string, across: string, length: string) =>
    `${number} : ${name} ⌀ ${across} × ${length} mm`.replace("  ", " "),
  unit: "Unité du dessin",
  units: { mm: "Millimètres", inch: "Pouces" },
  source: {
    file: "indiquée dans le fichier",
    measurement: "d’après le système de mesure du fichier",
    assumed: "supposée : le fichier n’indique pas d’unité",
    chosen: "choisie",
  },
  size: (width, height, unit) => `Dessin ${width} × ${height} ${unit}`,
  partSize: (across, length) => `⌀ ${across} × ${length} mm`,
  axis: "Axe de rotation",
  level: "Horizontal",
  upright: "Vertical",
  axisAt: { x: "à y", y: "à x" },
  zero: "Point zéro pièce Z0",
  zeroAt: { x: "à x", y: "à y" },
  atEnd: {
    x: { low: "Extrémité gauche", high: "Extrémité droite" },
    y: { low: "Extrémité inférieure", high: "Extrémité supérieure" },
  },
  zWay: "Sens de Z+",
  zWays: {
    x: { forward: "vers la droite", back: "vers la gauche" },
    y: { forward: "vers le haut", back: "vers le bas" },
  },
  half: "Moitié",
  halves: {
    x: { upper: "Moitié supérieure", lower: "Moitié inférieure" },
    y: { upper: "Moitié droite", lower: "Moitié gauche" },
  },
  side: "Contour",
  sides: { outside: "Extérieur", bore: "Intérieur" },
  piece: "Tracé",
  pieceOf: (number, all, length) => `${number} sur ${all}, longueur ${length} mm`,
  diameters: "X dessiné en diamètre",
  thin: "Aussi les lignes cachées et fines",
  layers: "Calques",
  reversed: "Inverser le sens",
  gap: "Tolérance de raccord (mm)",
  more: "Autres options",
  result: "Contour dans le tableau",
  resultHow: "Les flèches montrent chaque élément dans le dessin.",
  moreRows: (count) => `${count} autres éléments`,
  noContour: "Aucun contour avec ces choix.",
  notes: "Remarques sur le dessin",
  leftOut: (count) =>
    count === 1
      ? "1 remarque sur les lignes omises ou converties"
      : `${count} remarques sur les lignes omises ou converties`,
  closeGap: "Raccorder",
  closeGapOf: (note) => `Raccorder l’écart de la remarque ${note}`,
  moreNotes: (count) => (count === 1 ? "1 autre remarque" : `${count} autres remarques`),
} satisfies DrawingImportTexts;
