import { newRow, type ContourRow } from "../../program/job/job.ts";

type Rows = readonly ContourRow[];

/** An id that no row has. */
export const freshId = (rows: Rows): string =>
  `e${1 + Math.max(0, ...rows.map((r) => Number(/^e(\d+)$/.exec(r.id)?.[1] ?? 0)))}`;

/** A table after an edit, and the row to focus. */
export interface Edited {
  readonly rows: Rows;
  readonly focus: string | null;
}

/** Inserts a new line; the rows from there on move down. */
export function withRow(rows: Rows, at: number): Edited {
  const row = newRow(freshId(rows));
  return { rows: rows.toSpliced(at, 0, row), focus: row.id };
}

/** A copy right behind a row. */
export function withDuplicatedRow(rows: Rows, at: number): Edited {
  const row = rows[at];
  if (!row) return { rows, focus: null };
  const copy = { ...row, id: freshId(rows) };
  return { rows: rows.toSpliced(at + 1, 0, copy), focus: copy.id };
}

/** Removes a row; the one that takes its place gets focus. */
export function withoutRow(rows: Rows, at: number): Edited {
  const left = rows.toSpliced(at, 1);
  return { rows: left, focus: (left[at] ?? left.at(-1))?.id ?? null };
}

/** A row one place up or down; at either end nothing changes. */
export function withRowMoved(rows: Rows, at: number, by: 1 | -1): Edited {
  const row = rows[at],
    to = at + by;
  if (!row || to < 0 || to >= rows.length) return { rows, focus: row?.id ?? null };
  return { rows: rows.toSpliced(at, 1).toSpliced(to, 0, row), focus: row.id };
}

/** One row changed. */
export const changed = (rows: Rows, id: string, change: Partial<ContourRow>): Rows =>
  rows.map((r) => (r.id === id ? { ...r, ...change } : r));
