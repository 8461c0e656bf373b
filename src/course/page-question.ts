import type { PageQuestion } from "./lesson.ts";
import { withParameterValue } from "./playback-range.ts";

/** Start of a line that names what it sets: the number of a block, or a parameter. */
const keyOf = (line: string): string | undefined => /^\s*(\d+ |Q\d+=)/.exec(line)?.[1];

/** A program with other lines in place of those that begin with the same block number or parameter. */
export const withLines = (lines: readonly string[], others: readonly string[]): readonly string[] =>
  others.reduce((program, next) => {
    const key = keyOf(next);
    return key?.endsWith("=") === true
      ? withParameterValue(program, key.slice(0, -1), Number(next.slice(key.length)))
      : program.map((line) => (key !== undefined && keyOf(line) === key ? next : line));
  }, lines);

/** The program that a question is about: that of its page, with the lines of the question. */
export const programOfQuestion = (question: PageQuestion, lines: readonly string[]): readonly string[] =>
  withLines(lines, question.with ?? []);
