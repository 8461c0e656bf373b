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
import type { OpenedDrawing } from "../../app/document/drawing-request.ts";
import { askDrawing } from "./read-drawing-file.ts";
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

/** Starts a finished part with the contours of a drawing, outside and bore, to plan it. */
export async function planContour(opened: OpenedDrawing, contour: DrawnContour): Promise<void> {
  const { choice, file } = opened,
    side = choice.side === "bore" ? "outside" : "bore";
  const [{ newPart }, { partRows }, { addPart }, other] = await Promise.all([
    retryImport(() => import("../../planning/part/finished-part.ts")),
    retryImport(() => import("../../planning/part/part-rows.ts")),
    retryImport(() => import("../../app/records/part-store.ts")),
    contour.hasSides ? askDrawing(opened, { ask: "contour", choice: { ...choice, side } }) : null,
  ]);
  const [own, others] = [contour.rows, other?.rows ?? []];
  const rows = choice.side === "bore" && contour.hasSides ? partRows(others, own) : partRows(own, others);
  addPart({ ...newPart(file.name.replace(/\.[^.]*$/, "").slice(0, LONGEST_NAME)), ...rows });
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
