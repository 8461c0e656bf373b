import { SCREEN_LANGUAGES, type Language } from "./languages.ts";

/** The decimal sign of a screen language. */
export const decimalSign = (language: Language): "." | "," => SCREEN_LANGUAGES[language].decimal;

const sign = (language: Language, text: string) => text.replace(".", decimalSign(language));

/** A fixed number that never shows "-0" nor an exponent. */
function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return "–";
  const text = Math.abs(value) < 1e21 ? value.toFixed(decimals) : String(Math.sign(value) * 1e21);
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text;
}

/** A number for running text: at most `decimals`, no trailing zeros: 25.4, 0,5. */
export function formatNumber(language: Language, value: number, decimals = 3): string {
  const text = fixed(value, decimals);
  return sign(language, text.includes(".") ? text.replace(/\.0+$|(?<!0)0+$/, "") : text);
}

/** A number with a fixed count of decimals, for columns that must not jump: 25.400. */
export const formatFixed = (language: Language, value: number, decimals: number): string =>
  sign(language, fixed(value, decimals));

/** Typed text with the decimal sign of the screen; sums, Q parameters and words stay as they are. */
export const inScreenWriting = (language: Language, text: string): string =>
  /^[+-]?\d*(?:\.\d*)?$/.test(text.trim()) ? sign(language, text) : text;

/** A text with its numbers in the writing of the screen: "Q493 50.5" as "Q493 50,5". */
export const numbersInScreenWriting = (language: Language, text: string): string =>
  text.replace(/(?<=\d)\.(?=\d)/g, decimalSign(language));

/** The same text with a minus sign as wide as a plus, for print. */
export const withPrintedMinus = (text: string): string => text.replace(/^-/, "−");

/** As the control shows positions: sign and three decimals: +25.400. */
export function formatPosition(language: Language, value: number, decimals = 3): string {
  const text = fixed(value, decimals);
  return sign(language, text.startsWith("-") || text === "–" ? text : `+${text}`);
}

/** Signed and without trailing zeros, as NC text writes values, but with the decimal sign of the language: +0,5. */
export function formatSigned(language: Language, value: number, decimals = 3): string {
  const text = formatNumber(language, value, decimals);
  return text.startsWith("-") || text === "–" ? text : `+${text}`;
}
