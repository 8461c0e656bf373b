import { Scan } from "./scan.ts";
import { PARAMETER } from "./value.ts";

/** The kind of a token, for colouring. */
export type TokenKind =
  | "number"
  | "keyword"
  | "parameter"
  | "value"
  | "word"
  | "comment"
  | "structure"
  | "string"
  | "name"
  | "mark";

/** A token of one line, from and to in characters. */
export interface Token {
  readonly kind: TokenKind;
  readonly from: number;
  readonly to: number;
}

const HEAD = /(\/)?[ \t]*([Nn]?\d{1,9}(?![\d.,]))?[ \t]*(\/)?/y;
const KEYWORD = new RegExp(
  String.raw`(?:CYCLE?[ \t]*(?:DEF|CALL)(?:[ \t]+(?:POS|PAT)(?![A-Z]))?|(?:BEGIN|END)[ \t]+PGM|` +
    String.raw`BLK[ \t]+FORM(?:[ \t]+(?:CYLINDER|ROTATION|FILE))?|` +
    String.raw`TOOL[ \t]+(?:CALL|DEF)|CALL[ \t]+LBL|SEL[ \t]+CONTOUR|TRANS[ \t]+[A-Z]+(?:[ \t]+(?:AXIS|RESET))?|GOTO[ \t]+LBL|IF|` +
    String.raw`FUNCTION(?:[ \t]+(?:MODE[ \t]+(?:TURN|MILL)|TURNDATA[ \t]+(?:SPIN|BLANK|CORR-(?:TCS|WPL)(?::[A-Z](?:\/[A-Z])?)?)))?|` +
    String.raw`FN[ \t]*\d+[ \t]*:|F(?:SELECT|POL|LT|CT|L|C)|LBL|STOP|APPR(?:[ \t]+[A-Z]+)?|DEP(?:[ \t]+[A-Z]+)?|` +
    String.raw`UDC(?:[ \t]+[A-Z_]+)?|GRV(?:[ \t]+[A-Z]+)?|` +
    String.raw`RND|CHF|CTP|CR|CT|CC|CP|LP|L|C)(?![A-Z_])`,
  "iy",
);
const STRUCTURE = /\*[ \t]*-?.*/y;
const COMMENT = /;.*/y;
const STRING = /"[^"]*"?/y;
const CYCLE_NUMBER = /\d+(?:[ \t]*\.\d+)?/y;
const NAMED = new RegExp(PARAMETER, "iy");
const ADDRESS = new RegExp(
  String.raw`(?:DR(?=[+-](?![\d.,Q]))|F[ \t]*(?:MAX|AUTO)|VCONST|SMAX|DIST|LEN|CCA|REP|VC|I?P[RA]|R[0LR](?![\d.,])|DI|DL|DR|` +
    String.raw`F[UZ]?|M|I?[A-Z](?=[ \t]*:?[+\-\d.,Q])|[A-Z_]{2,})`,
  "iy",
);
const VALUE = /[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)/y;
const MARK = /[~=:+\-*/()%^]/y;
/** Keywords followed by a free name, not by words with values. */
const NAMES = /^(?:CYCLE?[ \t]*DEF|BEGIN|END)/i;

/** Splits one line into tokens for colouring, without blanks and plain text; never throws. */
export function tokensOf(line: string): Token[] {
  const scan = new Scan(line, 0);
  const tokens: Token[] = [];
  const add = (kind: TokenKind, m: RegExpExecArray | null): boolean => {
    if (!m || m[0] === "") return false;
    tokens.push({ kind, from: scan.at - m[0].length, to: scan.at });
    return true;
  };
  const head = scan.take(HEAD);
  if (head && head[0].trim() !== "") {
    const from = scan.at - head[0].length;
    tokens.push({ kind: "number", from, to: from + head[0].trimEnd().length });
  }
  if (add("structure", scan.take(STRUCTURE))) return tokens;
  const keyword = scan.take(KEYWORD);
  add("keyword", keyword);
  const named = keyword !== null && NAMES.test(keyword[0]);
  if (named) add("value", scan.take(CYCLE_NUMBER));
  while (!scan.done) {
    if (add("comment", scan.take(COMMENT))) break;
    if (add("string", scan.take(STRING)) || add("parameter", scan.take(NAMED))) continue;
    if (named && !line.slice(scan.at).startsWith("~")) {
      const from = scan.at;
      const word = scan.word().replace(/[;~].*/, "");
      scan.at = from + Math.max(1, word.length);
      tokens.push({ kind: "name", from, to: scan.at });
      continue;
    }
    if (add("word", scan.take(ADDRESS)) || add("value", scan.take(VALUE)) || add("mark", scan.take(MARK))) continue;
    scan.at += 1;
  }
  return tokens;
}
