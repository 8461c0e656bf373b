import type { CourseTexts } from "../en/course.ts";

export const course = {
  title: "Cours",
  lead:
    "Tourner avec les cycles de la commande, du premier épaulement à la pièce complète. Chaque leçon comprend quelques pages avec une " +
    "image animée, et des exercices dans le véritable éditeur.",
  entrance: {
    name: "Apprendre",
    about: "Leçons et exercices, du premier épaulement à la pièce complète",
    goOn: (lesson) => `Continuer la leçon ${lesson}`,
  },
  lessons: "Leçons",
  lesson: (n) => `Leçon ${n}`,
  openLesson: (n, title) => `Leçon ${n}, ${title}`,
  begin: (n) => `Commencer par la leçon ${n}`,
  goOn: (n, title) => `Continuer : leçon ${n}, ${title}`,
  passed: (n, of) => `Exercices réussis : ${n} sur ${of}`,
  read: "lue",
  states: {
    new: "non commencé",
    tried: "essayé",
    alone: "réussi sans aide",
    hints: "réussi avec des indices",
    solution: "réussi, solution montrée",
  },
  kinds: { make: "Programmer", fault: "Trouver l’erreur", predict: "Prédire", drawing: "D’après un dessin" },

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
  exampleLead:
    "Le programme de cette leçon, pour essayer des valeurs. Vos programmes sont conservés ; Retour ramène ici.",
  noTasksYet: "Cette leçon n’a pas d’exercice.",

  picture: {
    name: "Image de la leçon",
    working: "Calcul de l’image …",
    failed: "L’image n’a pas pu être calculée.",
    play: "Lecture",
    pause: "Pause",
    first: "Au début",
    back: "Déplacement précédent",
    forward: "Déplacement suivant",
    scrub: "Position de la lecture",
    program: "Le programme de l’image",
    openProgram: "Ouvrir ce programme dans l’éditeur",
  },

  question: {
    name: "Question",
    check: "Vérifier",
    checking: "Vérification …",
    right: "Exact.",
    wrong: "Pas encore.",
    half: "C’est la moitié : un rayon ?",
    twice: "C’est le double : un diamètre ?",
    shown: "L’image montre maintenant ce cas.",
    failed: "La réponse n’a pas pu être vérifiée. Réessayez.",
    lacks: "Saisissez un nombre.",
    answered: "Répondu",
    yours: "Votre réponse",
  },

  restart: "Recommencer le cours",
  cancel: "Annuler",
  restarted: "Le cours a été recommencé. Annuler rétablit votre progression.",
  damaged:
    "Votre progression n’a pas pu être lue. Les données endommagées ont été mises de côté et le cours recommence.",
  notKept:
    "Ce navigateur n’enregistre pas votre progression. Sauvegardez vos données dans les réglages avant de fermer la page.",
} satisfies CourseTexts;
