import type { DrawingTexts } from "../drawing-note.ts";

const many = (count: string, one: string, more: string) => (count === "1" ? `1 ${one}` : `${count} ${more}`);
const entities = (count: string) => many(count, "entité", "entités");
const lines = (count: string) => many(count, "droite ou arc", "droites et arcs");

/** What of a solid is not turned. */
function milled(shape: string, count: string): string {
  if (shape === "flats") return many(count, "face plane", "faces planes");
  if (shape === "holes") return many(count, "perçage hors de l’axe", "perçages hors de l’axe");
  return shape === "crossHoles"
    ? many(count, "perçage transversal", "perçages transversaux")
    : many(count, "autre face", "autres faces");
}

export const drawing: DrawingTexts = {
  unknownKind: ({ kinds }) => `Ce n’est pas un dessin lisible. Formats lus : ${kinds}.`,
  unreadable: ({ kind }) => `Ce fichier n’est pas un dessin ${kind} lisible.`,
  tooLarge: ({ limit }) => `Ce fichier dépasse ${limit} Mo.`,
  tooMany: ({ limit }) =>
    `Le dessin a plus de ${limit} droites et arcs. Enregistrer seul le profil de la pièce et l’importer.`,
  nothing: () => "Le dessin ne contient ni droites, ni arcs, ni courbes.",
  truncated: () => "Le fichier s’interrompt avant sa fin ; il est lu jusque-là.",
  hiddenLayer: ({ layer, count }) => `Calque ${layer} désactivé ou gelé : ${entities(count)} omises.`,
  invisible: ({ count }) => `Invisible, omis : ${entities(count)}.`,
  paperSpace: ({ count }) => `Sur la présentation (espace papier), omis : ${entities(count)}.`,
  paperUsed: () => "L’espace objet est vide : la présentation est lue. Vérifier son échelle.",
  skipped: ({ kind, count }) => `Non utilisé : ${count} × ${kind}.`,
  broken: ({ count }) => `Omis, nombres incomplets : ${entities(count)}.`,
  missingBlock: ({ block }) =>
    `L’élément BLOCK ${block} manque dans le fichier ; lier d’abord les références externes.`,
  recursiveBlock: ({ block }) => `L’élément BLOCK ${block} se contient lui-même ; omis.`,
  otherPlane: ({ count }) => `Hors du plan du dessin, omis : ${entities(count)}.`,
  plane: ({ plane }) =>
    plane === "oblique" ? "Dessiné dans un plan oblique, vu de face." : `Dessiné dans le plan ${plane}.`,
  doubled: ({ count }) => `Superposés et fusionnés : ${lines(count)}.`,
  fitted: ({ kind, count, tolerance }) =>
    `Remplacé par des arcs et droites à ${tolerance} mm près : ${count} × ${kind}.`,
  unitAssumed: ({ width, height }) => `Aucune unité dans le fichier : mm supposés, taille ${width} × ${height} mm.`,
  unitConverted: ({ unit }) => `Dessiné en ${unit}, converti en mm.`,
  unitsDisagree: ({ unit }) => `Le fichier nomme deux unités ; ${unit} est prise. Vérifier la taille.`,
  noContour: () => "Aucun contour de ce côté de l’axe.",
  onlyAxis: () => "Toutes les droites sont sur l’axe de rotation.",
  axisUnmarked: ({ x }) =>
    `Le dessin ne montre pas l’axe de rotation ; sa position est une proposition. Plus petit ⌀ avec elle : ${x} mm.`,
  gapJoined: ({ width, x, z }) => `Écart de ${width} mm fermé en X ⌀ ${x}, Z ${z}.`,
  gapOpen: ({ width, x, z }) => `Écart de ${width} mm ouvert en X ⌀ ${x}, Z ${z} : augmenter la tolérance d’écart.`,
  axisLines: ({ count }) => `Sur l’axe de rotation, omis : ${many(count, "droite", "droites")}.`,
  otherHalf: ({ count }) => `De l’autre côté de l’axe : ${lines(count)}.`,
  otherPieces: ({ count }) => `Non relié au contour : ${many(count, "autre morceau", "autres morceaux")}.`,
  insideLines: ({ count }) => `À l’intérieur du profil, hors du contour : ${lines(count)}.`,
  notOutline: ({ count }) => `Traits cachés ou fins, hors du contour : ${lines(count)}.`,
  rearFace: ({ z }) => `La face arrière en Z ${z} est omise.`,
  noSolid: () => "Le fichier ne contient aucun solide.",
  noRevolved: () => "Aucun solide du fichier n’a de surface de révolution.",
  otherBodies: ({ name, count, turned }) =>
    `${name === "" ? "Un solide est repris" : `Solide ${name} repris`} ; omis : ${many(count, "autre solide", "autres solides")}, ${turned === "0" ? "aucun n’est tourné" : `dont tournés : ${turned}, à choisir sous « Solide »`}.`,
  notTurned: ({ shape, count }) => `Omis, non tourné : ${milled(shape, count)}.`,
};
