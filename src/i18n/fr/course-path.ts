import type { CoursePathTexts } from "../en/course-path.ts";

const count = (n: number, one: string): string => (n === 0 ? "" : n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const coursePath = {
  choose: "Parcours",
  whole: { title: "Cours complet", about: "Du premier épaulement à la pièce complète" },
  size: (lessons, exercises, time) => `${lessons} leçons · ${exercises} exercices · ${time}`,
  range: (from, to) => `Leçons ${from} à ${to}`,
  lessonStates: { new: "non commencée", begun: "commencée", done: "terminée" },
  time: (hours, minutes) =>
    `environ ${[hours > 0 && `${hours} h`, minutes > 0 && `${minutes} min`].filter(Boolean).join(" ")}`,
  beginTask: (title) => `Commencer l’exercice : ${title}`,
  more: "Autres exercices de cette leçon",
  review: {
    title: (n) => `À revoir (${n})`,
    lead: "Exercices réussis avec de l’aide, et réponses fausses.",
    step: (questions, exercises, time) =>
      `À revoir : ${[count(questions, "question"), count(exercises, "exercice"), time].filter(Boolean).join(", ")}`,
    question: (lesson, page) => `Question de la leçon ${lesson}, page ${page}`,
    repeat: (title) => `Refaire l’exercice : ${title}`,
  },
  made: {
    toReview: (n) => `${n} à revoir`,
    skip: "Aller à la fin",
    again: "Relire",
    handIn: "Rendre",
  },
} satisfies CoursePathTexts;
