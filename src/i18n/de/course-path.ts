import type { CoursePathTexts } from "../en/course-path.ts";

const count = (n: number, one: string): string => (n === 0 ? "" : n === 1 ? `1 ${one}` : `${n} ${one}n`);

export const coursePath = {
  choose: "Weg durch den Kurs",
  whole: { title: "Ganzer Kurs", about: "Vom ersten Absatz bis zum fertigen Teil" },
  size: (lessons, exercises, time) => `${lessons} Lektionen · ${exercises} Aufgaben · ${time}`,
  range: (from, to) => `Lektionen ${from} bis ${to}`,
  lessonStates: { new: "nicht begonnen", begun: "begonnen", done: "fertig" },
  time: (hours, minutes) =>
    `etwa ${[hours > 0 && `${hours} h`, minutes > 0 && `${minutes} min`].filter(Boolean).join(" ")}`,
  beginTask: (title) => `Aufgabe beginnen: ${title}`,
  more: "Weitere Aufgaben dieser Lektion",
  review: {
    title: (n) => `Wiederholen (${n})`,
    lead: "Aufgaben, die mit Hilfe gelöst wurden, und falsch beantwortete Fragen.",
    step: (questions, exercises, time) =>
      `Wiederholen: ${[count(questions, "Frage"), count(exercises, "Aufgabe"), time].filter(Boolean).join(", ")}`,
    question: (lesson, page) => `Frage in Lektion ${lesson}, Seite ${page}`,
    repeat: (title) => `Aufgabe wiederholen: ${title}`,
  },
  made: {
    toReview: (n) => `${n} zu wiederholen`,
    skip: "Zum Ende springen",
    again: "Noch einmal abspielen",
    handIn: "Abgeben",
  },
} satisfies CoursePathTexts;
