import type { Kind, Param } from "../../../cycles/params.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatFixed, formatNumber, formatPosition } from "../../../i18n/number.ts";
import type { FieldReading } from "../../../program/values/field.ts";
import { valueAsTyped } from "../../../program/values/typed-value.ts";

/** Decimals shown of each value in the list of prompts. */
const SHOWN = 3;

/**
 * A read value as the list of prompts shows it: positions with their sign, three decimals. `toInches` converts it for an
 * inch program, with one decimal more.
 */
export function writeValue(
  language: Language,
  param: Param,
  field: FieldReading,
  toInches: ((mm: number) => number) | null = null,
): string | null {
  const { value, written } = field;
  if (written === "auto") return "FAUTO";
  if (value === null) return null;
  if (typeof written === "object" && written !== null) return valueAsTyped(written);
  if (param.kind === "choice" || param.kind === "count") return String(value);
  const signed = param.range[0] < 0;
  const [shown, decimals] = toInches ? [toInches(value), SHOWN + 1] : [value, SHOWN];
  return signed ? formatPosition(language, shown, decimals) : formatFixed(language, shown, decimals);
}

/** A value as one types it. */
export const writeTyped = (language: Language, value: number, decimals: number): string =>
  formatNumber(language, value, decimals);

type UnitName =
  | "diameter"
  | "radius"
  | "axial"
  | "degrees"
  | "perRevolution"
  | "perMinute"
  | "percent"
  | "revolutions"
  | "none";

const units: Readonly<Record<Exclude<Kind, "feed">, UnitName>> = {
  choice: "none",
  diameter: "diameter",
  oversizeDiameter: "diameter",
  radial: "radius",
  axial: "axial",
  axialDepth: "axial",
  length: "axial",
  angle: "degrees",
  count: "none",
  factor: "none",
  percent: "percent",
  revolutions: "revolutions",
};

/** Unit of a parameter. */
export const unitOf = (param: Param, perRevolution: boolean): UnitName =>
  param.kind === "feed" ? (perRevolution && !param.perMinute ? "perRevolution" : "perMinute") : units[param.kind];
