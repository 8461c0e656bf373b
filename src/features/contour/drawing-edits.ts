import { largestThatWorks, fixesFinding } from "../../kernel/plan/offer.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { RowReading, RowsReading } from "../../program/job/contour-rows.ts";
import { toRadius, axial, diameter } from "../../kernel/units.ts";
import { isPolarRow, polarWordsTo } from "../../program/job/polar-row.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { newRow, type ContourRow } from "../../program/job/job.ts";
import { changed, freshId, type Edited } from "./row-edits.ts";
import type { SnapSpot } from "./snap.ts";

type Rows = readonly ContourRow[];

/** A number as an operator would type it, as fine as the control stores it. */
export const typed = (n: number): string => String(Number(n.toFixed(3)) || 0);
const SAME = 5e-4;

/** True for rows whose end point can be dragged. */
export const hasPoint = (row: ContourRow | undefined): boolean =>
  row !== undefined && ["L", "CR", "C", "CT", "LP", "CP", "CTP"].includes(row.kind);

const pointAt = ({ x, z }: SnapSpot): Pt => ({ z: axial(z), r: toRadius(diameter(x)) });

/** Moves the end point of a row. Writes only typed or required coordinates; solved ones stay solved. */
export function pointMoved(rows: Rows, reading: RowsReading, row: number, to: SnapSpot): Rows {
  const at = rows[row],
    read = reading.rows[row];
  if (!at || !read || !hasPoint(at)) return rows;
  if (isPolarRow(at)) {
    const { x, z } = read.inherited;
    return read.pole === null
      ? rows
      : changed(rows, at.id, {
          words: polarWordsTo(at, read.pole, x === null || z === null ? null : pointAt({ x, z }), pointAt(to)),
        });
  }
  const write = (axis: "x" | "z", incremental: boolean): string => {
    const before = read.inherited[axis],
      empty = at[axis].trim() === "";
    if (read.solvedAxes[axis] || (empty && before !== null && Math.abs(to[axis] - before) < SAME)) return at[axis];
    return typed(incremental && before !== null ? to[axis] - before : to[axis]);
  };
  const next = {
    x: write("x", at.incrementalX && at.x.trim() !== ""),
    z: write("z", at.incrementalZ && at.z.trim() !== ""),
  };
  return next.x === at.x && next.z === at.z ? rows : changed(rows, at.id, next);
}

/** A new line at the end of the contour. */
export function pointAppended(rows: Rows, to: SnapSpot): Edited {
  const row = newRow(freshId(rows), { x: typed(to.x), z: typed(to.z) });
  return { rows: [...rows, row], focus: row.id };
}

/**
 * A new point behind a row: the middle of the next element, or behind the last one a step of the grid further towards
 * the spindle. The first point of a contour is on the workpiece zero.
 */
export function pointAdded(rows: Rows, reading: RowsReading, row: number | null, step: number): Edited {
  const from = reading.rows.slice(0, (row ?? rows.length - 1) + 1).findLast(({ end }) => end)?.end;
  const next = row === null ? -1 : rows.findIndex((each, i) => i > row && hasPoint(each));
  const to = reading.rows[next]?.end;
  if (!from || !to) return pointAppended(rows, from ? { x: from.x, z: from.z - step } : { x: 0, z: 0 });
  return pointInserted(rows, reading, next, { x: (from.x + to.x) / 2, z: (from.z + to.z) / 2 });
}

/** Divides the element of a row in a point; the first part gets a row of its own before it. */
export function pointInserted(rows: Rows, reading: RowsReading, row: number, to: SnapSpot): Edited {
  const at = rows[row],
    read = reading.rows[row];
  if (!at || !read?.end || row === 0 || !hasPoint(at)) return { rows, focus: at?.id ?? null };
  if (isPolarRow(at)) return polarInserted(rows, read, row, at, to);
  const end = { x: typed(read.end.x), z: typed(read.end.z) };
  const first =
    at.kind === "L"
      ? newRow(freshId(rows), { x: typed(to.x), z: typed(to.z) })
      : {
          ...at,
          kind: at.kind === "CT" ? ("CR" as const) : at.kind,
          id: freshId(rows),
          x: typed(to.x),
          z: typed(to.z),
          incrementalX: false,
          incrementalZ: false,
          ...(at.kind === "CT" && { r: typed(Math.abs(read.radius ?? 0)), turn: read.turn ?? at.turn, tangent: true }),
        };
  // Incremental values are written as absolute ones, since the previous point has changed.
  const second: ContourRow = {
    ...at,
    length: "",
    ...(at.incrementalX ? { x: end.x, incrementalX: false } : {}),
    ...(at.incrementalZ ? { z: end.z, incrementalZ: false } : {}),
    ...(at.length.trim() === "" ? {} : end),
  };
  return { rows: rows.toSpliced(row, 1, first, second), focus: first.id };
}

/**
 * Divides a polar element: the first part is written in X and Z, the second keeps the pole and is no longer
 * incremental.
 */
function polarInserted(rows: Rows, read: RowReading, row: number, at: ContourRow, to: SnapSpot): Edited {
  if (!read.pole || !read.end) return { rows, focus: at.id };
  const place = { x: typed(to.x), z: typed(to.z) };
  const first =
    at.kind === "LP"
      ? newRow(freshId(rows), place)
      : at.kind === "CP"
        ? newRow(freshId(rows), { kind: "C", ...place, turn: at.turn })
        : newRow(freshId(rows), {
            kind: "CR",
            ...place,
            r: typed(Math.abs(read.radius ?? 0)),
            turn: read.turn ?? at.turn,
            tangent: true,
          });
  const second = { ...at, words: polarWordsTo({ ...at, words: {} }, read.pole, null, pointAt(read.end)) };
  return { rows: rows.toSpliced(row, 1, first, second), focus: first.id };
}

/** Elements that break a corner. */
export type CornerKind = "RND" | "CHF";

/** The corner element after a row, if any. */
export const cornerBehind = (rows: Rows, row: number): ContourRow | null => {
  const next = rows[row + 1];
  return next?.kind === "RND" || next?.kind === "CHF" ? next : null;
};

/** True where a corner can be broken: between two elements. */
export function isCorner(rows: Rows, row: number): boolean {
  if (row < 1 || !hasPoint(rows[row])) return false;
  return rows.slice(row + 1).some(hasPoint);
}

/**
 * Puts a rounding or chamfer on the corner at the end of a row, changes the existing one, or removes it with size 0. A
 * size that does not fit becomes the largest that does.
 */
export function cornerSized(rows: Rows, row: number, kind: CornerKind, size: number): Edited {
  const there = cornerBehind(rows, row),
    at = rows[row];
  if (!at) return { rows, focus: null };
  if (!(size > 0)) return there ? { rows: rows.filter((r) => r !== there), focus: at.id } : { rows, focus: at.id };
  const corner = there ? { ...there, kind, r: typed(size) } : newRow(freshId(rows), { kind, r: typed(size) });
  const made = rows.toSpliced(row + 1, there ? 1 : 0, corner);
  const wrong = readRows(made).issues.find(
    (found) => found.row === row + 1 && found.issue.code === "cornerElementTooLong",
  )?.issue;
  if (wrong?.code !== "cornerElementTooLong") return { rows: made, focus: corner.id };
  const sized = (r: number) => made.with(row + 1, { ...corner, r: typed(r) });
  const issuesOf = (of: Rows) => readRows(of).issues.map(({ issue }) => issue);
  const before = issuesOf(made),
    { max } = wrong.data;
  const fits = largestThatWorks(max, (r) => fixesFinding(wrong, before, issuesOf(sized(r))));
  return { rows: sized(fits ?? max), focus: corner.id };
}

/**
 * The row whose corner is edited while a row is selected: itself, or the one before a corner element; null without a
 * corner.
 */
export function cornerRowOf(rows: Rows, row: number | null): number | null {
  if (row === null) return null;
  const at = rows[row]?.kind === "RND" || rows[row]?.kind === "CHF" ? row - 1 : row;
  return isCorner(rows, at) ? at : null;
}

/** Breaks the corner at a selected row: with its present size, or 1 mm. */
export function cornerOf(rows: Rows, row: number | null, kind: CornerKind): Edited | null {
  const at = cornerRowOf(rows, row);
  return at === null ? null : cornerSized(rows, at, kind, Number(cornerBehind(rows, at)?.r.replace(",", ".")) || 1);
}

/** Puts an undercut into the corner at the end of a row; a rounding or chamfer there gives way, an undercut stays. */
export function undercutBehind(rows: Rows, row: number): Edited | null {
  const there = rows[row + 1];
  if (!isCorner(rows, row)) return null;
  if (there?.kind === "UDC") return { rows, focus: there.id };
  const made = newRow(freshId(rows), { kind: "UDC", form: "E" });
  return { rows: rows.toSpliced(row + 1, cornerBehind(rows, row) ? 1 : 0, made), focus: made.id };
}
