import type { PlanComparisonTexts } from "../en/plan-comparison.ts";

export const planComparison: PlanComparisonTexts = {
  title: "Deux gammes pour une pièce",
  about:
    "Le planificateur a établi une gamme pour le même dessin, avec les mêmes outils. Aucune des deux n’est la seule bonne : chaque différence a été essayée dans votre programme et toute la pièce contrôlée à nouveau.",
  planning: (tries) => `Calcul de la gamme : ${tries} opérations essayées`,
  trying: (n) => `Essai dans votre programme : différence ${n}`,
  failed: "La comparaison n’a pas pu être calculée.",
  noPlan: "Aucune gamme possible pour ce dessin.",
  noProgram: "Votre programme n’a pas encore d’opération.",
  again: "Réessayer",
  yours: "Votre gamme",
  planner: "Planificateur",
  whole: "La pièce entière",
  facts: {
    time: "Temps",
    changes: "Changements d’outil",
    tools: "Outils",
    left: "Matière résiduelle",
    goals: "Objectifs",
  },
  met: "tous atteints",
  missed: (goals) => `non atteints : ${goals}`,
  withChanges: (time) => `Les temps comprennent ${time} par changement d’outil.`,
  summary: (differences, planner, own) =>
    differences === 0
      ? "Les deux gammes font la même chose."
      : `Différences essayées : ${differences}. La façon du planificateur est meilleure dans ${planner} cas, la vôtre dans ${own}.`,
  rows: "Opération par opération",
  onlyYours: "seulement dans votre gamme",
  onlyPlanner: "seulement dans la gamme calculée",
  nothing: "pas d’opération de ce genre",
  number: (n) => `N° ${n}`,
  thread: "filetage",
  differs: {
    same: "même outil, même cycle",
    tool: "autre outil",
    cycle: "autre cycle",
    count: (own, planner) => `${own} : ${planner} opérations`,
    earlier: "plus tôt dans la gamme calculée",
    later: "plus tard dans la gamme calculée",
    faster: (time) => `la vôtre plus rapide de ${time}`,
    slower: (time) => `planificateur plus rapide de ${time}`,
    sameTime: "même temps",
  },
  why: "Pourquoi le planificateur fait ainsi",
  values: { title: "Autres valeurs", value: "Valeur", reason: "Formule du planificateur" },
  tried: {
    way: "Votre programme avec la façon du planificateur",
    order: "Votre programme dans l’ordre du planificateur",
    none: "N’a pas pu être écrit dans votre programme.",
    time: (time, difference) => `${time} (${difference})`,
    left: (area) => `${area} de matière résiduelle`,
    clean: "aucune matière résiduelle",
    changes: (n) => (n === 1 ? "1 changement d’outil" : `${n} changements d’outil`),
    better: {
      own: "Votre façon est meilleure",
      other: "Celle du planificateur est meilleure",
      same: "Aucune différence de résultat",
    },
  },
};
