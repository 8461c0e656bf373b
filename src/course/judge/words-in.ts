import { parse } from "../../nc/parse.ts";
import { blockNumbers } from "../../nc/program.ts";
import type { TaskMark } from "./judgement.ts";

/** A text as it is compared: capital letters, one space between words, no plus signs before numbers. */
const plain = (text: string) =>
  text
    .toUpperCase()
    .replaceAll(/\+(?=[\d.])/g, "")
    .replaceAll(/\s+/g, " ")
    .trim();

/** What a block says, without its number and what is remarked in it. */
const said = (raw: string) =>
  plain(
    raw
      .split(/\r?\n/)
      .map((line) => line.replace(/;.*$/, "").replace(/~\s*$/, ""))
      .join(" ")
      .replace(/^\s*\/?\s*\d+\s/, ""),
  );

/**
 * Whether words stand in a text as words of their own: "M13" does not stand in "M136", but "SMAX" in "SMAX2500" does,
 * as a letter that its number follows.
 */
function standsIn(words: string, text: string): boolean {
  const open = /\w$/.test(words) ? (/\d$/.test(words) ? String.raw`(?![\d.])` : "(?![A-Z_])") : "";
  const pattern = words.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`);
  return new RegExp(String.raw`(?<![\w.])${pattern}${open}`).test(text);
}

/** Whether each of the words stands in some block of a program, remarks apart. */
export function wordMarks(words: readonly string[], text: string): TaskMark[] {
  const program = parse(text);
  const numbers = blockNumbers(program);
  const blocks = program.blocks.map(({ raw, statement: s }) =>
    s.kind === "comment" || s.kind === "structure" ? "" : said(raw),
  );
  return words.map((about, entry) => {
    const found = blocks.findIndex((block) => standsIn(plain(about), block));
    return { rule: "words", passed: found >= 0, about, entry, ...(found >= 0 && { block: numbers[found] ?? 0 }) };
  });
}
