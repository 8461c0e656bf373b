import type { SolidTexts } from "../en/solid.ts";
import { typeset } from "./typography/typeset.ts";

export const solid: SolidTexts = typeset({
  title: "Vue 3D",
  picture: (cut: boolean, state: string) =>
    `Le volume tourné en 3D${cut ? ", un quart enlevé" : ""}, Z vers la droite. ${state}`,
  keys:
    "Les flèches tournent la vue, avec Maj elles la déplacent ; plus et moins zooment, 0 montre tout ; " +
    "1, 2 et 3 sont les vues en biais, de face et sur la face dressée.",
  views: "Vues",
  quarter: "Enlever un quart",
  quarterShort: "Quart",
  iso: "En biais",
  front: "De face",
  end: "Sur la face dressée",
  threads: "Les filetages sont ici dessinés en anneaux, sans leur pas.",
  left: "Filetage à gauche : M4, ou l’avance s’éloigne du mandrin.",
  milled: "Ce qui est fraisé n’est pas dans ce corps : voir le plan de travail.",
  noBlank: "Aucun brut indiqué : seul le trajet est montré.",
  surfaces: "Surfaces",
  textures: { raw: "brut", rough: "ébauché", thread: "filetage", finished: "fini" },
  marked: { residual: "matière résiduelle", gouge: "contour endommagé, collision" },
  missing: "Ce navigateur n’affiche pas de 3D ici : il n’a pas de WebGL. La coupe est montrée à sa place.",
  lost: "La carte graphique a été retirée. La coupe est montrée jusqu’au retour de la 3D.",
  again: "Réessayer la 3D",
});
