import type { ChooserTexts } from "../../en/first/chooser.ts";

export const chooser = {
  cycles: "Cycles",
  search: "Chercher un cycle",
  hint: "Chercher par numéro, nom ou terme d’atelier",
  languages: "Recherche dans les quatre langues.",
  found: (n) => (n === 1 ? "1 cycle trouvé." : `${n} cycles trouvés.`),
  enter: (cycle) => `Entrée choisit ${cycle}.`,
  none: "Aucun cycle ne correspond à ces mots.",
  acts: (cycle) => `${cycle} : n’agit que dans un programme. Ouvrir un programme et y insérer le cycle, sous Cycle.`,
  kept: (cycle) =>
    `${cycle} : affiché dans un programme mais non simulé ; à partir de là, le programme n’est pas vérifié. Coller les lignes du cycle dans le texte du programme.`,
  recent: "Utilisés récemment",
  recentOne: (cycle) => `Utilisé récemment : ${cycle}`,
  count: (n) => (n === 1 ? "1 cycle" : `${n} cycles`),
  evidence: (cycles) =>
    `Les listes de paramètres de ${cycles} sont vérifiées d’après le manuel. Celles des autres cycles sont à vérifier sur la commande.`,
  evidenceLink: "Listes de paramètres dans l’aide",
  empty: "Sans valeurs",
  insert: "Insérer",
  back: "Toutes les séquences",
} satisfies ChooserTexts;
