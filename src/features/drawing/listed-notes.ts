import type { DrawingNote } from "../../program/drawing/drawing.ts";
import type { ListedNote } from "./NoteList.tsx";

const ORDER = { error: 0, warning: 1, info: 2 } as const;

/** Notes by severity, those with a place numbered as their marks on the picture are. */
export function listedNotes(notes: readonly DrawingNote[], textOf: (note: DrawingNote) => string): ListedNote[] {
  let number = 0;
  return notes
    .toSorted((a, b) => ORDER[a.severity] - ORDER[b.severity])
    .map((note) => ({ note, text: textOf(note), number: note.at ? (number += 1) : null }));
}
