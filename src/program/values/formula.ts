import type { Formula, TextFormula, Value } from "../../nc/words.ts";
import { inDegrees, radians } from "../../kernel/units.ts";

/** Why a value has no number. */
export type EvaluationError =
  | { readonly kind: "unset"; readonly name: string }
  | { readonly kind: "zero" }
  | { readonly kind: "notFinite" };
/** Q parameters while a program runs, by name. */
export type Parameters = Pick<ReadonlyMap<string, number>, "get">;
/** QS parameters while a program runs, by name. */
export type Texts = Pick<ReadonlyMap<string, string>, "get">;
const NO_TEXTS: Texts = new Map();

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

/** Number of a value; trouble for an unset parameter. */
export function valueOf(value: Value, parameters: Parameters): number | EvaluationError {
  if (typeof value === "number") return value;
  const found = parameters.get(value.parameter);
  if (found === undefined) return { kind: "unset", name: value.parameter };
  return value.negative ? -found : found;
}

/** Text of a text formula; trouble for a parameter without text. */
export function textOf(f: TextFormula, parameters: Parameters, texts: Texts): string | EvaluationError {
  switch (f.kind) {
    case "quoted":
      return f.text;
    case "parameter":
      return texts.get(f.parameter) ?? { kind: "unset", name: f.parameter };
    case "joined": {
      let joined = "";
      for (const part of f.parts) {
        const text = textOf(part, parameters, texts);
        if (typeof text !== "string") return text;
        joined += text;
        if (joined.length > LONGEST_TEXT) return { kind: "notFinite" };
      }
      return joined;
    }
    case "toChar": {
      const n = valueOf(f.value, parameters);
      const decimals = f.decimals === null ? null : valueOf(f.decimals, parameters);
      if (typeof n !== "number") return n;
      if (decimals !== null && typeof decimals !== "number") return decimals;
      return decimals === null
        ? String(Number(n.toFixed(3)))
        : n.toFixed(Math.min(10, Math.max(0, Math.trunc(decimals))));
    }
    case "part": {
      const source = textOf(f.source, parameters, texts);
      if (typeof source !== "string") return source;
      const begin = f.begin === null ? 0 : valueOf(f.begin, parameters);
      const length = f.length === null ? source.length : valueOf(f.length, parameters);
      if (typeof begin !== "number") return begin;
      return typeof length === "number"
        ? source.slice(Math.max(0, begin), Math.max(0, begin) + Math.max(0, length))
        : length;
    }
  }
}

/** Limit of joined texts, far beyond any control: a loop would fill the memory. */
const LONGEST_TEXT = 10_000;

/** Number from a text function; positions count from 0, a missing text is at the end. */
function numberOfText(
  f: Extract<Formula, { kind: "ofText" }>,
  parameters: Parameters,
  texts: Texts,
): number | EvaluationError {
  const source = textOf(f.source, parameters, texts);
  if (typeof source !== "string") return source;
  const search = f.search && textOf(f.search, parameters, texts);
  if (search !== null && typeof search !== "string") return search;
  const begin = f.begin === null ? 0 : valueOf(f.begin, parameters);
  if (typeof begin !== "number") return begin;
  if (f.name === "STRLEN") return source.length;
  if (f.name === "TONUMB") return source.trim() === "" ? NaN : Number(source.trim().replace(",", "."));
  if (f.name === "STRCOMP") return source === search ? 0 : source < (search ?? "") ? -1 : 1;
  const at = source.indexOf(search ?? "", begin);
  return at < 0 ? source.length : at;
}

/** Evaluates the right side of an assignment. Angles in degrees, as on the control. */
export function formulaOf(f: Formula, parameters: Parameters, texts: Texts = NO_TEXTS): number | EvaluationError {
  const result = compute(f, parameters, texts);
  return typeof result === "number" && !Number.isFinite(result) ? { kind: "notFinite" } : result;
}

/** The angle of a right triangle between 0° and 360°, from its opposite and its adjacent side. */
const angleOf = (opposite: number, adjacent: number) => (inDegrees(Math.atan2(opposite, adjacent)) + 360) % 360;

function compute(f: Formula, parameters: Parameters, texts: Texts): number | EvaluationError {
  if (f.kind === "value") return valueOf(f.value, parameters);
  if (f.kind === "ofText") return numberOfText(f, parameters, texts);
  if (f.kind === "undefined") return { kind: "notFinite" };
  if (f.kind === "call" || f.kind === "negative") {
    const of = compute(f.of, parameters, texts);
    if (typeof of !== "number") return of;
    return f.kind === "negative" ? -of : (CALLS[f.name]?.(of) ?? NaN);
  }
  const left = compute(f.left, parameters, texts);
  if (typeof left !== "number") return left;
  const right = compute(f.right, parameters, texts);
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
    case "length":
      return Math.hypot(left, right);
    case "angle":
      return angleOf(left, right);
  }
}
