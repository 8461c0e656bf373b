import { rounded } from "../units.ts";
import { deviationsOf, type Deviations } from "./fit.ts";

/** Longest text that is read. */
const LONGEST = 60;
const NUMBER = String.raw`(?:\d{1,4}(?:\.\d{1,5})?|\.\d{1,5})`;
/** A class by its letters and grade; capitals are holes. */
const CLASS = /^(JS|Js|js|[a-hjkmnprstuxzA-HJKMNPRSTUXZ])\s?(?:IT\s?)?(\d{1,2})$/;
const BOTH_WAYS = new RegExp(String.raw`^(?:\+\s?/\s?-|±)\s?(${NUMBER})$`);
const PAIR = new RegExp(String.raw`^([+-]\s?${NUMBER}|0)\s?[/; ]\s?([+-]\s?${NUMBER}|0(?:\.0+)?)$`);
const ONE = new RegExp(String.raw`^([+-]\s?${NUMBER})$`);
/** General tolerances of ISO 2768-1: symmetrical, so that they shift nothing. */
const GENERAL = /^(?:(?:DIN\s)?ISO\s)?2768(?:-1)?[\s-]?([fmcv])[HKL]?$/i;

/** One spelling whatever the keyboard: full-width signs, decimal comma, dashes. */
const spelled = (text: string): string =>
  text
    .slice(0, LONGEST)
    .normalize("NFKC")
    .replace(/[−–—‐‑]/g, "-")
    .replace(/(\d),(?=\d)/g, "$1.")
    .replace(/\s+/g, " ")
    .trim();

const numberOf = (signed: string) => Number(signed.replace(" ", ""));

/**
 * Reads a typed tolerance of a nominal size in mm: a class of ISO 286 ("h6", "H7", "js9"), deviations in mm
 * ("+0.02/-0.01", "+0.1", "±0.05"), or general tolerances ("ISO 2768-m", no shift: null deviations count as 0). Null for
 * anything else, for a class that has no values for this size, and for an upper deviation below the lower one.
 */
export function readTolerance(typed: string, size: number): Deviations | null {
  const text = spelled(typed);
  const [, letters, grade] = CLASS.exec(text) ?? [];
  if (letters !== undefined) return deviationsOf(letters === "Js" ? "JS" : letters, Number(grade), size);
  const both = BOTH_WAYS.exec(text)?.[1];
  if (both !== undefined) return { upper: Number(both), lower: -Number(both) };
  const [, first, second] = PAIR.exec(text) ?? [];
  if (first !== undefined && second !== undefined) {
    const [upper, lower] = [numberOf(first), numberOf(second)];
    return upper >= lower ? { upper, lower } : null;
  }
  const one = ONE.exec(text)?.[1];
  if (one !== undefined) return { upper: Math.max(0, numberOf(one)), lower: Math.min(0, numberOf(one)) };
  return GENERAL.test(text) ? { upper: 0, lower: 0 } : null;
}

/** A size with its tolerance, mm. */
export interface ToleratedSize extends Deviations {
  readonly nominal: number;
  /** Middle of the limits on the grid of the control: what is programmed. */
  readonly middle: number;
}

/** The middle of a typed tolerance: nominal size + (upper + lower deviation) / 2, mm; null for an unreadable one. */
export function toleranceMiddle(typed: string, nominal: number): ToleratedSize | null {
  const read = Number.isFinite(nominal) ? readTolerance(typed, Math.abs(nominal)) : null;
  return read && { ...read, nominal, middle: rounded(nominal + (read.upper + read.lower) / 2) };
}

const SIZED = new RegExp(String.raw`^(?:⌀|ø)?\s?(${NUMBER})\s*(?:mm\s+)?([^\d.\s].*|0\s?[/;].*)$`, "i");
/** A size with one deviation, or two without a slash, is a sum. */
const SUM = new RegExp(String.raw`^[+-]\s?${NUMBER}(?:\s?[+-]\s?${NUMBER})?$`);

/**
 * Reads a size with its tolerance in one text: "40 h6", "⌀25H7", "30 +0.02/-0.01", "12±0.1"; null for anything else, also
 * for what is a sum: "40-0.2".
 */
export function readToleratedSize(typed: string): ToleratedSize | null {
  const [, size, tolerance] = SIZED.exec(spelled(typed)) ?? [];
  return size === undefined || tolerance === undefined || SUM.test(tolerance)
    ? null
    : toleranceMiddle(tolerance, Number(size));
}
