import { assignment, checkKlartextBlock } from "./klartext-block.ts";
import { isBlank, isDigit, type LineCursor } from "./line-cursor.ts";
import { refuse, type LineRefusal } from "./refusal.ts";
import {
  ANY_VALUE,
  DELTA,
  FEED,
  G_FUNCTION,
  LABEL,
  M_FUNCTION,
  type NumberFormat,
  parameterKind,
  POSITION,
  SPEED,
  takeNumberOrName,
  takeParameter,
  takeValue,
  TOOL,
  valueStarts,
} from "./values.ts";

/** Functions without a DIN/ISO word, which are written as in Klartext. */
export const KLARTEXT_FUNCTIONS: readonly string[] = [
  "FUNCTION BLK TRANS APPR DEP UDC GRV PLANE SEL CYCL TCH CONTOUR PATTERN POLARKIN DECLARE SQL FN IF GLOBAL TABDATA MONITORING SECTION",
  "FL FLT FC FCT FPOL FSELECT SPL LN CALL CC TOOL",
].flatMap((words) => words.split(" "));
/** Klartext that has a DIN/ISO word: L1,0 and, without a position or a pattern, G79. */
const hasIsoWord = (cursor: LineCursor) => {
  if (cursor.takeWord("CALL")) return cursor.takeWord("LBL");
  return cursor.takeWord("CYCL") && cursor.takeWord("CALL") && (cursor.done || cursor.letters() === "M");
};

const CYCLE_NUMBER: NumberFormat = { least: 0, most: 9999, before: 9, after: 0 };
const FN_NUMBER: NumberFormat = { least: 0, most: 99, before: 9, after: 0 };
const REPEAT_OR_NONE: NumberFormat = { least: 0, most: 65534, before: 9, after: 0 };
const MOST_FUNCTIONS = 4;
/** First number of the cycles that take Q parameters; lower numbers are functions with words. */
const FIRST_CYCLE = 200;
/**
 * G98 sets a label, G99 defines a tool by its length L, G28 mirrors axes (without a value), and T of G62 is a
 * tolerance.
 */
const [LABEL_FUNCTION, TOOL_DEFINITION, MIRROR, TOLERANCE] = [98, 99, 28, 62];

/** Addresses and their formats, the longest first. */
const ADDRESSES: readonly (readonly [string, NumberFormat])[] = [
  ["DR2", DELTA],
  ["DL", DELTA],
  ["DR", DELTA],
  ["FU", FEED],
  ["FZ", FEED],
  ["MB", POSITION],
  ["LA", ANY_VALUE],
  ...["X", "Y", "Z", "A", "B", "C", "U", "V", "W"].flatMap((axis) => [
    [`I${axis}`, POSITION] as const,
    [axis, POSITION] as const,
  ]),
  ...["I", "J", "K", "R"].map((word) => [word, POSITION] as const),
  ["H", ANY_VALUE],
  ["F", FEED],
  ["S", SPEED],
  ["P", ANY_VALUE],
  ["E", ANY_VALUE],
];
const ALONE = ["FMAX", "RL", "RR", "PAT", "POS"];

/** The number of a cycle with Q parameters that opens here as `G200`; -1 for any other block. */
export function cycleHere(cursor: LineCursor): number {
  const from = cursor.at;
  cursor.blanks();
  const isG = cursor.char().toUpperCase() === "G" && isDigit(cursor.char(1));
  if (isG) cursor.at += 1;
  const number = isG ? Number(cursor.digits().slice(0, 9)) : -1;
  cursor.blanks();
  const isList = number >= FIRST_CYCLE || (isG && parameterKind(cursor) === "Q");
  cursor.at = from;
  return isList ? number : -1;
}

/** Checks the block that starts here, without number, comment and `*`. */
export function checkIsoBlock(cursor: LineCursor): LineRefusal | null {
  cursor.blanks();
  if (cursor.char() === "%") return null;
  if (cycleHere(cursor) >= 0) {
    cursor.at += 1;
    return takeValue(cursor, "G", CYCLE_NUMBER);
  }
  if (parameterKind(cursor) !== "") return assignment(cursor);
  const letters = cursor.letters();
  if (KLARTEXT_FUNCTIONS.includes(letters)) return klartext(cursor);
  if (letters === "D" && isDigit(cursor.char(1))) return parameterFunction(cursor);
  return takeAddresses(cursor);
}

function klartext(cursor: LineCursor): LineRefusal | null {
  const from = cursor.at;
  const isForeign = hasIsoWord(cursor);
  cursor.at = from;
  return isForeign ? unknownWord(cursor) : checkKlartextBlock(cursor);
}

/** `D01 Q1 P01 +Q2 P02 +5`: the FN functions. */
function parameterFunction(cursor: LineCursor): LineRefusal | null {
  cursor.at += 1;
  const from = cursor.at;
  const refused = takeValue(cursor, "D", FN_NUMBER);
  if (refused) return refused;
  // Functions behind the jumps have words of their own.
  const number = Number(cursor.text.slice(from, cursor.at));
  if (number > 13) return null;
  cursor.blanks();
  if (parameterKind(cursor) !== "") {
    const wrong = takeParameter(cursor);
    if (wrong) return wrong;
  }
  while (!cursor.done) {
    const at = cursor.at;
    if (!cursor.take("P") || !isDigit(cursor.char())) return refuse(at, "unknownWord", { text: cursor.piece() });
    cursor.digits();
    cursor.blanks();
    cursor.take("L");
    const wrong = cursor.char() === '"' ? takeNumberOrName(cursor, "P", LABEL) : takeValue(cursor, "P", ANY_VALUE);
    if (wrong) return wrong;
  }
  return null;
}

function takeAddresses(cursor: LineCursor): LineRefusal | null {
  let functions = 0;
  let last = -1;
  while (!cursor.done) {
    const from = cursor.at;
    const c = cursor.char().toUpperCase();
    if (c === "M" && !cursor.letters().startsWith("MB")) functions += 1;
    if (functions > MOST_FUNCTIONS)
      return refuse(from, "tooManyFunctions", { text: cursor.piece(), most: MOST_FUNCTIONS });
    const refused = takeAddress(cursor, c, last);
    if (refused) return refused;
    if (c === "G") last = Number(cursor.text.slice(from + 1, cursor.at));
    if (cursor.char() === ":") cursor.at += 1;
  }
  return null;
}

/** `last`: the number of the preceding G function. */
function takeAddress(cursor: LineCursor, c: string, last: number): LineRefusal | null {
  const from = cursor.at;
  const letters = cursor.letters();
  if (
    (ALONE.includes(letters) || (last === MIRROR && letters.length === 1) || letters === "T") &&
    !valueStartsBehind(cursor, letters.length)
  ) {
    const quoted = letters === "T" && cursor.char(1) === '"';
    if (!quoted) {
      cursor.at += letters.length;
      return null;
    }
  }
  if (c === "T" && last !== TOLERANCE) return takeBehind(cursor, 1, (each) => takeNumberOrName(each, c, TOOL));
  if (c === "T") return takeBehind(cursor, 1, (each) => takeValue(each, c, ANY_VALUE));
  if (c === "L" && last === TOOL_DEFINITION) return takeBehind(cursor, 1, (each) => takeValue(each, c, POSITION));
  if (c === "L") return takeBehind(cursor, 1, (each) => takeLabel(each, last));
  if (c === "G") return takeBehind(cursor, 1, (each) => takeValue(each, c, G_FUNCTION));
  if (c === "M" && !letters.startsWith("MB")) return takeBehind(cursor, 1, (each) => takeValue(each, c, M_FUNCTION));
  if (c === "P" && isDigit(cursor.char(1)) && isDigit(cursor.char(2)) && isBlank(cursor.char(3))) {
    // P01 +5: the number of a word of older cycles, and its value.
    cursor.at += 3;
    cursor.blanks();
    if (cursor.char() === '"') return takeNumberOrName(cursor, "P", LABEL);
    return valueStarts(cursor) ? takeValue(cursor, "P", ANY_VALUE) : unknownWord(cursor);
  }
  const address = ADDRESSES.find(
    ([word]) => cursor.text.slice(from, Math.min(from + word.length, cursor.end)).toUpperCase() === word,
  );
  if (address === undefined) return unknownWord(cursor);
  const [word, numbers] = address;
  cursor.at += word.length;
  if (valueStarts(cursor)) return takeValue(cursor, word, numbers);
  if ((word === "F" || word === "MB") && (cursor.take("MAX") || cursor.take("AUTO"))) return null;
  const next = cursor.char();
  if (next === "" || isBlank(next)) return refuse(cursor.at, "valueMissing", { word });
  cursor.at = from;
  return unknownWord(cursor);
}

const unknownWord = (cursor: LineCursor) => refuse(cursor.at, "unknownWord", { text: cursor.piece() });

function takeBehind(
  cursor: LineCursor,
  letters: number,
  take: (cursor: LineCursor) => LineRefusal | null,
): LineRefusal | null {
  const from = cursor.at;
  const next = cursor.char(letters);
  if (next !== "" && !isBlank(next) && next !== '"' && !valueStartsBehind(cursor, letters)) return unknownWord(cursor);
  cursor.at = from + letters;
  // `L X+5` is Klartext, and not an L without its label.
  if (!cursor.done && cursor.char() !== '"' && !valueStarts(cursor)) {
    cursor.at = from;
    return unknownWord(cursor);
  }
  return take(cursor);
}

function valueStartsBehind(cursor: LineCursor, letters: number): boolean {
  const from = cursor.at;
  cursor.at += letters;
  const starts = valueStarts(cursor);
  cursor.at = from;
  return starts;
}

/** A label, and after a comma the repeat count, which may look like decimals: `L1,5`. */
function takeLabel(cursor: LineCursor, last: number): LineRefusal | null {
  const refused = takeNumberOrName(cursor, "L", LABEL);
  if (last === LABEL_FUNCTION) return refused;
  if (refused) return refused.code === "tooManyDigits" ? null : refused;
  // The comma in front of a parameter counts as that of the label.
  const hasComma = cursor.char() === "," || cursor.text.charAt(cursor.at - 1) === ",";
  if (cursor.char() === ",") cursor.at += 1;
  return hasComma && valueStarts(cursor) ? takeValue(cursor, "L", REPEAT_OR_NONE) : null;
}
