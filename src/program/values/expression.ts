import { NUMBER_PARAMETER } from "../../nc/value.ts";

/** Values of Q parameters by upper-case name: "Q5", "QL1", "QR3". */
export type KnownParameters = Readonly<Record<string, number>>;

/** Typed text where a number is expected; `computed` for a sum. */
export type Expression =
  | { readonly kind: "number"; readonly value: number; readonly computed: boolean }
  | { readonly kind: "empty" }
  | {
      readonly kind: "notANumber";
      readonly text: string;
    }
  | { readonly kind: "badExpression"; readonly text: string }
  | { readonly kind: "unknownParameter"; readonly name: string };

/** Longer texts are refused: nobody types them, and the limit bounds the nesting depth. */
const LONGEST = 200;

type Token = { readonly kind: "value"; readonly value: number } | { readonly kind: "sign"; readonly sign: string };
class Unknown {
  constructor(readonly name: string) {}
}

const TOKEN = String.raw`\s*(?:(\d+(?:[.,]\d*)?|[.,]\d+)|(${NUMBER_PARAMETER})|([-+*/()]))\s*`;
const WHOLE_PARAMETER = new RegExp(String.raw`(?<![\w.,])${NUMBER_PARAMETER}(?!\w)`, "gi");

/** Replaces typographic signs by those of a keyboard. */
export const spelling = (text: string) => text.trim().replace(/[−–]/g, "-").replace(/[×·]/g, "*").replace(/÷/g, "/");

/** Splits into numbers and signs; null for anything else. */
function tokens(text: string, known: KnownParameters): Token[] | Unknown | null {
  const found: Token[] = [];
  const pattern = new RegExp(TOKEN, "iy");
  while (pattern.lastIndex < text.length) {
    const match = pattern.exec(text);
    if (!match) return null;
    const [, number, parameter, sign] = match;
    if (number !== undefined) found.push({ kind: "value", value: Number(number.replace(",", ".")) });
    else if (sign !== undefined) found.push({ kind: "sign", sign });
    else if (parameter !== undefined) {
      const name = parameter.toUpperCase();
      const value = Object.hasOwn(known, name) ? known[name] : undefined;
      if (value === undefined || !Number.isFinite(value)) return new Unknown(name);
      found.push({ kind: "value", value });
    }
  }
  return found;
}

/** Value of sum, product, sign and bracket, in the usual order; NaN when the tokens make no sense. */
function evaluate(list: readonly Token[]): number {
  let at = 0;
  const take = (...signs: string[]): string | null => {
    const token = list[at];
    if (token?.kind !== "sign" || !signs.includes(token.sign)) return null;
    at++;
    return token.sign;
  };
  const factor = (): number => {
    const sign = take("-", "+");
    if (sign) return sign === "-" ? -factor() : factor();
    if (take("(")) {
      const inner = sum();
      return take(")") ? inner : NaN;
    }
    const token = list[at++];
    return token?.kind === "value" ? token.value : NaN;
  };
  const product = (): number => {
    let value = factor();
    for (let sign = take("*", "/"); sign; sign = take("*", "/"))
      value = sign === "*" ? value * factor() : value / factor();
    return value;
  };
  const sum = (): number => {
    let value = product();
    for (let sign = take("+", "-"); sign; sign = take("+", "-"))
      value = sign === "+" ? value + product() : value - product();
    return value;
  };
  const value = sum();
  return at === list.length ? value : NaN;
}

/** A size with its deviations, "30 +0.02/-0.01": no quotient, though it would be one by its signs. */
const WITH_DEVIATIONS = /^[\d.,]+\s*[-+]\s*[\d.,]+\s*\/\s*[-+]/;

/**
 * Reads a number with point or comma, a Q parameter, or a sum of both with + - * / ( ). Empty stays empty; unreadable
 * text is reported, never guessed.
 */
export function readExpression(typed: string, known: KnownParameters = {}): Expression {
  const text = spelling(typed);
  if (text === "") return { kind: "empty" };
  const list = text.length > LONGEST || WITH_DEVIATIONS.test(text) ? null : tokens(text, known);
  if (list instanceof Unknown) return { kind: "unknownParameter", name: list.name };
  const value = list ? evaluate(list) : NaN;
  if (list && Number.isFinite(value)) {
    const values = list.filter((token) => token.kind === "value").length;
    return { kind: "number", value: value === 0 ? 0 : value, computed: values > 1 };
  }
  const sum = /^[-+\s]*[\dQ.,(].*[-+*/()]/i.test(text);
  return { kind: sum ? "badExpression" : "notANumber", text: typed.trim() };
}

/** Q parameters in a typed text, in their order. */
export const parametersIn = (typed: string): readonly string[] =>
  typed.length > LONGEST ? [] : [...typed.matchAll(WHOLE_PARAMETER)].map(([name]) => name.toUpperCase());
