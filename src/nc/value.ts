import type { Value } from "./statement.ts";

/** A number with point or comma, or a parameter, with an optional sign; blanks may stand behind the sign. */
export const VALUE = String.raw`[+-]?[ \t]*(?:\d+(?:[.,]\d*)?|[.,]\d+|Q[LRS]?\d{1,6})`;

/** Reads what `VALUE` matched; null when the number is beyond what can be counted. */
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
