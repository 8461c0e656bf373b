import type { Dialect } from "./dialect.ts";
import { checkKlartextBlock, isOpener } from "./klartext-block.ts";
import { LineCursor } from "./line-cursor.ts";
import { listOpener } from "./list.ts";

/** Klartext of the TNC 640 and TNC7: no refusal by only one of them is known. */
export const KLARTEXT: Dialect = {
  letter: "",
  star: false,
  units: ["MM", "INCH"],
  frame: (cursor) => {
    const from = cursor.at;
    if (cursor.takeWord("BEGIN") && cursor.takeWord("PGM")) return "begin";
    cursor.at = from;
    if (cursor.takeWord("END") && cursor.takeWord("PGM")) return "end";
    cursor.at = from;
    return null;
  },
  listOpener,
  checkBlock: checkKlartextBlock,
  labelSet: (cursor) => {
    if (!cursor.takeWord("LBL")) return null;
    cursor.blanks();
    return { label: cursor.text.slice(cursor.at, cursor.end), at: cursor.at };
  },
  opensBlock: (line) => {
    const letters = new LineCursor(line.text, line.from, line.to).letters();
    return isOpener(letters) || letters === "BEGIN" || letters === "END";
  },
};
