import { isDigit, type LineCursor } from "./line-cursor.ts";
import { refuse, type LineRefusal } from "./refusal.ts";
import { LOOSE, parameterKind, takeParameter, takeValue } from "./values.ts";

const FUNCTIONS = [
  ...[
    "SIN",
    "COS",
    "TAN",
    "ASIN",
    "ACOS",
    "ATAN",
    "SQRT",
    "SQ",
    "LN",
    "LOG",
    "EXP",
    "NEG",
    "INT",
    "ABS",
    "FRAC",
    "SGN",
    "NOT",
  ],
];
/** Functions with words of their own between brackets: SUBSTR ( SRC_QS1 BEG2 LEN3 ). */
const TEXT_FUNCTIONS = ["TONUMB", "INSTR", "STRLEN", "STRCOMP", "TOCHAR", "SUBSTR", "SYSSTR", "CFGREAD"];
/** Operators that are written as words: of FN 4, FN 8 and FN 13, and comparisons of newer software. */
const OPERATOR_WORDS = ["DIV", "LEN", "ANG", "MOD", "AND", "OR", "XOR", "EQU", "NE", "GT", "LT"];
const OPERATORS = "+-*/^%|&\\=<>!";

/**
 * Takes a formula up to the end of the line: values and operators in turn, brackets closed. Tables of functions are
 * known by name.
 */
export function takeFormula(cursor: LineCursor, word: string): LineRefusal | null {
  if (cursor.done) return refuse(cursor.at, "valueMissing", { word });
  if (cursor.takeWord("SET"))
    return cursor.takeWord("UNDEFINED") ? null : refuse(cursor.at, "unknownWord", { text: cursor.piece() });
  const open: number[] = [];
  let wantsValue = true;
  let last = cursor.at;
  while (!cursor.done) {
    const at = cursor.at;
    last = at;
    const step: LineRefusal | boolean = wantsValue ? takeOperand(cursor, word, open) : takeOperator(cursor, open);
    if (typeof step !== "boolean") return step;
    wantsValue = step;
    if (cursor.at === at) return refuse(at, "unknownWord", { text: cursor.piece() });
  }
  if (wantsValue) return refuse(last, "formulaBroken", { text: cursor.text.slice(last, cursor.end).trimEnd() });
  const bracket = open.at(-1);
  return bracket === undefined ? null : refuse(bracket, "bracketOpen", {});
}

/** Takes a value, or a sign, function or bracket before one; true while a value must still follow. */
function takeOperand(cursor: LineCursor, word: string, open: number[]): LineRefusal | boolean {
  const c = cursor.char();
  if (c === "(") {
    open.push(cursor.at);
    cursor.at += 1;
    return true;
  }
  if (c === "+" || c === "-" || c === "!") {
    cursor.at += 1;
    return true;
  }
  if (c === '"') return cursor.quoted() === null ? refuse(cursor.at, "stringOpen", {}) : false;
  if (parameterKind(cursor) !== "") return takeParameter(cursor) ?? false;
  const letters = cursor.letters();
  if (letters === "" && (isDigit(c) || c === "." || c === "," || c === "{"))
    return takeValue(cursor, word, LOOSE) ?? false;
  const name = FUNCTIONS.find(
    (each) => letters === each || letters === `${each}Q` || letters === `${each}QL` || letters === `${each}QR`,
  );
  if (name !== undefined) {
    cursor.at += name.length;
    return true;
  }
  if (letters === "PI") {
    cursor.at += 2;
    return false;
  }
  if (TEXT_FUNCTIONS.includes(letters)) {
    cursor.at += letters.length;
    return takeBrackets(cursor, letters) ?? false;
  }
  return OPERATORS.includes(c) || c === ")" ? refuse(cursor.at, "formulaBroken", { text: c }) : unknown(cursor);
}

const unknown = (cursor: LineCursor) => refuse(cursor.at, "unknownWord", { text: cursor.piece() });

/** Takes an operator; true when a value has to follow it. */
function takeOperator(cursor: LineCursor, open: number[]): LineRefusal | boolean {
  const c = cursor.char();
  if (c === ")") {
    if (open.pop() === undefined) return refuse(cursor.at, "formulaBroken", { text: c });
    cursor.at += 1;
    return false;
  }
  const double = c + cursor.char(1);
  if (["||", "**", "==", "!=", "<=", ">=", "<>"].includes(double)) {
    cursor.at += 2;
    return true;
  }
  if (c !== "" && OPERATORS.includes(c)) {
    cursor.at += 1;
    return true;
  }
  const letters = cursor.letters();
  const operator = OPERATOR_WORDS.find(
    (each) => letters === each || letters === `${each}Q` || letters === `${each}QL` || letters === `${each}QR`,
  );
  if (operator !== undefined) {
    cursor.at += operator.length;
    return true;
  }
  return isDigit(c) || parameterKind(cursor) !== "" || c === '"' || c === "("
    ? refuse(cursor.at, "formulaBroken", { text: cursor.piece() })
    : unknown(cursor);
}

/** Takes any text between brackets. */
function takeBrackets(cursor: LineCursor, word: string): LineRefusal | null {
  cursor.blanks();
  const from = cursor.at;
  if (cursor.char() !== "(") return refuse(from, "valueMissing", { word });
  let depth = 0;
  while (cursor.at < cursor.end) {
    const c = cursor.char();
    if (c === '"') {
      if (cursor.quoted() === null) return refuse(cursor.at, "stringOpen", {});
      continue;
    }
    cursor.at += 1;
    if (c === "(") depth += 1;
    else if (c === ")") {
      depth -= 1;
      if (depth === 0) return null;
    }
  }
  return refuse(from, "bracketOpen", {});
}
