import { useMemo } from "react";
import { isOnlySign } from "../../app/fields/number/number-entry.ts";
import { useContourPlace, type BegunField } from "../../app/place/contour-place.ts";
import { readRows, type RowField, type RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { polarTyped, withPolar } from "../../program/job/polar-row.ts";

/** Notes the text that was just typed into a field: only a sign begins a number. */
export const noteTyped = (row: string, field: RowField, text: string): void =>
  useContourPlace.setState({ begun: isOnlySign(text) ? { row, field } : null });

export const noteLeft = (): void => useContourPlace.setState({ begun: null });

const emptied = (row: ContourRow, field: RowField): ContourRow =>
  field === "PR" || field === "PA"
    ? { ...row, words: withPolar(row.words, field, { ...polarTyped(row, field), text: "" }) }
    : { ...row, [field]: "" };

const unfinished = (rows: readonly ContourRow[], begun: BegunField | null): readonly ContourRow[] =>
  begun === null ? rows : rows.map((row) => (row.id === begun.row ? emptied(row, begun.field) : row));

/** The contour as read. A field with a sign that was just typed counts as empty until it is left. */
export function useReading(rows: readonly ContourRow[]): RowsReading {
  const begun = useContourPlace((p) => p.begun);
  return readRows(useMemo(() => unfinished(rows, begun), [rows, begun]));
}

/** A blank behind a number begins the class of its tolerance, "40 c11": the letter behind it is no command. */
export const beginsTolerance = (text: string): boolean => /\d\s$/.test(text);
