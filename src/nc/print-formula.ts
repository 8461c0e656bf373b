import { valueText } from "./number-text.ts";
import type { Assignment } from "./read-formula.ts";
import type { TextAssignment } from "./read-text.ts";
import type { Formula, TextFormula, Value } from "./words.ts";
import type { Style } from "./style.ts";

const SIGNS = {
  sum: "+",
  difference: "-",
  product: "*",
  quotient: "/",
  remainder: "%",
  power: "^",
  length: "LEN",
  angle: "ANG",
} as const;
const RANK = {
  length: 0,
  angle: 0,
  undefined: 4,
  ofText: 4,
  sum: 1,
  difference: 1,
  product: 2,
  quotient: 2,
  remainder: 2,
  power: 3,
  negative: 4,
  call: 4,
  value: 4,
} as const;

function formulaText(f: Formula, style: Style, atLeast = 0): string {
  const text = bare(f, style);
  return RANK[f.kind] < atLeast ? `( ${text} )` : text;
}

function bare(f: Formula, style: Style): string {
  switch (f.kind) {
    case "value":
      return valueText(f.value, { ...style, plus: false });
    case "negative":
      return `- ${formulaText(f.of, style, 4)}`;
    case "call":
      return `${f.name} ${formulaText(f.of, style, 4)}`;
    case "undefined":
      return "SET UNDEFINED";
    case "ofText": {
      const more = `${f.search ? ` SEA_${textFormula(f.search, style)}` : ""}${word("BEG", f.begin, style)}`;
      return `${f.name} ( SRC_${textFormula(f.source, style)}${more} )`;
    }
    default: {
      const rank = RANK[f.kind];
      // Operators of equal rank are evaluated from the left, except powers.
      const [left, right] = f.kind === "power" ? [rank + 1, rank] : [rank, rank + 1];
      return `${formulaText(f.left, style, left)} ${SIGNS[f.kind]} ${formulaText(f.right, style, right)}`;
    }
  }
}

const word = (name: string, value: Value | null, style: Style) =>
  value === null ? "" : ` ${name}${valueText(value, { ...style, plus: false })}`;

function textFormula(f: TextFormula, style: Style): string {
  switch (f.kind) {
    case "quoted":
      return `"${f.text}"`;
    case "parameter":
      return f.parameter;
    case "joined":
      return f.parts.map((part) => textFormula(part, style)).join(" || ");
    case "toChar":
      return `TOCHAR ( DAT${valueText(f.value, { ...style, plus: true })}${word("DECIMALS", f.decimals, style)} )`;
    case "part":
      return `SUBSTR ( SRC_${textFormula(f.source, style)}${word("BEG", f.begin, style)}${word("LEN", f.length, style)} )`;
  }
}

/** `QS1 = "A" || QS2`. */
export const textAssignmentText = (s: TextAssignment, style: Style): string =>
  `${s.declared ? "DECLARE STRING " : ""}${s.target} = ${textFormula(s.text, style)}`;

/** `Q1 = Q2 * 3`, or with its FN number `FN 1: Q1 =+Q2 + +5`. */
export function assignmentText(s: Assignment, style: Style): string {
  if (s.fn === null) return `${s.target} = ${formulaText(s.formula, style)}`;
  const signed = (f: Formula) =>
    f.kind === "value" ? valueText(f.value, { ...style, plus: true }) : formulaText(f, style, 4);
  const right = (f: Formula): string => {
    if (f.kind === "value") return signed(f);
    if (f.kind === "call" && (s.fn === 5 || s.fn === 6 || s.fn === 7)) return `${f.name} ${signed(f.of)}`;
    if (
      f.kind === "sum" ||
      f.kind === "difference" ||
      f.kind === "product" ||
      f.kind === "length" ||
      f.kind === "angle"
    )
      return `${signed(f.left)} ${SIGNS[f.kind]} ${signed(f.right)}`;
    return f.kind === "quotient" ? `${signed(f.left)} DIV ${signed(f.right)}` : formulaText(f, style);
  };
  return `FN ${s.fn}: ${s.target} = ${right(s.formula)}`;
}
