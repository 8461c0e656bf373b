import type { LengthUnit } from "../kernel/units.ts";
import type { Language } from "./languages.ts";
import { formatFixed, formatNumber, formatPosition, formatSigned } from "./number.ts";

/** The reader: a program's unit with its language, or a language alone for mm. */
export type Spoken = Language | Lengths;

/** Additional decimals of a length in inches compared with millimetres, and of an area. */
const MORE = 1,
  MORE_OF_AREA = 3;

/** mm³ in a cm³. */
const CUBIC_CM = 1000;

/**
 * How lengths are written for a program's unit. Input: lengths and feeds in mm, areas in mm²; `decimals` are those of
 * millimetres.
 */
export interface Lengths {
  readonly language: Language;
  readonly unit: LengthUnit;
  /** mm in one of the unit. */
  readonly per: number;
  readonly number: (mm: number, decimals?: number) => string;
  readonly fixed: (mm: number, decimals: number) => string;
  readonly signed: (mm: number) => string;
  readonly position: (mm: number) => string;
  readonly area: (mm2: number, decimals: number) => string;
  readonly fixedArea: (mm2: number, decimals: number) => string;
  /** cm³ of a body, with its unit. */
  readonly volume: (cm3: number) => string;
  /** A text with its units converted to the program's: inch for mm, inch² for mm², µin for µm. */
  readonly words: (text: string) => string;
}

/** `per`: mm in one of the unit. */
export function lengthsIn(language: Language, unit: LengthUnit, per: number): Lengths {
  const isInch = unit === "inch",
    more = isInch ? MORE : 0,
    ofArea = isInch ? MORE_OF_AREA : 0;
  return {
    language,
    unit,
    per,
    number: (mm, decimals = 3) => formatNumber(language, mm / per, decimals + more),
    fixed: (mm, decimals) => formatFixed(language, mm / per, decimals + more),
    signed: (mm) => formatSigned(language, mm / per, 3 + more),
    position: (mm) => formatPosition(language, mm / per, 3 + more),
    area: (mm2, decimals) => formatNumber(language, mm2 / per ** 2, decimals + ofArea),
    fixedArea: (mm2, decimals) => formatFixed(language, mm2 / per ** 2, decimals + ofArea),
    volume: (cm3) =>
      isInch
        ? `${formatNumber(language, (cm3 * CUBIC_CM) / per ** 3, 3)}\u00a0inch³`
        : `${formatNumber(language, cm3, 2)}\u00a0cm³`,
    words: (text) => (isInch ? text.replace(/\bmm\b/g, unit).replace(/µm\b/g, "µin") : text),
  };
}
