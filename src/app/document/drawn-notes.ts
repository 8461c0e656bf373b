import { create } from "zustand";
import type { ContourRow } from "../../program/job/job.ts";
import type { DrawingNote } from "../../program/drawing/drawing.ts";
import { isSameData } from "../base/same.ts";

/** A note of a drawing on the element that was made there. */
export interface DrawnNote {
  /** The work whose contour it is; null outside a work. */
  readonly work: string | null;
  /** The element as it was made: when it is edited, the note no longer applies. Undo shows it again. */
  readonly row: ContourRow;
  readonly note: DrawingNote;
}

/** Notes of the drawings taken in this session: joined gaps and doubtful places stay visible in the contour. */
export const useDrawnNotes = create<{ readonly notes: readonly DrawnNote[] }>(() => ({ notes: [] }));

/** Most notes that are kept; the oldest go. */
const MOST = 1000;

/** Keeps the notes of a contour that was taken, and those of the contours before, for undo. */
export const keepDrawnNotes = (notes: readonly DrawnNote[]): void =>
  useDrawnNotes.setState((old) => ({
    notes: [
      ...old.notes.filter((each) => !notes.some((n) => n.work === each.work && isSameData(n.row, each.row))),
      ...notes,
    ].slice(-MOST),
  }));

export const dismissDrawnNotes = (gone: readonly DrawnNote[]): void =>
  useDrawnNotes.setState(({ notes }) => ({ notes: notes.filter((each) => !gone.includes(each)) }));

/** The notes on an element as it is now. */
export const notesOn = (notes: readonly DrawnNote[], work: string | null, row: ContourRow): readonly DrawnNote[] =>
  notes.filter((each) => each.work === work && each.row.id === row.id && isSameData(each.row, row));
