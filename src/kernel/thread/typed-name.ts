import { ROUND, SAME } from "../tolerance.ts";

/** A typed name of a thread in a common spelling, with what follows the size taken off. */
export interface TypedName {
  /** Size as typed, with single blanks, "x", "." and "-"; lower case. */
  readonly size: string;
  readonly leftHand: boolean;
  /** Tolerance classes as typed, outside and inside: 6g, 4g6g, 6H, 2A, A. */
  readonly outside?: string;
  readonly inside?: string;
}

const FRACTIONS: Readonly<Record<string, string>> = {
  "½": "1/2",
  "¼": "1/4",
  "¾": "3/4",
  "⅛": "1/8",
  "⅜": "3/8",
  "⅝": "5/8",
  "⅞": "7/8",
};
/** Longest name that is read. */
const LONGEST = 60;

/** Words that say what the symbol already says, in the languages of the screen. */
const WORDS =
  /\b(?:iso|din|asme|ansi|bs|en|jis|gb)\s*(?:b?\d[\d.]*(?:-\d+)?)?(?=[\s:])|\b(?:thread|gewinde|filetage|(?:metric|metrisch(?:es)?|métrique)(?=\s))|螺纹|:/gi;
const INCHES = /["″”“'′]+|\b(?:zoll|inch(?:es)?|pouces?)\b|英寸/gi;
const LEFT = /(?<![\s-])[\s-]*(?:\b(?:lh|left(?:[\s-]?hand(?:ed)?)?|links?|li|gauche|à gauche)\b|左旋?)$/i;
const RIGHT = /(?<![\s-])[\s-]+(?:rh|right(?:[\s-]?hand(?:ed)?)?|rechts|droite)$/i;
/** Grade and position of metric and trapezoidal threads: small letters are external, capitals internal. */
const GRADES =
  /(?:(?<=[\d)])[\s-]*|(?<=[\s-]))\b((?:\d[c-h]){1,2}|(?:\d[C-H]){1,2})(?:\s*\/\s*((?:\d[c-h]){1,2}|(?:\d[C-H]){1,2}))?$/;
/** Classes of unified threads. */
const UNIFIED = /(?<![\s-])[\s-]+([123])([AB])$/i;

/** The same thread in one spelling, whatever the keyboard: full-width digits, ½, Cyrillic letters, decimal comma. */
const spelled = (text: string): string =>
  text
    .slice(0, LONGEST)
    .replace(/[½¼¾⅛⅜⅝⅞]/g, (c) => ` ${FRACTIONS[c] ?? c}`)
    .normalize("NFKC")
    .replace(/[×✕✖*хХ⨯]/g, "x")
    .replace(/М/g, "M")
    .replace(/[⁄∕]/g, "/")
    .replace(/[–—−‐‑]/g, "-")
    .replace(/⌀|ø|Ø/g, "")
    .replace(/(\d),(?=\d)/g, "$1.")
    .replace(WORDS, " ")
    .replace(INCHES, " ");

/** Reads hand and tolerance classes behind a size. */
export function typedName(text: string): TypedName {
  let rest = spelled(text).trim();
  const left = LEFT.exec(rest);
  rest = rest.replace(LEFT, "").replace(RIGHT, "").trim();
  const classes: { outside?: string; inside?: string } = {};
  const grades = GRADES.exec(rest);
  const unified = grades ? null : UNIFIED.exec(rest);
  for (const name of grades?.slice(1) ?? [])
    if (name) classes[name === name.toLowerCase() ? "outside" : "inside"] = name;
  if (unified)
    classes[unified[2]?.toUpperCase() === "A" ? "outside" : "inside"] = unified[0].replace(/[\s-]/g, "").toUpperCase();
  if (grades) rest = rest.slice(0, grades.index);
  if (unified) rest = rest.slice(0, unified.index);
  const size = rest
    .toLowerCase()
    .replace(/(?<![\s-])[\s-]+$/, "")
    .replace(/(?<!\s)\s+(?=[x/-])/g, "")
    .replace(/([x/-])\s+/g, "$1")
    .replace(/\s+/g, " ");
  return { size, leftHand: left !== null, ...classes };
}

/** Text for comparison of names: without blanks. */
export const comparable = (text: string): string => typedName(text).size.replace(/\s/g, "");

/** Inches of 1 1/2, 1-1/2, 3/4, 0.75 or 2; NaN for anything else. */
export function inchesIn(text: string): number {
  const m = /^(?:(\d{1,3})(?:[\s-]+|$))?(?:(\d{1,3})\/(\d{1,3}))?$/.exec(text.trim());
  if (m?.[1] !== undefined || m?.[2] !== undefined) {
    const below = Number(m[3] ?? 1);
    return below > 0 ? Number(m[1] ?? 0) + Number(m[2] ?? 0) / below : NaN;
  }
  return /^\d{0,3}\.\d+$/.test(text.trim()) ? Number(text) : NaN;
}

/** Inches as the trade writes them: 1 1/2; a decimal where no 64th fits. */
export function inchText(inches: number): string {
  const whole = Math.floor(inches + ROUND);
  const parts = Math.round((inches - whole) * 64);
  if (Math.abs(inches - whole - parts / 64) > SAME) return String(inches);
  if (parts === 0) return String(whole);
  let [above, below] = [parts, 64];
  while (above % 2 === 0) [above, below] = [above / 2, below / 2];
  return `${whole > 0 ? `${whole} ` : ""}${above}/${below}`;
}
