import type { LengthUnit } from "../kernel/units.ts";
import type { Language } from "./languages.ts";
import { formatFixed, formatNumber, formatPosition, formatSigned } from "./number.ts";

/** Who is spoken to: somebody whose program counts in a unit, or, with a language alone, in mm. */
export type Spoken = Language | Lengths;

/** Decimals that a length in inches has more than in millimetres, and an area. */
const MORE = 1,
  MORE_OF_AREA = 3;

/** mm³ in a cm³. */
const CUBIC_CM = 1000;

/**
 * How lengths are told to somebody whose program counts in a unit. They come in mm, areas in mm², feeds in mm;
 * `decimals` are those of millimetres.
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
  /** A text with units in it, as the program counts: inch for mm, inch² for mm², µin for µm. */
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
        ? `${formatNumber(language, (cm3 * CUBIC_CM) / per ** 3, 3)} inch³`
        : `${formatNumber(language, cm3, 2)} cm³`,
    words: (text) => (isInch ? text.replace(/\bmm\b/g, unit).replace(/µm\b/g, "µin") : text),
  };
}
