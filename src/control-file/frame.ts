import { isBlank, type LineCursor } from "./line-cursor.ts";
import { refuse, type LineRefusal } from "./refusal.ts";

/** Characters that separate folders, drives and texts on a control, so a program name cannot contain them. */
const NOT_IN_NAMES = '\\/:*?"<>|';

/** A program name with its position. */
export interface FrameName {
  readonly name: string;
  readonly at: number;
}
export interface FrameRead {
  readonly name: FrameName | null;
  readonly refused: LineRefusal | null;
}

/** Reads the name and the unit behind BEGIN PGM, END PGM or `%` up to the end of the line. */
export function takeFrame(cursor: LineCursor, units: readonly string[]): FrameRead {
  cursor.blanks();
  const from = cursor.at;
  let end = cursor.end;
  while (end > from && isBlank(cursor.text.charAt(end - 1))) end -= 1;
  const rest = cursor.text.slice(from, end);
  const cut = Math.max(rest.lastIndexOf(" "), rest.lastIndexOf("\t"));
  const last = rest.slice(cut + 1).toUpperCase();
  const hasUnit = units.includes(last);
  const name = (hasUnit ? rest.slice(0, Math.max(0, cut)) : rest).trimEnd();
  if (name === "") return { name: null, refused: refuse(from, "nameMissing", {}) };
  if (!hasUnit) return { name: { name, at: from }, refused: refuse(end, "unitMissing", { units: units.join(", ") }) };
  return { name: { name, at: from }, refused: wrongCharacter(name, from) };
}

function wrongCharacter(name: string, from: number): LineRefusal | null {
  for (let i = 0; i < name.length; i += 1) {
    const character = name.charAt(i);
    if (NOT_IN_NAMES.includes(character) || character < " ")
      return refuse(from + i, "nameCharacter", { name: name.slice(0, 40), character });
  }
  return null;
}
