import type { Formula, Value } from "../nc/statement.ts";
import { inDegrees, radians } from "../kernel/units.ts";

/** Why a value has no number. */
export type Trouble = { readonly kind: "unset"; readonly name: string } | { readonly kind: "zero" } | { readonly kind: "notFinite" };
/** Q parameters while a program runs, by name. */
export type Parameters = Map<string, number>;

const CALLS: Readonly<Record<string, (n: number) => number>> = {
  SIN: (n) => Math.sin(radians(n)),
  COS: (n) => Math.cos(radians(n)),
  TAN: (n) => Math.tan(radians(n)),
  ASIN: (n) => inDegrees(Math.asin(n)),
  ACOS: (n) => inDegrees(Math.acos(n)),
  ATAN: (n) => inDegrees(Math.atan(n)),
  SQRT: Math.sqrt,
  SQ: (n) => n * n,
  LN: Math.log,
  LOG: Math.log10,
  EXP: Math.exp,
  NEG: (n) => -n,
  INT: Math.trunc,
  ABS: Math.abs,
  FRAC: (n) => n - Math.trunc(n),
  SGN: Math.sign,
};

/** The number of a value; trouble when its parameter was never set. */
export function valueOf(value: Value, parameters: Parameters): number | Trouble {
  if (typeof value === "number") return value;
  const found = parameters.get(value.parameter);
  if (found === undefined) return { kind: "unset", name: value.parameter };
  return value.negative ? -found : found;
}

/** Works out the right side of an assignment. Angles are in degrees, as on the control. */
export function formulaOf(f: Formula, parameters: Parameters): number | Trouble {
  const result = compute(f, parameters);
  return typeof result === "number" && !Number.isFinite(result) ? { kind: "notFinite" } : result;
}

function compute(f: Formula, parameters: Parameters): number | Trouble {
  if (f.kind === "value") return valueOf(f.value, parameters);
  if (f.kind === "call" || f.kind === "negative") {
    const of = compute(f.of, parameters);
    if (typeof of !== "number") return of;
    return f.kind === "negative" ? -of : (CALLS[f.name]?.(of) ?? NaN);
  }
  const left = compute(f.left, parameters);
  if (typeof left !== "number") return left;
  const right = compute(f.right, parameters);
  if (typeof right !== "number") return right;
  switch (f.kind) {
    case "sum":
      return left + right;
    case "difference":
      return left - right;
    case "product":
      return left * right;
    case "quotient":
      return right === 0 ? { kind: "zero" } : left / right;
    case "remainder":
      return right === 0 ? { kind: "zero" } : left % right;
    case "power":
      return left ** right;
  }
}
