import type { Reader } from "./readers.ts";

/** For each character, a walk back to the last quote. */
function quotesBefore(text: string): number {
  let found = 0;
  for (let i = 0; i < text.length; i++) {
    if (text[i] !== '"') continue;
    for (let back = i; back >= 0; back--) found += text[back] === '"' ? 1 : 0;
  }
  return found;
}

/** Each line looked for in a list of those before it. */
function linesOnce(text: string): readonly string[] {
  const known: string[] = [];
  for (const [i, line] of text.split("\n").entries()) if (!known.includes(`${line}${i}`)) known.push(`${line}${i}`);
  return known;
}

/** All text so far trimmed at each assignment. */
function assigned(text: string): number {
  let [all, count] = ["", 0];
  for (const char of text) {
    all += char;
    if (char === "=" && all.trim() !== "") count += 1;
  }
  return count;
}

/** A list of words of a comment that is copied for each of them. */
const words = (text: string): readonly string[] =>
  text.startsWith("1 ;") ? text.split(" ").reduce<readonly string[]>((all, word) => all.concat(word), []) : [];

/** Readers that are not linear, each for a text of its own: the law has to refuse every one of them. */
export const PLANTED: readonly Reader[] = [
  { name: "loop within a loop", read: quotesBefore },
  { name: "list searched", read: linesOnce },
  { name: "text trimmed again", read: assigned },
  { name: "list copied", read: words, frames: [["1 ;", "!"]] },
];
