import { isBlank, isDigit, type LineCursor } from "./line-cursor.ts";
import { refuse, type LineRefusal } from "./refusal.ts";
import { ANY_VALUE, FEED, LOOSE, M_FUNCTION, type NumberFormat, POSITION, takeValue, valueStarts } from "./values.ts";

/** What may follow the letters of a word. */
type Behind = NumberFormat | "nothing" | "sign" | "feed" | "radius" | "retract" | "function";
/** Words that a control also writes without a value, for "as before": `L X+5 R F M`. */
const MAY_BE_EMPTY: readonly Behind[] = ["feed", "radius", "function"];
type WordTable = ReadonlyMap<string, Behind>;

const MOST_FUNCTIONS = 4;
const AXES = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];
const group = (names: readonly string[], behind: Behind): [string, Behind][] => names.map((name) => [name, behind]);
const around = (before: readonly string[], axes: readonly string[]) =>
  axes.flatMap((axis) => before.map((text) => text + axis));

/** Words of all blocks with a path, its approach included. */
const PATH: WordTable = new Map<string, Behind>([
  ...group(around(["", "I", "&", "I&", "LIN_", "LIN_I"], AXES), POSITION),
  ...group(["PR", "IPR", "LEN"], POSITION),
  ...group(["PA", "IPA", "CCA"], ANY_VALUE),
  ...group(around(["CC", "ICC"], ["X", "Y", "Z", "PR", "PA"]), POSITION),
  ...group(["R0", "RL", "RR"], "nothing"),
  ...group(["DR"], "sign"),
  ...group(["FU", "FZ", "FT"], FEED),
  ["F", "feed"],
  ["FMAXT", FEED],
  ["R", "radius"],
  ["M", "function"],
]);
/** Words that follow some M functions: M120 LA, M140 MB, M124 T. */
const BEHIND_FUNCTIONS: WordTable = new Map<string, Behind>([
  ["LA", ANY_VALUE],
  ["MB", "retract"],
  ["T", ANY_VALUE],
]);
const FREE: WordTable = new Map<string, Behind>([["CLSD", "sign"]]);
const LONGEST = 6;

/** Further words of a path block: those of free contours, or the components of vectors and splines. */
export type MoreWords = "none" | "free" | "vectors";

const isEmptyWord = (cursor: LineCursor, behind: Behind) =>
  MAY_BE_EMPTY.includes(behind) && !valueStarts(cursor) && (cursor.char() === "" || isBlank(cursor.char()));

function fits(cursor: LineCursor, behind: Behind): boolean {
  if (isEmptyWord(cursor, behind)) return true;
  switch (behind) {
    case "nothing":
      return !isDigit(cursor.char()) && !/[.,_]/.test(cursor.char());
    case "sign":
      return signAhead(cursor);
    case "feed":
      return valueStarts(cursor) || wordAhead(cursor, ["MAX", "AUTO"]);
    case "retract":
      return valueStarts(cursor) || wordAhead(cursor, ["MAX"]);
    default:
      return valueStarts(cursor);
  }
}

function signAhead(cursor: LineCursor): boolean {
  const from = cursor.at;
  cursor.blanks();
  const c = cursor.char();
  cursor.at = from;
  return c === "+" || c === "-";
}

function wordAhead(cursor: LineCursor, words: readonly string[]): boolean {
  const from = cursor.at;
  const found = words.some((word) => {
    cursor.at = from;
    return cursor.take(word);
  });
  cursor.at = from;
  return found;
}

function takeBehind(cursor: LineCursor, word: string, behind: Behind): LineRefusal | null {
  switch (behind) {
    case "nothing":
      return null;
    case "sign":
      cursor.blanks();
      cursor.at += 1;
      return null;
    case "feed":
      return cursor.take("MAX") || cursor.take("AUTO") ? null : takeValue(cursor, word, FEED);
    case "retract":
      return cursor.take("MAX") ? null : takeValue(cursor, word, POSITION);
    case "function":
      return takeValue(cursor, word, M_FUNCTION);
    case "radius": {
      // R+ and R- alone are the compensation of a block that moves one axis.
      const next = cursor.char(1);
      if ((cursor.char() === "+" || cursor.char() === "-") && (next === "" || isBlank(next))) {
        cursor.at += 1;
        return null;
      }
      return takeValue(cursor, word, POSITION);
    }
    default:
      return takeValue(cursor, word, behind);
  }
}

/** The longest word of the tables at the cursor, with the kind of its value; the cursor is then behind its letters. */
function wordHere(
  cursor: LineCursor,
  tables: readonly WordTable[],
): { readonly word: string; readonly behind: Behind } | null {
  const from = cursor.at;
  const here = cursor.text.slice(from, Math.min(from + LONGEST, cursor.end)).toUpperCase();
  for (let length = here.length; length > 0; length -= 1) {
    const word = here.slice(0, length);
    for (const table of tables) {
      const behind = table.get(word);
      cursor.at = from + length;
      if (behind !== undefined && fits(cursor, behind)) return { word, behind };
    }
  }
  cursor.at = from;
  return null;
}

/** A word of letters and digits with a number behind it, as free contours and vectors have many. */
function takeLooseWord(cursor: LineCursor): boolean {
  const from = cursor.at;
  const letters = cursor.letters();
  cursor.at += letters.length;
  if (letters !== "" && valueStarts(cursor) && takeValue(cursor, letters, LOOSE) === null) {
    // P1X+5: the digit belongs to the name.
    const axis = cursor.letters();
    if (!isDigit(cursor.text.charAt(cursor.at - 1)) || axis.length !== 1) return true;
    const behind = cursor.at;
    cursor.at += 1;
    if (valueStarts(cursor) && takeValue(cursor, letters, LOOSE) === null) return true;
    cursor.at = behind;
    return true;
  }
  cursor.at = from;
  return false;
}

/** The refusal of a word that no table has. */
export function unknownHere(cursor: LineCursor, known: (word: string) => boolean): LineRefusal {
  const letters = cursor.letters();
  const next = cursor.char(letters.length);
  return letters !== "" && known(letters) && (next === "" || isBlank(next))
    ? refuse(cursor.at + letters.length, "valueMissing", { word: letters })
    : refuse(cursor.at, "unknownWord", { text: cursor.piece() });
}

/** Takes all words of a path block up to the end of the line. */
export function takePathWords(cursor: LineCursor, more: MoreWords = "none"): LineRefusal | null {
  let functions = 0;
  while (!cursor.done) {
    const from = cursor.at;
    const tables = [PATH, ...(functions > 0 ? [BEHIND_FUNCTIONS] : []), ...(more === "free" ? [FREE] : [])];
    const found = wordHere(cursor, tables);
    if (!found) {
      if (more !== "none" && takeLooseWord(cursor)) continue;
      return unknownHere(cursor, (word) => tables.some((table) => table.has(word)));
    }
    if (isEmptyWord(cursor, found.behind) && !(found.behind === "feed" && wordAhead(cursor, ["MAX", "AUTO"]))) continue;
    if (found.behind === "function") {
      functions += 1;
      if (functions > MOST_FUNCTIONS)
        return refuse(from, "tooManyFunctions", { text: cursor.text.slice(from, cursor.at), most: MOST_FUNCTIONS });
    }
    const refused = takeBehind(cursor, found.word, found.behind);
    if (refused) return refused;
  }
  return null;
}

/** Takes words of the form NAME and number, with or without a colon; null in `names` allows any name. */
export function takeNamedWords(cursor: LineCursor, names: Readonly<Record<string, NumberFormat>>): LineRefusal | null {
  while (!cursor.done) {
    const from = cursor.at;
    const letters = cursor.letters();
    const word = longestName(letters, names);
    const numbers = word === null ? undefined : names[word];
    if (word === null || numbers === undefined) return refuse(from, "unknownWord", { text: cursor.piece() });
    cursor.at += word.length;
    if (!cursor.take(":")) cursor.blanks();
    const refused = takeValue(cursor, word, numbers);
    if (refused) return refused;
  }
  return null;
}

/** The name at the start of the letters, which may include those of a parameter: `RQL3`. */
function longestName(letters: string, names: Readonly<Record<string, NumberFormat>>): string | null {
  for (const behind of ["", "Q", "QL", "QR"]) {
    const word = behind !== "" && letters.endsWith(behind) ? letters.slice(0, -behind.length) : letters;
    if (Object.hasOwn(names, word)) return word;
  }
  return null;
}

/** Takes an axis letter that stands alone, as behind BLK FORM 0.1 and TOOL CALL. */
export function takeAxisAlone(cursor: LineCursor): void {
  cursor.blanks();
  const next = cursor.char(1);
  if (AXES.includes(cursor.char().toUpperCase()) && (next === "" || isBlank(next))) cursor.at += 1;
}
