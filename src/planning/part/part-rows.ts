import type { Segment } from "../../kernel/geometry/point.ts";
import { rowsThrough } from "../../program/drawing/rows.ts";
import type { ContourRow } from "../../program/job/job.ts";

const withLetter = (rows: readonly ContourRow[], letter: string): readonly ContourRow[] =>
  rows.map((row, i) => ({ ...row, id: `${letter}${i + 1}` }));

/** Rows of both sides of a part, with ids that differ. */
export const partRows = (outside: readonly ContourRow[], inside: readonly ContourRow[]) => ({
  outside: withLetter(outside, "e"),
  inside: withLetter(inside, "i"),
});

/** Rows of both sides from lines and arcs, at the resolution of a control. */
export const rowsOfSides = (outside: readonly Segment[], inside: readonly Segment[]) =>
  partRows(rowsThrough(outside), rowsThrough(inside));
