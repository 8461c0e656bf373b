import { contourFrom, type Contour, type ContourElement } from "../kernel/contour.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import type { Pt } from "../kernel/point.ts";
import { axial, diameter, toRadius } from "../kernel/units.ts";
import { readExpression } from "./expression.ts";
import type { ContourRow } from "./job.ts";

/** A field of a contour row. */
export type RowField = "x" | "z" | "r";

/** A finding with its place in the table; `field` is null where it belongs to the whole element. */
export interface RowIssue {
  readonly row: number;
  readonly field: RowField | null;
  readonly issue: Issue;
}

/** What one row means. X values are diameters, mm. */
export interface RowReading {
  /** Where the element ends; null while that is unknown, and for corner elements. */
  readonly end: { readonly x: number; readonly z: number } | null;
  /** Where it would end in a coordinate that is left out. */
  readonly inherited: { readonly x: number | null; readonly z: number | null };
}

/** A contour table read: its geometry with as much as can be drawn, and what is wrong where. */
export interface RowsReading {
  readonly rows: readonly RowReading[];
  readonly contour: Contour;
  /** Index of the row that made each segment of the contour. */
  readonly rowOfSegment: readonly number[];
  readonly issues: readonly RowIssue[];
}

interface State {
  x: number | null;
  z: number | null;
  readonly issues: RowIssue[];
}

/** A typed number; says what is wrong with it, unless it may be empty and is. */
function fieldValue(state: State, row: number, field: RowField, typed: string, optional: boolean): number | null {
  const read = readExpression(typed);
  const say = (found: Issue) => state.issues.push({ row, field, issue: found });
  switch (read.kind) {
    case "number": return read.value;
    case "empty":
      if (!optional) say(issue("missing", "error", {}, "contour"));
      return null;
    case "notANumber": say(issue("notANumber", "error", { text: read.text }, "contour")); return null;
    case "badExpression": say(issue("badExpression", "error", { text: read.text }, "contour")); return null;
    case "unknownParameter": say(issue("unknownParameter", "error", { name: read.name }, "contour")); return null;
  }
}

const moved = (before: number | null, value: number | null, incremental: boolean) =>
  value === null ? before : incremental ? (before ?? 0) + value : value;

function element(state: State, r: ContourRow, row: number): { element: ContourElement | null; reading: RowReading } {
  const inherited = { x: state.x, z: state.z };
  if (r.kind === "RND" || r.kind === "CHF") {
    const size = fieldValue(state, row, "r", r.r, false);
    return { element: { kind: r.kind === "RND" ? "round" : "chamfer", size: size ?? 0 }, reading: { end: null, inherited } };
  }
  const [x, z] = [fieldValue(state, row, "x", r.x, state.x !== null), fieldValue(state, row, "z", r.z, state.z !== null)];
  if (r.x.trim() === "" && r.z.trim() === "" && state.x !== null && state.z !== null)
    state.issues.push({ row, field: null, issue: issue("contourPoint", "error", { element: row + 1 }, "contour") });
  state.x = moved(state.x, x, r.incrementalX);
  state.z = moved(state.z, z, r.incrementalZ);
  const size = r.kind === "CR" ? fieldValue(state, row, "r", r.r, false) : null;
  if (state.x === null || state.z === null) return { element: null, reading: { end: null, inherited } };
  const to: Pt = { z: axial(state.z), r: toRadius(diameter(state.x)) };
  const made: ContourElement = size === null ? { kind: "line", to } : { kind: "radius", to, radius: size, turn: r.turn };
  return { element: made, reading: { end: { x: state.x, z: state.z }, inherited } };
}

/** The element a finding of the contour names, counted from 1. */
const elementOf = (found: Issue): number | null => ("element" in found.data ? found.data.element : null);

/** Reads the contour table: every row becomes one element, so that elements are numbered as the rows are. */
export function readRows(rows: readonly ContourRow[]): RowsReading {
  const state: State = { x: null, z: null, issues: [] };
  const read = rows.map((r, i) => element(state, r, i));
  const kept = read.flatMap(({ element: e }, row) => (e ? [{ e, row }] : []));
  const contour = contourFrom(kept.map(({ e }) => e));
  const rowOf = (n: number | null) => (n === null ? null : (kept[n - 1]?.row ?? null));
  const wrongRows = new Set(state.issues.map((found) => found.row));
  const geometry = contour.issues.flatMap((found): RowIssue[] => {
    const row = rowOf(elementOf(found));
    return row === null || wrongRows.has(row) ? [] : [{ row, field: found.code === "arcTooSmall" || found.code === "cornerElementTooLong" ? "r" : null, issue: numbered(found, row) }];
  });
  return {
    rows: read.map(({ reading }) => reading), contour,
    rowOfSegment: contour.elements.map((n) => rowOf(n) ?? 0),
    issues: [...state.issues, ...geometry].sort((a, b) => a.row - b.row),
  };
}

/** The finding with the number of its row, where unreadable rows before it were left out. */
const numbered = (found: Issue, row: number): Issue => ({ ...found, data: { ...found.data, element: row + 1 } }) as Issue;
