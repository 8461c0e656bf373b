import { isDigit, type LineCursor } from "./line-cursor.ts";
import { refuse, type LineRefusal } from "./refusal.ts";

/** The input format of a word: its range, and digits before and after the decimal point. */
export interface NumberFormat {
  readonly least: number;
  readonly most: number;
  readonly before: number;
  readonly after: number;
}
const format = (least: number, most: number, after: number, before = 9): NumberFormat => ({
  least,
  most,
  before,
  after,
});

/* Input formats as the TNC 640 manual prints them; six decimals are taken everywhere, since a parameter holds as many. */
export const POSITION = format(-99999.9999, 99999.9999, 6);
export const DELTA = format(-99.9999, 99.9999, 6);
export const FEED = format(0, 99999.999, 6);
export const SPEED = FEED;
export const LABEL = format(0, 65535, 0);
export const REPEAT = format(1, 65534, 0);
export const TOOL = format(0, 32767.9, 1);
export const M_FUNCTION = format(0, 999, 0);
export const G_FUNCTION = format(0, 999, 0);
export const ERROR_NUMBER = format(0, 1199, 0);
/** Any value that a parameter can hold. */
export const ANY_VALUE = format(-999999999.999999, 999999999.999999, 6);
/** Components of vectors and splines, and constants of formulas: only their form is checked. */
export const LOOSE = format(-Infinity, Infinity, Infinity, Infinity);

/** The highest parameter number of each kind. */
const LAST_PARAMETER: Readonly<Record<string, number>> = { Q: 1999, QS: 1999, QL: 499, QR: 499, QC: 1999 };

/** The kind of a numbered parameter `ahead` of the cursor; empty without one. */
export function parameterKind(cursor: LineCursor, ahead = 0): string {
  if (cursor.char(ahead).toUpperCase() !== "Q") return "";
  if (isDigit(cursor.char(ahead + 1))) return "Q";
  const kind = `Q${cursor.char(ahead + 1).toUpperCase()}`;
  return kind in LAST_PARAMETER && isDigit(cursor.char(ahead + 2)) ? kind : "";
}

/** Takes a parameter that stands here. */
export function takeParameter(cursor: LineCursor): LineRefusal | null {
  const from = cursor.at;
  const kind = parameterKind(cursor);
  cursor.at += kind.length;
  const digits = cursor.digits();
  const most = LAST_PARAMETER[kind] ?? 0;
  return Number(digits) <= most
    ? null
    : refuse(from, "outOfRange", { word: kind, text: digits.slice(0, 40), least: 0, most });
}

/** Whether a number or a parameter follows after blanks; the cursor stays. */
export function valueStarts(cursor: LineCursor): boolean {
  const from = cursor.at;
  cursor.blanks();
  const c = cursor.char();
  const starts = c === "+" || c === "-" || isNumberStart(cursor) || parameterKind(cursor) !== "" || c === "{";
  cursor.at = from;
  return starts;
}

const isPoint = (c: string) => c === "." || c === ",";
const isNumberStart = (cursor: LineCursor) =>
  isDigit(cursor.char()) || (isPoint(cursor.char()) && isDigit(cursor.char(1)));

/** Takes the number, parameter or named parameter after `word`; `numbers`: format of numbers. */
export function takeValue(cursor: LineCursor, word: string, numbers: NumberFormat): LineRefusal | null {
  const start = cursor.at;
  if (!valueStarts(cursor)) return refuse(start, "valueMissing", { word });
  cursor.blanks();
  const from = cursor.at;
  if (cursor.char() === "+" || cursor.char() === "-") {
    cursor.at += 1;
    cursor.blanks();
  }
  if (parameterKind(cursor) !== "") return takeParameter(cursor);
  if (cursor.char() === "{") return takeNamed(cursor);
  return takeNumber(cursor, from, word, numbers);
}

/** `{LENGTH}`: a named parameter of newer software. */
function takeNamed(cursor: LineCursor): LineRefusal | null {
  const close = cursor.text.indexOf("}", cursor.at);
  if (close < 0 || close >= cursor.end) return refuse(cursor.at, "bracketOpen", {});
  cursor.at = close + 1;
  return null;
}

/** Takes digits with a point or comma; `from` is where the sign stands. */
function takeNumber(cursor: LineCursor, from: number, word: string, numbers: NumberFormat): LineRefusal | null {
  const bad = () => {
    while (cursor.char() !== "" && /[\w.,+-]/.test(cursor.char()) && cursor.at - from < 40) cursor.at += 1;
    return refuse(from, "badNumber", { word, text: cursor.text.slice(from, Math.max(cursor.at, from + 1)) });
  };
  if (!isNumberStart(cursor)) return bad();
  const whole = cursor.digits();
  const hasPoint = isPoint(cursor.char());
  if (hasPoint) cursor.at += 1;
  const decimals = hasPoint ? cursor.digits() : "";
  if (isPoint(cursor.char()) && isDigit(cursor.char(1))) return bad();
  const next = cursor.char().toUpperCase();
  const power = cursor.char(1) === "+" || cursor.char(1) === "-" ? cursor.char(2) : cursor.char(1);
  if (next === "E" && isDigit(power)) return bad();
  const text = cursor.text.slice(from, cursor.at);
  const { before, after, least, most } = numbers;
  if (significant(whole) > before || decimals.length > after)
    return refuse(from, "tooManyDigits", { word, text: text.slice(0, 40), before, after });
  const size = Number(`${whole === "" ? "0" : whole}.${decimals === "" ? "0" : decimals}`);
  const value = cursor.text.charAt(from) === "-" ? -size : size;
  return value < least || value > most ? refuse(from, "outOfRange", { word, text, least, most }) : null;
}

/** Number of digits without leading zeros. */
function significant(digits: string): number {
  let zeros = 0;
  while (zeros < digits.length && digits.charAt(zeros) === "0") zeros += 1;
  return digits.length - zeros;
}

/** Takes a label or tool behind `word`: a number, a quoted name, or the parameter that holds either. */
export function takeNumberOrName(cursor: LineCursor, word: string, numbers: NumberFormat): LineRefusal | null {
  const start = cursor.at;
  cursor.blanks();
  if (cursor.char() !== '"') {
    cursor.at = start;
    return takeValue(cursor, word, numbers);
  }
  const from = cursor.at;
  const name = cursor.quoted();
  if (name === null) return refuse(from, "stringOpen", {});
  return name === "" ? refuse(from, "valueMissing", { word }) : null;
}
