import type { CoursePathTexts } from "../en/course-path.ts";

export const coursePath = {
  choose: "Parcours",
  paths: {
    whole: { name: "Cours complet", about: "Du premier épaulement à la pièce complète, en cinq chapitres" },
    hour: { name: "Trois pièces en une heure", about: "Les exemples du manuel pour 812, 820 et 852" },
  },
  size: (lessons, exercises, time) => `${lessons} leçons · ${exercises} exercices · ${time}`,
  chapters: {
    basics: "Bases",
    shoulders: "Épaulements : cycle 812",
    contours: "Contours et gorges : cycles 820 et 852",
    features: "Directions, gorges, filetages, alésages",
    programs: "Programmes complets",
  },
  range: (from, to) => `Leçons ${from} à ${to}`,
  lessonStates: { new: "non commencée", begun: "commencée", done: "terminée" },
  time: (hours, minutes) =>
    `environ ${[hours > 0 && `${hours} h`, minutes > 0 && `${minutes} min`].filter(Boolean).join(" ")}`,
  beginTask: (title) => `Commencer l’exercice : ${title}`,
  more: "Autres exercices de cette leçon",
  finished: "Tous les exercices de ce parcours sont réussis.",
  review: {
    title: (n) => `À revoir (${n})`,
    lead: "Exercices réussis avec de l’aide et questions mal répondues.",
    question: (lesson, page) => `Question de la leçon ${lesson}, page ${page}`,
    repeat: (title) => `Refaire l’exercice : ${title}`,
  },
  made: {
    skip: "Aller à la fin",
    again: "Relire",
    handIn: "Rendre",
    nextLesson: (n, title) => `Suite : leçon ${n}, ${title}`,
    review: (n) => `Suite : à revoir (${n})`,
  },
} satisfies CoursePathTexts;
