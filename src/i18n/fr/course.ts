import type { CourseTexts } from "../en/course.ts";

export const course = {
  title: "Cours",
  lead:
    "Tourner avec les cycles de la commande, du premier épaulement à la pièce entière. Chaque leçon tient en quelques pages avec une " +
    "image animée, et des exercices dans le véritable éditeur.",
  entrance: {
    name: "Cours",
    about: "Leçons et exercices, du premier épaulement à la pièce entière",
    goOn: (lesson) => `Continuer la leçon ${lesson}`,
  },
  lessons: "Leçons",
  lesson: (n) => `Leçon ${n}`,
  openLesson: (n, title) => `Leçon ${n}, ${title}`,
  begin: "Commencer par la leçon 1",
  goOn: (n, title) => `Continuer : leçon ${n}, ${title}`,
  passed: (n, of) => `Exercices réussis : ${n} sur ${of}`,
  allPassed: "Tous les exercices réussis",
  noTasks: "Pas d’exercice",
  read: "lue",
  here: "Vous êtes ici",
  states: {
    new: "pas commencé",
    tried: "essayé",
    alone: "réussi seul",
    hints: "réussi avec des indices",
    solution: "réussi après avoir vu la solution",
  },
  kinds: { make: "Programmer", fault: "Trouver la faute", predict: "Prédire", drawing: "D’après un dessin" },

  missing: "Cette leçon ne fait pas partie du cours.",
  toList: "Toutes les leçons",
  pages: "Pages de la leçon",
  page: (n) => `Page ${n}`,
  pageOf: (n, of) => `Page ${n} sur ${of}`,
  tasks: "Exercices",
  previous: "Retour",
  next: "Suite",
  toTasks: "Aux exercices",
  nextLesson: (n, title) => `Leçon suivante : ${n}, ${title}`,
  example: "Ouvrir l’exemple dans l’éditeur",
  exampleLead: "Le programme de cette leçon, pour essayer des valeurs. Votre travail est conservé ; Retour ramène ici.",
  noTasksYet: "Cette leçon n’a pas d’exercice.",

  picture: {
    name: "Image de la leçon",
    working: "L’image se calcule.",
    failed: "L’image n’a pas pu être calculée.",
    play: "Lancer l’image",
    pause: "Arrêter l’image",
    first: "Au début",
    back: "Un déplacement en arrière",
    forward: "Un déplacement en avant",
    scrub: "Instant de l’image",
    program: "Le programme de l’image",
    openProgram: "Ouvrir ce programme dans l’éditeur",
  },

  anew: "Recommencer le cours",
  cancel: "Annuler",
  begunAnew: "Le cours recommence. Annuler ramène ce qui avait été atteint.",
  damaged: "Ce qui a été atteint dans le cours n’a pas pu être lu. Cela a été mis de côté et le cours recommence.",
  notKept:
    "Ce navigateur ne conserve pas ce qui est atteint dans le cours. Enregistrez tout dans un fichier (réglages) avant de fermer la page.",
} satisfies CourseTexts;
