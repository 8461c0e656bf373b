import type { Scan } from "./scan.ts";
import type { Formula, TextFormula, Value } from "./words.ts";
import { readValue, TEXT_PARAMETER, VALUE } from "./value.ts";

/** How an assignment of text begins, as part of a pattern. */
export const TEXT_ASSIGNMENT = String.raw`(?:DECLARE[ \t]+STRING[ \t]+)?${TEXT_PARAMETER}[ \t]*=`;
const TARGET = new RegExp(String.raw`(DECLARE[ \t]+STRING[ \t]+)?(${TEXT_PARAMETER})[ \t]*=`, "iy");
const QUOTED = /"([^"]*)"/y;
const NAMED = new RegExp(`(${TEXT_PARAMETER})`, "iy");
const OPEN = /\(/y;
const CLOSE = /\)/y;
const JOIN = /\|\|/y;
const word = (name: string) => new RegExp(String.raw`${name}[ \t]*(${VALUE})`, "iy");
const [DATA, DECIMALS, BEGIN, LENGTH] = [word("DAT"), word("DECIMALS"), word("BEG"), word("LEN")] as const;
const source = (name: string) => new RegExp(String.raw`${name}_[ \t]*(?:"([^"]*)"|(${TEXT_PARAMETER}))`, "iy");
const [SOURCE, SEARCHED] = [source("SRC"), source("SEA")] as const;
const FUNCTION = /(TOCHAR|SUBSTR)(?![A-Z])/iy;
const NUMBER_OF_TEXT = /(TONUMB|INSTR|STRLEN|STRCOMP)(?![A-Z])/iy;
/** Longer chains are refused: nobody writes them. */
const LONGEST = 200;

const valueIn = (scan: Scan, pattern: RegExp): Value | null => {
  const m = scan.take(pattern);
  return m && readValue(m[1] ?? "");
};

const textIn = (scan: Scan, pattern: RegExp): TextFormula | null => {
  const m = scan.take(pattern);
  if (!m) return null;
  return m[2] === undefined
    ? { kind: "quoted", text: m[1] ?? "" }
    : { kind: "parameter", parameter: m[2].toUpperCase() };
};

function onePart(scan: Scan): TextFormula | null {
  const quoted = scan.take(QUOTED);
  if (quoted) return { kind: "quoted", text: quoted[1] ?? "" };
  const held = scan.take(NAMED);
  if (held) return { kind: "parameter", parameter: (held[1] ?? "").toUpperCase() };
  const name = scan.take(FUNCTION)?.[1]?.toUpperCase();
  if (name === undefined || !scan.take(OPEN)) return null;
  let made: TextFormula | null;
  if (name === "TOCHAR") {
    const value = valueIn(scan, DATA);
    made = value === null ? null : { kind: "toChar", value, decimals: valueIn(scan, DECIMALS) };
  } else {
    const of = textIn(scan, SOURCE);
    made = of && { kind: "part", source: of, begin: valueIn(scan, BEGIN), length: valueIn(scan, LENGTH) };
  }
  return scan.take(CLOSE) ? made : null;
}

/** Text in quotes, a QS parameter, a function of them, or several joined by `||`; null for anything else. */
function readText(scan: Scan): TextFormula | null {
  const parts: TextFormula[] = [];
  do {
    const part = onePart(scan);
    if (!part || parts.length >= LONGEST) return null;
    parts.push(part);
  } while (scan.take(JOIN));
  return parts.length === 1 ? (parts[0] ?? null) : { kind: "joined", parts };
}

/** A text parameter and its new text. */
export interface TextAssignment {
  readonly declared: boolean;
  readonly target: string;
  readonly text: TextFormula;
}

/** `QS1 = QS2 || "A"` and `DECLARE STRING QS1 = "A"`; null for what is read from the machine. */
export function readTextAssignment(scan: Scan): TextAssignment | null {
  const target = scan.take(TARGET);
  const text = target && readText(scan);
  if (!text || !scan.done) return null;
  return { declared: target[1] !== undefined, target: (target[2] ?? "").toUpperCase(), text };
}

/** A numeric function of texts: length, search, conversion, comparison. Null without one. */
export function readNumberOfText(scan: Scan): Formula | null {
  const name = scan.take(NUMBER_OF_TEXT)?.[1]?.toUpperCase() as
    | Extract<Formula, { kind: "ofText" }>["name"]
    | undefined;
  if (name === undefined || !scan.take(OPEN)) return null;
  const of = textIn(scan, SOURCE);
  const search = textIn(scan, SEARCHED);
  const begin = valueIn(scan, BEGIN);
  const needsSearch = name === "INSTR" || name === "STRCOMP";
  if (!of || needsSearch !== (search !== null) || !scan.take(CLOSE)) return null;
  return { kind: "ofText", name, source: of, search, begin };
}
