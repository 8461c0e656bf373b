import type { Lesson } from "./lesson.ts";
import type { Task } from "./task.ts";

/*
 * How long a lesson and an exercise take. No learner was measured; the numbers are assumptions, kept in one place.
 *
 * Reading: adults read English non-fiction at 238 words a minute on average (M. Brysbaert, Journal of Memory and
 * Language 109, 2019, 104047). Three quarters of that, for new terms and values. Words are counted in English for
 * every language: translations of one text take about the same time.
 */

/** Words read in a minute. */
const WORDS_PER_MINUTE = 180;

/** Seconds beside the words of a page: to watch another program run, to move a slider, to answer a question. */
const PAGE_SECONDS = { program: 8, slide: 20, question: 15 } as const;

/** Seconds to find the way into an exercise and to check it; a fault has to be found first, a drawing read. */
const KIND_SECONDS: Readonly<Record<Task["kind"], number>> = { make: 60, fault: 120, predict: 30, drawing: 240 };

/** Seconds to work out and enter a line or a value, and to predict an answer. */
const LINE_SECONDS = 8;
const PREDICTION_SECONDS = 45;

const SECONDS_PER_MINUTE = 60;
const wordCount = (text = ""): number => text.split(/\s+/).filter((word) => word !== "").length;
const readingSeconds = (text?: string): number => (wordCount(text) / WORDS_PER_MINUTE) * SECONDS_PER_MINUTE;
const sum = (all: readonly number[]): number => all.reduce((total, each) => total + each, 0);

/** Seconds to study the pages of a lesson, without its exercises. */
export const secondsOfPages = ({ pages, words }: Pick<Lesson, "pages" | "words">): number =>
  sum((words.en?.pages ?? []).map(readingSeconds)) +
  sum(
    pages.flatMap((page) =>
      (Object.keys(PAGE_SECONDS) as (keyof typeof PAGE_SECONDS)[]).map((part) =>
        part in page ? PAGE_SECONDS[part] : 0,
      ),
    ),
  );

/** A line without its block number. */
const withoutNumber = (line: string): string => line.replace(/^\d+ /, "").trim();

/** Lines of the solution that the learner writes: all but those that the exercise starts with. */
function linesToWrite({ start, solution = [] }: Pick<Task, "start" | "solution">): number {
  // Prompts with a set-up: only the values of the cycle are entered.
  if ("cycle" in start) {
    const values = solution.filter((line) => /^\s*Q\d+=/.test(line)).length;
    return Math.max(0, values - Object.keys(start.values).length);
  }
  const given = "program" in start ? start.program.map(withoutNumber) : [];
  return solution.map(withoutNumber).filter((line) => {
    const index = given.indexOf(line);
    if (index >= 0) given.splice(index, 1);
    return index < 0;
  }).length;
}

/** Seconds to solve an exercise without help. */
export const secondsOfTask = (task: Pick<Task, "kind" | "start" | "solution" | "predict" | "words">): number =>
  KIND_SECONDS[task.kind] +
  readingSeconds(task.words.en?.ask) +
  linesToWrite(task) * LINE_SECONDS +
  (task.predict?.length ?? 0) * PREDICTION_SECONDS;

/** A time as shown: whole minutes up to half an hour, then steps of five minutes, from three hours of half an hour. */
export function shownStudyTime(seconds: number): { readonly hours: number; readonly minutes: number } {
  const exact = seconds / SECONDS_PER_MINUTE;
  const step = exact <= 30 ? 1 : exact < 180 ? 5 : 30;
  const minutes = Math.max(1, Math.round(exact / step) * step);
  return { hours: Math.floor(minutes / 60), minutes: minutes % 60 };
}
