import { expect, test } from "vitest";
import type { DrawingNote } from "../../program/drawing/drawing.ts";
import { newRow } from "../../program/job/job.ts";
import { dismissDrawnNotes, keepDrawnNotes, notesOn, useDrawnNotes } from "./drawn-notes.ts";

const gap = (width: number): DrawingNote => ({ code: "gapJoined", severity: "info", values: { width, x: 20, z: -5 } });
const row = newRow("e2", { x: "20", z: "-5" });
const shown = (of: typeof row, work = "a") => notesOn(useDrawnNotes.getState().notes, work, of).map(({ note }) => note);

test("a note stays at its element as it was made, also after undo, until it is dismissed", () => {
  keepDrawnNotes([{ work: "a", row, note: gap(0.1) }]);
  expect([shown({ ...row }), shown({ ...row, z: "-6" }), shown(row, "b")]).toEqual([[gap(0.1)], [], []]);
  const other = newRow("e2", { x: "30", z: "-5" });
  keepDrawnNotes([{ work: "a", row: other, note: gap(0.2) }]);
  expect([shown(other), shown(row)]).toEqual([[gap(0.2)], [gap(0.1)]]);
  keepDrawnNotes([{ work: "a", row, note: gap(0.3) }]);
  expect(shown(row)).toEqual([gap(0.3)]);
  dismissDrawnNotes(notesOn(useDrawnNotes.getState().notes, "a", row));
  expect([shown(row), shown(other)]).toEqual([[], [gap(0.2)]]);
});
