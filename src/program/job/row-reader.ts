import { issue, type Issue } from "../../kernel/plan/issue.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { anyNumber, readText, type Field } from "../values/field.ts";
import type { ProgramIssue } from "../state/issue.ts";
import type { ContourRow } from "./job.ts";

/** A field of a contour row. */
export type RowField = "x" | "z" | "r" | "angle" | "length" | "PR" | "PA";

/** An issue with its place in the table; `field` is null for the whole element. */
export interface RowIssue {
  readonly row: number;
  readonly field: RowField | null;
  readonly issue: Issue | ProgramIssue;
}

/** State while rows are read in order: position, pole, and issues of their text. */
export interface RowReader {
  /** Last position from typed coordinates; X as diameter. "sought" where it has to be solved. */
  x: number | "sought" | null;
  z: number | "sought" | null;
  pole: Pt | null;
  readonly issues: RowIssue[];
}

/** Issues of a row belong to the contour; row and field give their place in its table. */
export const OPTIONAL_NUMBER: Field = { ...anyNumber, id: "contour" };
export const REQUIRED_NUMBER: Field = { ...OPTIONAL_NUMBER, optional: false };

/** A number typed into a row; reports its issue. */
export function rowNumber(
  reader: RowReader,
  row: number,
  at: RowField | null,
  typed: string,
  field: Field,
): number | null {
  const { value, issue: found } = readText(field, typed);
  if (found) reader.issues.push({ row, field: at, issue: found });
  return value;
}

/** Whether anything is typed in a row. */
export const begun = (row: ContourRow | undefined): boolean =>
  row !== undefined &&
  [row.x, row.z, row.r, row.angle, row.length, ...Object.values(row.words)].some((text) => text.trim() !== "");

/** Reports an element without motion. An empty row is not wrong, only not begun: it has no block either. */
export function reportNoMotion(reader: RowReader, row: ContourRow, index: number): void {
  const found = issue("contourPoint", begun(row) ? "error" : "info", { element: index + 1 }, "contour");
  reader.issues.push({ row: index, field: null, issue: found });
}
