import type { ChooserTexts } from "../../en/first/chooser.ts";

export const chooser = {
  cycles: "Cycles",
  search: "Chercher un cycle",
  hint: "Numéro, nom ou mot d’atelier",
  languages: "Recherche dans l’une des quatre langues.",
  keys: "Les flèches vont d’un cycle à l’autre.",
  found: (n) => (n === 1 ? "1 cycle trouvé." : `${n} cycles trouvés.`),
  enter: (cycle) => `Entrée prend ${cycle}.`,
  none: "Aucun cycle ne correspond à ces mots.",
  acts: (cycle) =>
    `${cycle} : pas un travail à lui seul, il agit là où il est dans un programme. Ouvrir un programme et l’y insérer, sous Cycle.`,
  kept: (cycle) =>
    `${cycle} : affiché et conservé, non exécuté ; après lui, rien n’est contrôlé. Coller ses lignes dans le texte du programme.`,
  recent: "Utilisés récemment",
  recentOne: (cycle) => `Utilisé récemment : ${cycle}`,
  count: (n) => (n === 1 ? "1 cycle" : `${n} cycles`),
  recalled: "liste citée de mémoire",
  empty: "Vide",
  insert: "Insérer",
  back: "Toutes les séquences",
} satisfies ChooserTexts;
