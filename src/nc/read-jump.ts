import type { Scan } from "./scan.ts";
import { COMPARISONS, type Statement } from "./statement.ts";
import { PARAMETER, readLabel, readValue, VALUE } from "./value.ts";

/** How a jump begins, with its FN number or without. */
export const JUMP = /(?:FN[ \t]*(9|1[0-2])[ \t]*:[ \t]*)?IF(?![A-Z])/iy;
const OPERAND = new RegExp(VALUE, "iy");
const COMPARE = /(EQU|NE|GT|LT|IS[ \t]+DEFINED|IS[ \t]+UNDEFINED)(?![A-Z])/iy;
const TARGET = new RegExp(String.raw`GOTO[ \t]*LBL[ \t]*(?:(\d{1,9})|"([^"]*)"|(${PARAMETER}))`, "iy");

const RAISE = new RegExp(String.raw`FN[ \t]*14[ \t]*:[ \t]*ERROR[ \t]*=?[ \t]*(${VALUE})`, "iy");

/** `FN 14: ERROR=1000`; null when it is none. */
export function readRaise(scan: Scan): Statement | null {
  const m = scan.take(RAISE);
  const error = m && readValue(m[1] ?? "");
  return error !== null && scan.done ? { kind: "raise", error } : null;
}

/** `FN 9: IF +Q1 EQU +Q3 GOTO LBL "END"`; null when it is no jump that can be read. */
export function readJump(scan: Scan): Statement | null {
  const head = scan.take(JUMP);
  const first = head && scan.take(OPERAND);
  const word = first && scan.take(COMPARE);
  if (!word) return null;
  const spelt = (word[1] ?? "").replace(/[ \t]+/, " ").toUpperCase();
  const compare = COMPARISONS.find((c) => c === spelt);
  const alone = spelt.startsWith("IS");
  const second = alone ? null : scan.take(OPERAND);
  const target = scan.take(TARGET);
  const [left, right] = [readValue(first[0]), second && readValue(second[0])];
  if (!compare || !target || left === null || (right === null && !alone)) return null;
  scan.leftOver();
  const fn = head[1] === undefined ? null : (Number(head[1]) as 9 | 10 | 11 | 12);
  const label =
    target[3] === undefined ? readLabel(target[1], target[2]) : { parameter: target[3].toUpperCase(), negative: false };
  return { kind: "jump", fn, left, compare, right, label };
}
