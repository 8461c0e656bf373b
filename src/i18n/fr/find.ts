import type { FindTexts } from "../en/find.ts";

export const find: FindTexts = {
  ctrl: "Ctrl",
  shift: "Maj",
  find: "Rechercher",
  with: "Remplacer par",
  replace: "Remplacer",
  replaceOne: "Remplacer",
  replaceAll: "Tout remplacer",
  previous: "Résultat précédent",
  next: "Résultat suivant",
  close: "Fermer",
  position: (n: number, of: number) => `${n} sur ${of}`,
  count: (n: number) => (n === 0 ? "Aucun résultat" : n === 1 ? "1 résultat" : `${n} résultats`),
  replaced: (n: number) => (n === 1 ? "1 remplacé" : `${n} remplacés`),
  goTo: "Atteindre",
  goToLong: "Séquence, LBL, outil, cycle ou Q",
  block: (n: string) => `Séquence ${n}`,
  renumber: "Renuméroter les séquences",
  fold: "Replier ou déplier tous les cycles",
  tools: "Rechercher et organiser",
};
