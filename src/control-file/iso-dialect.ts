import type { Dialect } from "./dialect.ts";
import { isDigit, LineCursor } from "./line-cursor.ts";
import { checkIsoBlock, cycleHere, KLARTEXT_FUNCTIONS } from "./iso-block.ts";
import { listOpener } from "./list.ts";

const UNITS = ["G71", "G70"];

/** DIN/ISO: `%NAME G71 *`, blocks that end in ` *`, cycles with their Q parameters behind the G number. */
export const ISO: Dialect = {
  letter: "N",
  star: true,
  units: UNITS,
  frame: (cursor, isBegun) => {
    if (cursor.char() !== "%") return null;
    cursor.at += 1;
    if (!isBegun) return "begin";
    // A `%` without a unit calls another program.
    const end = cursor.text.slice(cursor.at, cursor.end).trimEnd().toUpperCase();
    return UNITS.some((unit) => end.endsWith(` ${unit}`)) ? "end" : null;
  },
  listOpener: (cursor) => {
    const cycle = cycleHere(cursor);
    return cycle >= 0 ? `G${cycle}` : listOpener(cursor);
  },
  checkBlock: checkIsoBlock,
  labelSet: (cursor) => {
    if (!cursor.take("G98")) return null;
    cursor.blanks();
    if (!cursor.take("L")) return null;
    const from = cursor.at;
    if (cursor.char() === '"') cursor.quoted();
    else cursor.digits();
    return cursor.at === from ? null : { label: cursor.text.slice(from, cursor.at), at: from };
  },
  opensBlock: (line) => {
    const cursor = new LineCursor(line.text, line.from, line.to);
    const letters = cursor.letters();
    return (
      KLARTEXT_FUNCTIONS.includes(letters) ||
      cursor.char() === "%" ||
      (letters.length === 1 && letters !== "Q" && isDigit(cursor.char(1)))
    );
  },
};
