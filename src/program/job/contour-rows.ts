import { contourFrom, type Contour, type ContourElement } from "../../kernel/contour/contour.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import { part, type Pt } from "../../kernel/geometry/point.ts";
import { solveContour, type SolvedElement } from "../../kernel/solve/solve-contour.ts";
import type { SolveElement } from "../../kernel/solve/solve-work.ts";
import { toDiameter } from "../../kernel/units.ts";
import type { ContourRow } from "./job.ts";
import { readRow, type ReadRow } from "./read-row.ts";
import { begun, type RowField, type RowIssue, type RowReader } from "./row-reader.ts";
import { ROUND } from "../../kernel/tolerance.ts";

export type { RowField, RowIssue } from "./row-reader.ts";

/** Reading of one row. X values are diameters, mm. */
export interface RowReading {
  /** End of the element; null while unknown, and for corners and centres. */
  readonly end: { readonly x: number; readonly z: number } | null;
  /** End in a coordinate that is left out. */
  readonly inherited: { readonly x: number | null; readonly z: number | null };
  /** Coordinates solved from other values. */
  readonly solvedAxes: { readonly x: boolean; readonly z: boolean };
  /** Angle to +Z and length of a line, radius and turn of an arc, typed or solved; null while unknown. */
  readonly angle: number | null;
  readonly length: number | null;
  readonly radius: number | null;
  readonly turn: "cw" | "ccw" | null;
  /** Active pole, or centre of the arc. */
  readonly pole: Pt | null;
  /** Number of missing values. */
  readonly missingValues: number;
  /** Number of solutions. */
  readonly choices: number;
}

/** A contour table as read: its drawable geometry, and its issues with their places. */
export interface RowsReading {
  readonly rows: readonly RowReading[];
  readonly contour: Contour;
  /** Index of the row that made each segment of the contour. */
  readonly rowOfSegment: readonly number[];
  readonly issues: readonly RowIssue[];
}

/** Element number of a contour issue, from 1. */
const elementOf = (found: Issue): number | null => ("element" in found.data ? found.data.element : null);

/** Field of a row for an issue. */
function fieldOf(found: Issue): RowField | null {
  if (found.code === "arcTooSmall" || found.code === "cornerElementTooLong") return "r";
  if (found.code !== "elementContradicts" || found.data.quantity === "tangent") return null;
  return found.data.quantity === "radius" ? "r" : found.data.quantity;
}

const known = new WeakMap<readonly ContourRow[], RowsReading>();

/** Reads the contour table, cached per state; coordinates that are not typed are solved where possible. */
export function readRows(rows: readonly ContourRow[]): RowsReading {
  const read = known.get(rows) ?? solveRows(rows);
  known.set(rows, read);
  return read;
}

function solveRows(rows: readonly ContourRow[]): RowsReading {
  const reader: RowReader = { x: null, z: null, pole: null, issues: [] };
  const poles: (Pt | null)[] = [];
  const given = rows.map((row, i) => {
    const read = readRow(reader, row, i);
    poles.push(reader.pole);
    return read;
  });
  const asked = given.flatMap((g, row) => (g.kind === "element" ? [{ element: g.element, row }] : []));
  const solution = solveContour(asked.map(({ element }) => element));
  const solved = new Map(asked.map(({ row }, i) => [row, solution.elements[i]]));
  const kept = rows.flatMap((_, row) => {
    const e = contourElement(given[row], solved.get(row));
    return e ? [{ e, row }] : [];
  });
  const contour = contourFrom(kept.map(({ e }) => e));
  const rowOf = (n: number | null) => (n === null ? null : (kept[n - 1]?.row ?? null));
  const typed = new Set(reader.issues.map((found) => found.row));
  const found = [
    ...solution.issues.map((i) => ({ i, row: asked[(elementOf(i) ?? 0) - 1]?.row ?? null })),
    ...contour.issues.map((i) => ({ i, row: rowOf(elementOf(i)) })),
  ].flatMap(({ i, row }): RowIssue[] =>
    row === null || typed.has(row) ? [] : [{ row, field: fieldOf(i), issue: numbered(i, row, rowOf) }],
  );
  return {
    rows: readings(given, poles, solved),
    contour,
    rowOfSegment: contour.elements.map((n) => rowOf(n) ?? 0),
    issues: [...reader.issues, ...found]
      .map((each) => (begun(rows[each.row]) ? each : calm(each)))
      .sort((a, b) => a.row - b.row),
  };
}

/** An empty row is not wrong, only not begun. */
const calm = (found: RowIssue): RowIssue =>
  found.issue.code === "missing"
    ? { ...found, issue: { ...found.issue, severity: "info" } as RowIssue["issue"] }
    : found;

/** Converts element numbers of an issue into row numbers, since some rows make no element. */
function numbered(found: Issue, row: number, rowOf: (n: number) => number | null): Issue {
  const other =
    "other" in found.data && typeof found.data.other === "number" ? { other: (rowOf(found.data.other) ?? 0) + 1 } : {};
  return { ...found, data: { ...found.data, element: row + 1, ...other } } as Issue;
}

const pointOf = (s: SolvedElement | undefined): Pt | null =>
  s && s.z !== null && s.r !== null ? { z: s.z, r: s.r } : null;

/** Radius as CR writes it: negative where the arc takes the longer way. */
function signedRadius(s: SolvedElement | undefined): number | null {
  const arc = s?.segment;
  if (arc?.kind !== "arc") return null;
  const size = Math.hypot(arc.from.z - arc.centre.z, arc.from.r - arc.centre.r);
  return part.sweepOf(arc) > Math.PI + ROUND ? -size : size;
}

/** The element with all coordinates; null while its end is unknown. */
function contourElement(given: ReadRow | undefined, solved: SolvedElement | undefined): ContourElement | null {
  if (given?.kind === "corner") return given.corner;
  if (given?.kind === "recess") return given.recess;
  const to = pointOf(solved);
  if (given?.kind !== "element" || !to) return null;
  const e: SolveElement = given.element;
  if (e.kind === "line") return { kind: "line", to };
  if (e.centre) return { kind: "centre", to, centre: e.centre, turn: e.turn ?? "ccw" };
  if (e.radius !== null) return { kind: "radius", to, radius: e.radius, turn: e.turn ?? "ccw" };
  const arc = solved?.segment,
    radius = signedRadius(solved);
  if (e.turn === null) return { kind: "tangent", to };
  return arc?.kind === "arc" && radius !== null ? { kind: "radius", to, radius, turn: arc.turn } : { kind: "line", to };
}

function readings(
  given: readonly ReadRow[],
  poles: readonly (Pt | null)[],
  solved: ReadonlyMap<number, SolvedElement | undefined>,
): RowReading[] {
  let [x, z]: (number | null)[] = [null, null];
  return given.map((g, i): RowReading => {
    const inherited = { x: x ?? null, z: z ?? null },
      pole = poles[i] ?? null,
      s = solved.get(i),
      at = pointOf(s);
    if (g.kind !== "element" || !s)
      return {
        end: null,
        inherited,
        pole,
        solvedAxes: { x: false, z: false },
        angle: null,
        length: null,
        radius: null,
        turn: null,
        missingValues: 0,
        choices: 1,
      };
    [x, z] = [s.r === null ? null : toDiameter(s.r), s.z];
    return {
      end: at && { x: toDiameter(at.r), z: at.z },
      inherited,
      pole,
      solvedAxes: g.solvedAxes,
      angle: s.angle,
      length: s.length,
      radius: signedRadius(s),
      turn: s.segment?.kind === "arc" ? s.segment.turn : null,
      missingValues: s.freedom,
      choices: s.choices,
    };
  });
}
