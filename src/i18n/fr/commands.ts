import type { CommandsTexts } from "../en/commands.ts";

export const commands: CommandsTexts = {
  title: "Commandes",
  search: "Rechercher commandes, cycles, pages",
  none: "Aucun résultat.",
  count: (n: number) => (n === 1 ? "1 commande" : `${n} commandes`),
  start: "Page d’accueil",
  course: "Cours",
  guide: "Aide",
  glossary: "Glossaire",
  groups: {
    recent: "Récemment utilisées",
    action: "Actions",
    page: "Pages",
    program: "Programmes",
    cycle: "Cycles",
    lesson: "Leçons",
    example: "Exemples",
    setting: "Réglages",
  },
  kinds: {
    action: "Action",
    page: "Page",
    program: "Programme",
    cycle: "Cycle",
    lesson: "Leçon",
    example: "Exemple",
    setting: "Réglage",
  },
};
