import { isBlank, isDigit } from "./line-cursor.ts";

/** One line of a file, split into words, number and comment; positions count from 0 within the line. */
export interface FileLine {
  /** From 1. */
  readonly line: number;
  readonly text: string;
  /**
   * Where the words start, behind skip mark and block number, and where they end, before comment and continuation mark.
   */
  readonly from: number;
  readonly to: number;
  /** The block number as digits; empty without one. */
  readonly number: string;
  /** Text in place of the number that is no number; empty if correct. */
  readonly wrongNumber: string;
  /** Where a comment starts; -1 without one. */
  readonly comment: number;
  /** Where a `~` ends the line; -1 without one. */
  readonly tilde: number;
}

/** Longest wrong block number that is quoted. */
const QUOTED = 20;

const isSpace = (c: string) => isBlank(c) || c === "\ufeff" || c === "\f" || c === "\v";

/** Splits at \r\n, \n and a lone \r; a text that ends with a line end has no empty line behind it. */
export function linesOf(text: string): readonly string[] {
  const lines = text.split(/\r\n|\n|\r/);
  if (lines.at(-1) === "") lines.pop();
  return lines;
}

/**
 * Where the comment of a line starts, outside of quotation marks; -1 without one. A mark that is not closed hides none.
 */
function commentOf(text: string, from: number): number {
  let at = from;
  while (at < text.length) {
    const c = text.charAt(at);
    if (c === ";") return at;
    if (c === '"') {
      const close = text.indexOf('"', at + 1);
      if (close < 0) return text.indexOf(";", at);
      at = close;
    }
    at += 1;
  }
  return -1;
}

/** Splits a line. `letter`: the letter in front of a block number, N in DIN/ISO. */
export function fileLine(text: string, line: number, letter: "" | "N"): FileLine {
  let at = 0;
  const spaces = () => {
    while (at < text.length && isSpace(text.charAt(at))) at += 1;
  };
  const mark = () => {
    spaces();
    if (text.charAt(at) === "/") at += 1;
    spaces();
  };
  mark();
  const start = at;
  if (letter !== "" && text.charAt(at).toUpperCase() === letter && isDigit(text.charAt(at + 1))) at += 1;
  const digits = at;
  if (letter === "" || at > start) {
    while (isDigit(text.charAt(at))) at += 1;
  }
  const number = text.slice(digits, at);
  const wrongNumber = wrongOf(text, start, number, letter);
  if (number !== "" || letter === "") mark();
  const comment = commentOf(text, at);
  let end = text.length;
  while (end > at && isSpace(text.charAt(end - 1))) end -= 1;
  const tilde = end > at && text.charAt(end - 1) === "~" ? end - 1 : -1;
  const behind = comment >= 0 ? comment : tilde >= 0 ? tilde : end;
  let to = Math.max(at, behind);
  while (to > at && isSpace(text.charAt(to - 1))) to -= 1;
  return { line, text, from: at, to, number, wrongNumber, comment, tilde };
}

/** Text that looks like a block number but is none: with a sign, a point, or a letter before or within it. */
function wrongOf(text: string, start: number, number: string, letter: "" | "N"): string {
  const behind = start + number.length + (letter !== "" && number !== "" ? 1 : 0);
  const next = text.charAt(behind);
  const c = text.charAt(start);
  const wrong =
    number === ""
      ? (/[+\-.,]/.test(c) && isDigit(text.charAt(start + 1))) ||
        (isDigit(text.charAt(start + 1)) && c.toUpperCase() === "N") ||
        (letter !== "" && isDigit(c))
      : /[.,+\-:]/.test(next);
  if (!wrong) return "";
  let to = start;
  while (to < text.length && to - start < QUOTED && !isSpace(text.charAt(to))) to += 1;
  return text.slice(start, to);
}

/**
 * Where the words of a line end, in front of the `*` of DIN/ISO, which may also stand behind the comment. `isStarred`:
 * blocks end in one.
 */
export function endOfWords(
  { text, from, to, comment }: FileLine,
  isStarred: boolean,
): { readonly to: number; readonly hasStar: boolean } {
  if (!isStarred) return { to, hasStar: false };
  if (to > from && text.charAt(to - 1) === "*") {
    let end = to - 1;
    while (end > from && isSpace(text.charAt(end - 1))) end -= 1;
    return { to: end, hasStar: true };
  }
  let end = text.length;
  while (end > to && isSpace(text.charAt(end - 1))) end -= 1;
  return { to, hasStar: comment >= 0 && text.charAt(end - 1) === "*" };
}

/** A line without words and without a comment. */
export const isEmptyLine = (line: FileLine) =>
  line.from >= line.to && line.comment < 0 && line.number === "" && line.tilde < 0;
/** A line that the control skips: a comment, or a structure item, which starts with `*`. */
export const isRemark = (line: FileLine) =>
  line.from < line.text.length && (line.comment === line.from || line.text.charAt(line.from) === "*");
