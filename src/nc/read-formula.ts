import type { Scan } from "./scan.ts";
import { readNumberOfText } from "./read-text.ts";
import { FUNCTION_NUMBERS, type Formula, type FunctionNumber } from "./words.ts";
import { PARAMETER } from "./value.ts";

const TARGET = new RegExp(String.raw`(${PARAMETER})[ \t]*=`, "iy");
const UNDEFINED = /SET[ \t]+UNDEFINED(?![A-Z])/iy;
const NUMBER = new RegExp(String.raw`(?:\d+(?:[.,]\d*)?|[.,]\d+|${PARAMETER}|PI(?![A-Z]))`, "iy");
const CALL = /(SIN|COS|TAN|ASIN|ACOS|ATAN|SQRT|SQ|LN|LOG|EXP|NEG|INT|ABS|FRAC|SGN)(?![A-Z])/iy;
const FN = /FN[ \t]*(1?\d)[ \t]*:/iy;
/** Functions of one value. Only FN 5 may omit the function word, as older programs do. */
const FN_CALL: Readonly<Record<number, { readonly word: RegExp; readonly name: string }>> = {
  5: { word: /(?:SQRT(?![A-Z]))?/iy, name: "SQRT" },
  6: { word: /SIN(?![A-Z])/iy, name: "SIN" },
  7: { word: /COS(?![A-Z])/iy, name: "COS" },
};
/** Operators of functions with two values. */
const FN_SIGN: Readonly<
  Record<
    string,
    { readonly sign: RegExp; readonly kind: "sum" | "difference" | "product" | "quotient" | "length" | "angle" }
  >
> = {
  1: { sign: /\+/y, kind: "sum" },
  2: { sign: /-/y, kind: "difference" },
  3: { sign: /\*/y, kind: "product" },
  4: { sign: /DIV(?![A-Z])|\//iy, kind: "quotient" },
  8: { sign: /LEN(?![A-Z])/iy, kind: "length" },
  13: { sign: /ANG(?![A-Z])/iy, kind: "angle" },
};
/** Deeper nesting than anyone writes is refused, so that the reader never runs out of stack. */
const DEEPEST = 50;
/** So are longer chains, since a chain nests as well. */
const LONGEST = 500;

/** Reads sum, product, power, sign, call and bracket with the usual precedence; null for an invalid formula. */
class FormulaReader {
  private depth = 0;
  private values = 0;
  constructor(private readonly scan: Scan) {}

  sum(): Formula | null {
    let left = this.product();
    for (let m = left && this.scan.take(/[+-]/y); left && m; m = this.scan.take(/[+-]/y)) {
      const right = this.product();
      left = right && { kind: m[0] === "+" ? "sum" : "difference", left, right };
    }
    return left;
  }

  private product(): Formula | null {
    let left = this.power();
    for (let m = left && this.scan.take(/[*/%]/y); left && m; m = this.scan.take(/[*/%]/y)) {
      const right = this.power();
      left = right && { kind: m[0] === "*" ? "product" : m[0] === "/" ? "quotient" : "remainder", left, right };
    }
    return left;
  }

  /** Powers are evaluated from the right, all other operators from the left. */
  private power(): Formula | null {
    const left = this.factor();
    if (!left || !this.scan.take(/\^/y)) return left;
    const right = this.power();
    return right && { kind: "power", left, right };
  }

  factor(): Formula | null {
    if (this.depth >= DEEPEST || this.values >= LONGEST) return null;
    this.depth += 1;
    this.values += 1;
    const formula = this.bare();
    this.depth -= 1;
    return formula;
  }

  private bare(): Formula | null {
    const sign = this.scan.take(/[+-]/y);
    if (sign) {
      const of = this.factor();
      if (sign[0] === "+" || !of) return of;
      return of.kind === "value" ? negated(of) : { kind: "negative", of };
    }
    if (this.scan.take(/\(/y)) {
      const inner = this.sum();
      return inner && this.scan.take(/\)/y) ? inner : null;
    }
    const ofText = readNumberOfText(this.scan);
    if (ofText) return ofText;
    const call = this.scan.take(CALL);
    if (call) {
      const of = this.factor();
      return of && { kind: "call", name: (call[1] ?? "").toUpperCase(), of };
    }
    const m = this.scan.take(NUMBER);
    if (!m) return null;
    if (/^pi/i.test(m[0])) return { kind: "value", value: Math.PI };
    const value = this.scan.value(m[0]);
    return value === null ? null : { kind: "value", value };
  }
}

function negated(f: Extract<Formula, { kind: "value" }>): Formula {
  const { value } = f;
  if (typeof value === "number") return { kind: "value", value: value === 0 ? 0 : -value };
  return { kind: "value", value: { ...value, negative: !value.negative } };
}

/** A parameter and its new value. */
export interface Assignment {
  readonly fn: FunctionNumber | null;
  readonly target: string;
  readonly formula: Formula;
}

/** Reads `FN 1: Q1 = +Q2 + +5` and `Q1 = Q2 * ( 3 + Q4 )`; null when it is neither. Chains nest to the left. */
export function readAssignment(scan: Scan): Assignment | null {
  const fn = scan.take(FN);
  const number = fn ? (FUNCTION_NUMBERS.find((n) => n === Number(fn[1])) ?? null) : null;
  const target = scan.take(TARGET);
  if (!target || (fn && number === null)) return null;
  const name = (target[1] ?? "").toUpperCase();
  if (name.startsWith("QS")) return null;
  const reader = new FormulaReader(scan);
  if (scan.take(UNDEFINED)) return scan.done ? { fn: number, target: name, formula: { kind: "undefined" } } : null;
  const formula = number === null ? reader.sum() : twoValues(scan, reader, number);
  return formula && scan.done ? { fn: number, target: name, formula } : null;
}

function twoValues(scan: Scan, reader: FormulaReader, fn: FunctionNumber): Formula | null {
  const call = FN_CALL[fn];
  if (call) {
    const of = scan.take(call.word) && reader.factor();
    return of && { kind: "call", name: call.name, of };
  }
  const left = reader.factor();
  const between = FN_SIGN[fn];
  if (!left || !between) return left;
  if (!scan.take(between.sign)) return null;
  const right = reader.factor();
  return right && { kind: between.kind, left, right };
}
