import type { Value } from "./words.ts";

/** Number format: plus sign or not, decimal point or comma. */
export interface NumberStyle {
  readonly plus: boolean;
  readonly decimal: "." | ",";
}

/** Digits of a number without sign and without an exponent, which no control reads. */
function digits(size: number): string {
  const text = String(size);
  const m = /^(\d)(?:\.(\d+))?e([+-]\d+)$/.exec(text);
  if (!m) return text;
  const all = (m[1] ?? "") + (m[2] ?? "");
  const point = 1 + Number(m[3]);
  return point > 0 ? all.padEnd(point, "0") : `0.${"0".repeat(-point)}${all}`;
}

/** A value with its sign, `+75` or `+Q5`; `plus: false` leaves the plus sign out. */
export function valueText(value: Value, style: NumberStyle): string {
  const negative = typeof value === "number" ? value < 0 : value.negative;
  const bare = typeof value === "number" ? digits(Math.abs(value)).replace(".", style.decimal) : value.parameter;
  return (negative ? "-" : style.plus ? "+" : "") + bare;
}
