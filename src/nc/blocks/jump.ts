import { valueText } from "../number-text.ts";
import { unsigned } from "../print-words.ts";
import { COMPARISONS, type Comparison, type Label, type Parameter, type Value } from "../words.ts";
import type { Style } from "../style.ts";
import { PARAMETER, readLabel, readValue, VALUE } from "../value.ts";
import { defineBlock } from "./define.ts";
import { BARE, plainText } from "./compared-words.ts";
import { property, labelText } from "./words.ts";

const HEAD = /(?:FN[ \t]*(9|1[0-2])[ \t]*:[ \t]*)?IF(?![A-Z])/iy;
const OPERAND = new RegExp(VALUE, "iy");
const COMPARE = /(EQU|NE|GT|LT|IS[ \t]+DEFINED|IS[ \t]+UNDEFINED)(?![A-Z])/iy;
const TARGET = new RegExp(String.raw`GOTO[ \t]*LBL[ \t]*(?:(\d{1,9})|"([^"]*)"|(${PARAMETER}))`, "iy");

interface Jump {
  readonly fn: 9 | 10 | 11 | 12 | null;
  readonly left: Value;
  readonly compare: Comparison;
  readonly right: Value | null;
  readonly label: Label | Parameter;
}

function jumpText(s: Jump, style: Style): string {
  const signed = (value: Value) => valueText(value, { ...style, plus: true });
  const target = typeof s.label === "object" ? unsigned(s.label, style) : labelText(s.label);
  return (
    `${s.fn === null ? "" : `FN ${s.fn}: `}IF ${signed(s.left)} ${s.compare}` +
    `${s.right === null ? "" : ` ${signed(s.right)}`} GOTO LBL ${target}`
  );
}

/** `FN 9: IF +Q1 EQU +Q3 GOTO LBL "END"`. `fn`: the number of the FN function, null where only IF stands. */
export const jump = defineBlock({
  kind: "jump",
  begins: String.raw`(?=(?:FN[ \t]*(?:9|1[0-2])[ \t]*:[ \t]*)?IF(?![A-Z]))`,
  words: [
    property<Jump["fn"]>()("fn"),
    property<Value>()("left"),
    property<Comparison>()("compare"),
    // None with IS DEFINED and IS UNDEFINED.
    property<Value | null>()("right"),
    property<Label | Parameter>()("label"),
  ],
  read({ scan }) {
    const head = scan.take(HEAD);
    const first = head && scan.take(OPERAND);
    const said = first && scan.take(COMPARE);
    if (!said) return null;
    const spelt = (said[1] ?? "").replace(/[ \t]+/, " ").toUpperCase();
    const compare = COMPARISONS.find((c) => c === spelt);
    const alone = spelt.startsWith("IS");
    const second = alone ? null : scan.take(OPERAND);
    const target = scan.take(TARGET);
    const [left, right] = [readValue(first[0]), second && readValue(second[0])];
    if (!compare || !target || left === null || (right === null && !alone)) return null;
    scan.leftOver();
    const fn = head[1] === undefined ? null : (Number(head[1]) as 9 | 10 | 11 | 12);
    const label =
      target[3] === undefined
        ? readLabel(target[1], target[2])
        : { parameter: target[3].toUpperCase(), negative: false };
    return { kind: "jump", fn, left, compare, right, label };
  },
  print: jumpText,
  isTypedAsText: () => true,
  // Compared without its FN number.
  compareAs: (s, said) => void said.put("", plainText(jumpText({ ...s, fn: null }, BARE))),
});
