import type { Kind } from "../cycles/params.ts";
import { lengthsIn, type Spoken } from "./lengths.ts";
import { formatNumber } from "./number.ts";

/** Formats numbers in sentences for a language and for the unit of the program. X data are diameters, mm. */
export interface Write {
  /** A plain number. */
  readonly number: (value: number) => string;
  /** A length, mm, in the program's unit; with that unit. */
  readonly size: (mm: number, decimals?: number) => string;
  readonly length: (mm: number) => string;
  /** A feed in mm per minute or revolution, as `unit` says in the language; converted with its unit. */
  readonly feed: (mm: number, unit: string) => string;
  /** A value of the field concerned: with ⌀ for a diameter, with ° for an angle. */
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
  /** A place in the working plane: X-5 Y+5 in milling, X⌀50 Z-20 in turning. */
  readonly spot: (x: number, y: number | undefined, z: number | undefined) => string;
}

/** Longer quotations are cut, characters. */
const LONGEST = 40;

/** Quantities other than lengths, the same in any unit. A feed is shown as the program is read. */
const NO_LENGTH: ReadonlySet<string | undefined> = new Set([
  "choice",
  "angle",
  "feed",
  "count",
  "factor",
  "percent",
  "revolutions",
  undefined,
]);

/** Whether a field measures a length, so that it is shown in the unit of the program. */
export const isLength = (kind: Kind | undefined): boolean => !NO_LENGTH.has(kind);

const isDiameter = (kind: Kind | undefined) => kind === "diameter" || kind === "oversizeDiameter";

/** Formats numbers for a language and the unit of a program; `kind` is the quantity of the field concerned. */
export function writer(spoken: Spoken, kind?: Kind): Write {
  const lengths = typeof spoken === "string" ? lengthsIn(spoken, "mm", 1) : spoken,
    { language, number: size, signed } = lengths;
  const number = (value: number) => formatNumber(language, value);
  const diameter = (value: number) => `⌀${size(value)}`;
  /** Four decimals: some limits have them, and rounding must not move a value past its limit. */
  const full = (value: number) => formatNumber(language, value, 4);
  const angle = (value: number) => `${full(value)}°`;
  const exact = !isLength(kind) ? full : (value: number) => size(value, 4),
    plain = kind === "angle" ? angle : exact;
  const place = (x: number, z: number) => `X⌀${size(x)} Z${signed(z)}`;
  return {
    number,
    size,
    length: (mm) => `${size(mm)}\u00a0${lengths.unit}`,
    feed: (mm, unit) => `${size(mm)}\u00a0${lengths.words(unit)}`,
    value: isDiameter(kind) ? diameter : plain,
    diameter,
    signed,
    angle,
    area: (value) => lengths.words(`${lengths.area(value, value < 0.1 ? 3 : 2)}\u00a0mm²`),
    text: (text) => (text.length > LONGEST ? `${text.slice(0, LONGEST - 1)}…` : text),
    place,
    spot: (x, y, z) => (y === undefined ? place(x, z ?? 0) : `X${signed(x)} Y${signed(y)}`),
  };
}
