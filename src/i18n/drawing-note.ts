import type { DrawingNote, NoteCode, NoteValues } from "../program/drawing/drawing.ts";
import type { Language } from "./languages.ts";
import { formatNumber } from "./number.ts";

type Written<V> = { readonly [K in keyof V]: string };

/** A sentence for each note on a drawing; numbers arrive written, lengths in mm. Loaded with the drawing's dialog. */
export type DrawingTexts = { readonly [C in NoteCode]: (values: Written<NoteValues[C]>) => string };

/** A note on a drawing, as a sentence in a language; `words`: its part `drawing`. */
export function noteText(language: Language, note: DrawingNote, words: DrawingTexts): string {
  const values = Object.fromEntries(
    Object.entries<string | number>(note.values).map(([name, value]) => [
      name,
      typeof value === "number" ? formatNumber(language, value) : value,
    ]),
  );
  // The texts of a code take the values of that code.
  return (words[note.code] as (values: Readonly<Record<string, string>>) => string)(values);
}
