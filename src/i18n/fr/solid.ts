import type { SolidTexts } from "../en/solid.ts";
import { typeset } from "./typography/typeset.ts";

export const solid: SolidTexts = typeset({
  title: "Vue 3D",
  picture: (cut: boolean, state: string) =>
    `La pièce tournée en 3D${cut ? ", coupe d’un quart" : ""}, Z vers la droite. ${state}`,
  keys: "Les flèches tournent la vue, avec Maj elles la déplacent ; plus et moins zooment, 0 montre tout ; 1, 2 et 3 sont les vues isométrique, de face et en bout.",
  views: "Vues",
  quarter: "Coupe d’un quart",
  quarterShort: "Coupe",
  iso: "Isométrique",
  front: "De face",
  end: "En bout",
  threads: "Les filetages sont dessinés en anneaux, sans pas.",
  left: "Filetage à gauche : M4, ou avance s’éloignant du mandrin.",
  milled: "Le fraisage n’est pas dans ce volume : voir le plan d’usinage.",
  noBlank: "Aucun brut défini : seule la trajectoire est affichée.",
  surfaces: "Surfaces",
  textures: { raw: "non usiné", rough: "ébauché", thread: "filetage", finished: "fini" },
  marked: { residual: "matière résiduelle", gouge: "violation de contour, collision" },
  missing: "Ce navigateur ne peut pas afficher de 3D ici (pas de WebGL). La coupe est affichée à la place.",
  lost: "La liaison avec la carte graphique est interrompue. La coupe est affichée jusqu’au retour de la 3D.",
  again: "Réessayer la 3D",
});
