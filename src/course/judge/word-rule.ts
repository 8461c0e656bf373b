import { parse } from "../../nc/parse.ts";
import { blockNumbers } from "../../nc/program.ts";
import type { Task } from "../task.ts";
import type { TaskMark } from "./judgement.ts";

/** A text for comparison: capital letters, single spaces, no plus signs before numbers. */
const plain = (text: string) =>
  text
    .toUpperCase()
    .replaceAll(/\+(?=[\d.])/g, "")
    .replaceAll(/\s+/g, " ")
    .trim();

/** The text of a block without its number and comments. */
const said = (raw: string) =>
  plain(
    raw
      .split(/\r?\n/)
      .map((line) => line.replace(/;.*/, "").replace(/~\s*$/, ""))
      .join(" ")
      .replace(/^\s*(?:\/\s*)?\d+\s/, ""),
  );

/**
 * Whether a text contains whole words: "M136" does not contain "M13", but "SMAX2500" contains "SMAX", since a number
 * may follow a letter.
 */
function hasWords(words: string, text: string): boolean {
  const open = /\w$/.test(words) ? (/\d$/.test(words) ? String.raw`(?![\d.])` : "(?![A-Z_])") : "";
  const pattern = words.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`);
  return new RegExp(String.raw`(?<![\w.])${pattern}${open}`).test(text);
}

/** Whether each word is in some block of a program, comments excluded. */
export function wordMarks(words: readonly string[], text: string): TaskMark[] {
  const program = parse(text);
  const numbers = blockNumbers(program);
  const blocks = program.blocks.map(({ raw, statement: s }) =>
    s.kind === "comment" || s.kind === "structure" ? "" : said(raw),
  );
  return words.map((about, entry) => {
    const found = blocks.findIndex((block) => hasWords(plain(about), block));
    return { rule: "words", passed: found >= 0, about, entry, ...(found >= 0 && { block: numbers[found] ?? 0 }) };
  });
}

/** Whether an answer that passed was made in the way of which the task says what was learned. */
export const isMadeAsLearned = ({ learnedBy = [] }: Pick<Task, "learnedBy">, text: string): boolean =>
  wordMarks(learnedBy, text).every(({ passed }) => passed);
