import type { Parameter, Value } from "./words.ts";

/** A parameter that holds a number, as part of a pattern: Q5, QL1, QR3. No control has more than four digits. */
export const NUMBER_PARAMETER = String.raw`Q[LR]?\d{1,4}(?!\d)`;
/** A parameter that holds text: QS1. */
export const TEXT_PARAMETER = String.raw`QS\d{1,4}(?!\d)`;
/** Any parameter: text parameters may replace names and numbers. */
export const PARAMETER = `(?:${NUMBER_PARAMETER}|${TEXT_PARAMETER})`;
const ALONE = new RegExp(String.raw`^\s*(?:([+-])\s*)?(${PARAMETER})\s*$`, "i");

/** The parameter with its sign, if the text is only a parameter. */
export function parameterOf(text: string): Parameter | null {
  const m = ALONE.exec(text);
  return m ? { parameter: (m[2] ?? "").toUpperCase(), negative: m[1] === "-" } : null;
}

/** A number with point or comma, or a parameter, with an optional sign; blanks may stand behind the sign. */
export const VALUE = String.raw`(?:[+-][ \t]*)?(?:\d+(?:[.,]\d*)?|[.,]\d+|${PARAMETER})`;

/** Reads a match of `VALUE`; null for a number beyond the safe range. */
export function readValue(text: string): Value | null {
  const negative = text.charCodeAt(0) === 45;
  const bare = negative || text.charCodeAt(0) === 43 ? text.slice(1).trimStart() : text;
  const first = bare.charCodeAt(0) | 32;
  if (first === 113) return { parameter: bare.toUpperCase(), negative };
  const size = Number(bare.replace(",", "."));
  if (!Number.isFinite(size)) return null;
  return negative && size !== 0 ? -size : size;
}

/** Reads a label: digits are its number, anything in quotes its name. */
export const readLabel = (digits: string | undefined, name: string | undefined): number | string =>
  digits !== undefined ? Number(digits) : (name ?? "");
