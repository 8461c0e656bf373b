import type { FileLine } from "./file-lines.ts";
import { isBlank, isDigit, LineCursor } from "./line-cursor.ts";
import { refuse, type LineRefusal } from "./refusal.ts";
import { ANY_VALUE, parameterKind, takeParameter, takeValue } from "./values.ts";

/** The words that open a list of Q parameters: `CYCL DEF 200`, `TCH PROBE 421`; empty for any other block. */
export function listOpener(cursor: LineCursor): string {
  const from = cursor.at;
  const opens = (first: string, second: string) => {
    cursor.at = from;
    return cursor.takeWord(first) && cursor.takeWord(second);
  };
  const words = [
    ["CYCL", "DEF"],
    ["TCH", "PROBE"],
    ["GLOBAL", "DEF"],
  ].find(([first = "", second = ""]) => opens(first, second));
  if (!words) {
    cursor.at = from;
    return "";
  }
  cursor.blanks();
  const number = cursor.digits();
  cursor.blanks();
  const isNumbered = cursor.char() === "." && isDigit(cursor.char(1));
  cursor.at = from;
  return number === "" || isNumbered ? "" : `${words.join(" ")} ${number.slice(0, 9)}`;
}

/** Where the first parameter with `=` behind the name of a list starts, on the same line; the end without one. */
export function listStart(cursor: LineCursor): number {
  for (let at = cursor.at + 1; at < cursor.end; at += 1) {
    if (cursor.text.charAt(at).toUpperCase() !== "Q" || !isBlank(cursor.text.charAt(at - 1))) continue;
    const ahead = new LineCursor(cursor.text, at, cursor.end);
    if (parameterKind(ahead) === "") continue;
    takeParameter(ahead);
    if (ahead.char() === "=") return at;
  }
  return cursor.end;
}

/** Takes `Q215=+0` and the like up to the end of the line. */
export function takeParameters(cursor: LineCursor): LineRefusal | null {
  while (!cursor.done) {
    const from = cursor.at;
    if (parameterKind(cursor) === "") return refuse(from, "unknownWord", { text: cursor.piece() });
    const refused = takeParameter(cursor);
    if (refused) return refused;
    const word = cursor.text.slice(from, cursor.at).toUpperCase();
    cursor.blanks();
    if (!cursor.take("=")) return refuse(cursor.at, "equalsMissing", { word });
    const wrong = takeParameterValue(cursor, word);
    if (wrong) return wrong;
  }
  return null;
}

function takeParameterValue(cursor: LineCursor, word: string): LineRefusal | null {
  cursor.blanks();
  if (cursor.char() === '"') return cursor.quoted() === null ? refuse(cursor.at, "stringOpen", {}) : null;
  const from = cursor.at;
  for (const each of ["FMAX", "FAUTO", "F MAX", "F AUTO", "MAX", "AUTO", "PREDEF"]) if (cursor.take(each)) return null;
  cursor.at = from;
  for (const each of ["FU", "FZ", "F"]) if (cursor.take(each)) break;
  return takeValue(cursor, word, ANY_VALUE);
}

/** First number of the Q parameters reserved for cycles. */
const FIRST_OF_CYCLES = 200;

/**
 * Whether a line after a list continues it in the manual's layout, without `~`. The operator's own assignment is a
 * block: it has a low number and blanks around `=`. `isNumbered`: the list has a block number, and this line has none;
 * `isClosed`: the list had its `~` up to the previous line.
 */
export function looksLikeList(line: FileLine, isNumbered: boolean, isClosed: boolean): boolean {
  if (line.number !== "" || line.wrongNumber !== "") return false;
  const cursor = new LineCursor(line.text, line.from, line.to);
  const kind = parameterKind(cursor);
  if (kind !== "Q") return false;
  const from = cursor.at + 1;
  takeParameter(cursor);
  const isOfCycles = Number(line.text.slice(from, cursor.at)) >= FIRST_OF_CYCLES;
  cursor.blanks();
  const hasEquals = cursor.take("=");
  const isTight = hasEquals ? !isBlank(cursor.char()) : cursor.char() === "+" || cursor.char() === "-";
  if (!isTight) return false;
  return isOfCycles || ((isNumbered || line.comment >= 0) && !isClosed);
}
