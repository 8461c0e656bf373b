import type { Shape } from "../shape.ts";

const count = (n: number, one: string): string => (n === 0 ? "" : n === 1 ? `1 ${one}` : `${n} ${one}s`);

/**
 * The way through the course: its paths and chapters, the time it takes, what was missed, and the next step. Numbers
 * arrive as text.
 */
export const coursePath = {
  choose: "Path through the course",
  whole: { title: "Whole course", about: "From the first shoulder to a complete part" },
  size: (lessons: string, exercises: string, time: string) => `${lessons} lessons · ${exercises} exercises · ${time}`,
  range: (from: string, to: string) => `Lessons ${from} to ${to}`,
  lessonStates: { new: "not started", begun: "in progress", done: "done" },
  time: (hours: number, minutes: number) =>
    `about ${[hours > 0 && `${hours} h`, minutes > 0 && `${minutes} min`].filter(Boolean).join(" ")}`,
  beginTask: (title: string) => `Start exercise: ${title}`,
  more: "More exercises of this lesson",
  review: {
    title: (n: string) => `Review (${n})`,
    lead: "Exercises passed with help, and questions answered wrongly.",
    step: (questions: number, exercises: number, time: string) =>
      `Review: ${[count(questions, "question"), count(exercises, "exercise"), time].filter(Boolean).join(", ")}`,
    question: (lesson: string, page: string) => `Question in lesson ${lesson}, page ${page}`,
    repeat: (title: string) => `Repeat exercise: ${title}`,
  },
  made: {
    toReview: (n: string) => `${n} to review`,
    skip: "Skip to the end",
    again: "Play again",
    handIn: "Hand in",
  },
};

export type CoursePathTexts = Shape<typeof coursePath>;
