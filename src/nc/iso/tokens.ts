import { Scan } from "../scan.ts";
import type { Value } from "../words.ts";
import { NUMBER_PARAMETER, readValue, VALUE } from "../value.ts";

/** One word of a block. */
export interface IsoToken {
  /** Address in capitals: G, X, DL, MB …; "P" for P01, "Q" for a Q parameter, "" for unknown text. */
  readonly letter: string;
  /** Code of G and D, index of P. */
  readonly number: number | null;
  readonly value: Value | null;
  /** FMAX, FAUTO, MB MAX. */
  readonly special: "max" | "auto" | null;
  /** Text in quotes; the name of a Q parameter. */
  readonly text: string | null;
  /** As it is written. */
  readonly raw: string;
  /** Offset in the text of the block. */
  readonly at: number;
}

const CODE = /([GD])[ \t]*(\d{1,3})(?![\d.,:])/iy;
const INDEXED = new RegExp(String.raw`P[ \t]*(\d{2})[ \t]*(?:(${VALUE})|"([^"]*)")?`, "iy");
const PARAMETER = new RegExp(
  String.raw`(${NUMBER_PARAMETER})[ \t]*=?[ \t]*(?:F?[ \t]*(MAX|AUTO)(?![A-Z])|(${VALUE})(?![ \t]*=))?`,
  "iy",
);
const FEED = /F[ \t]*(MAX|AUTO)(?![A-Z])/iy;
const WORD = new RegExp(
  String.raw`(DL|DR|MB|F[UZ](?![A-PR-Z])|[ABCFHIJKLMRSTUVWXYZ])[ \t]*(?:(MAX)(?![A-Z])|(${VALUE})|"([^"]*)")?`,
  "iy",
);

/** Q05 of older programs is Q5. */
function plainValue(text: string | undefined): Value | null {
  const value = text === undefined ? null : readValue(text);
  return typeof value === "object" && value !== null ? { ...value, parameter: plainName(value.parameter) } : value;
}
const plainName = (name: string) => name.toUpperCase().replace(/^(Q[LRS]?)0+(?=\d)/, "$1");
const specialOf = (word: string | undefined) =>
  word === undefined ? null : word.toUpperCase() === "MAX" ? "max" : "auto";

/** Splits a block into words, with or without blanks between them; never throws. Unknown text has an empty letter. */
export function isoTokens(text: string): IsoToken[] {
  const scan = new Scan(text, 0);
  const tokens: IsoToken[] = [];
  while (!scan.done) {
    const at = scan.at;
    const add = (letter: string, more: Partial<IsoToken>) =>
      tokens.push({
        letter,
        number: null,
        value: null,
        special: null,
        text: null,
        raw: text.slice(at, scan.at).trim(),
        at,
        ...more,
      });
    let m: RegExpExecArray | null;
    if ((m = scan.take(CODE))) add((m[1] ?? "").toUpperCase(), { number: Number(m[2]) });
    else if ((m = scan.take(INDEXED))) add("P", { number: Number(m[1]), value: plainValue(m[2]), text: m[3] ?? null });
    else if ((m = scan.take(PARAMETER)))
      add("Q", { text: plainName(m[1] ?? ""), special: specialOf(m[2]), value: plainValue(m[3]) });
    else if ((m = scan.take(FEED))) add("F", { special: specialOf(m[1]) });
    else if ((m = scan.take(WORD)))
      add((m[1] ?? "").toUpperCase(), { special: specialOf(m[2]), value: plainValue(m[3]), text: m[4] ?? null });
    else {
      scan.word();
      add("", {});
    }
  }
  return tokens;
}
