import { readRows } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import type { ContourChoice, DrawnContour } from "../../program/drawing/drawing.ts";
import { typedForProgram } from "../../program/edits/program-unit.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { keepDrawnNotes } from "../../app/document/drawn-notes.ts";
import type { ContourTarget } from "../../app/document/drawing-request.ts";
import { useEditor } from "../../app/document/store.ts";
import { showPlan } from "../../app/place/place.ts";
import { retryImport } from "../../app/base/parts.ts";
import { rowNear } from "../../program/drawing/positions.ts";

/** Longest name of a part, characters. */
const LONGEST_NAME = 32;

/** Rows in mm, as they are typed in a program that counts in inches. */
const inInches = (row: ContourRow): ContourRow => ({
  ...row,
  x: typedForProgram(row.x, true),
  z: typedForProgram(row.z, true),
  r: typedForProgram(row.r, true),
});

/** The rows of a table, with the notes that belong to them, by row. */
export function rowsWithNotes(contour: DrawnContour, choice: ContourChoice, inches: boolean) {
  const rows = inches ? contour.rows.map(inInches) : contour.rows;
  const ends = readRows(contour.rows).rows.map(({ end }) =>
    end ? { z: axial(end.z), r: toRadius(diameter(end.x)) } : null,
  );
  const notes = contour.notes.flatMap((note) => {
    const at = note.at ? rowNear(choice, ends, note.at) : null,
      row = at === null ? undefined : rows[at];
    return row ? [{ row, note }] : [];
  });
  return { rows, notes };
}

/** Starts a finished part with a contour, to plan it. */
export async function planContour(name: string, contour: DrawnContour): Promise<void> {
  const [{ newPart }, { addPart }] = await retryImport(() =>
    Promise.all([import("../../planning/part/finished-part.ts"), import("../../app/records/part-store.ts")]),
  );
  addPart({ ...newPart(name.replace(/\.[^.]*$/, "").slice(0, LONGEST_NAME)), outside: contour.rows });
  showPlan();
}

/** Puts a contour into its table, or starts a program with it, and keeps its notes beside the elements. */
export async function takeContour({
  target,
  cycle,
  name,
  contour,
  choice,
}: {
  readonly target: ContourTarget | null;
  /** Cycle of a new program. */
  readonly cycle: number;
  readonly name: string;
  readonly contour: DrawnContour;
  readonly choice: ContourChoice;
}): Promise<void> {
  const { rows, notes } = rowsWithNotes(contour, choice, target?.inches ?? false);
  if (target) target.take(rows);
  else (await retryImport(() => import("./begin-with-contour.ts"))).beginWithContour(cycle, name, rows);
  const { work } = useEditor.getState();
  keepDrawnNotes(notes.map((each) => ({ work, ...each })));
}
