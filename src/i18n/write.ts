import type { Kind } from "../cycles/params.ts";
import type { Language } from "./languages.ts";
import { formatNumber, formatSigned } from "./number.ts";

/** Numbers inside sentences, in the way of one language. X data are diameters, mm. */
export interface Write {
  /** Millimetres or a plain number. */
  readonly number: (value: number) => string;
  /** A value of the field in question: with ⌀ where it is a diameter, with ° where it is an angle. */
  readonly value: (value: number) => string;
  readonly diameter: (value: number) => string;
  readonly angle: (value: number) => string;
  /** A position with its sign: +55. */
  readonly signed: (value: number) => string;
  /** mm² of the half plane. */
  readonly area: (value: number) => string;
  /** Typed or read text, cut short where it is long. */
  readonly text: (text: string) => string;
  /** A place: X⌀50 Z-20. */
  readonly place: (x: number, z: number) => string;
  /** A place of the working plane: X-5 Y+5 while milling, X⌀50 Z-20 in turning. */
  readonly spot: (x: number, y: number | undefined, z: number | undefined) => string;
}

/** Longer quotations say no more. */
const LONGEST = 40;

const isDiameter = (kind: Kind | undefined) => kind === "diameter" || kind === "oversizeDiameter";

/** Formats numbers for a language; `kind` is what the field in question measures. */
export function writer(language: Language, kind?: Kind): Write {
  const number = (value: number) => formatNumber(language, value);
  const diameter = (value: number) => `⌀${number(value)}`;
  /** Four decimals: some limits have them, and they must not be rounded past themselves. */
  const full = (value: number) => formatNumber(language, value, 4);
  const angle = (value: number) => `${full(value)}°`;
  const plain = kind === "angle" ? angle : full;
  const place = (x: number, z: number) => `X⌀${number(x)} Z${formatSigned(language, z)}`;
  return {
    number,
    value: isDiameter(kind) ? diameter : plain,
    diameter,
    signed: (value) => formatSigned(language, value),
    angle,
    area: (value) => `${formatNumber(language, value, value < 0.1 ? 3 : 2)} mm²`,
    text: (text) => (text.length > LONGEST ? `${text.slice(0, LONGEST - 1)}…` : text),
    place,
    spot: (x, y, z) => (y === undefined ? place(x, z ?? 0) : `X${formatSigned(language, x)} Y${formatSigned(language, y)}`),
  };
}
