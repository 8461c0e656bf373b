import type { CornerElement } from "../../kernel/contour/corner.ts";
import { issue } from "../../kernel/plan/issue.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { GivenCoordinate, SolveElement } from "../../kernel/solve/solve-work.ts";
import { axial, degrees, diameter, length, toRadius, type Axial, type Radius } from "../../kernel/units.ts";
import { grooveDiameters, GROOVE_WORDS, type Groove } from "../../kernel/contour/groove.ts";
import {
  UNDERCUT_FORMS,
  UNDERCUT_WORDS,
  type RecessWord,
  type RecessWords,
  type Undercut,
} from "../../kernel/contour/undercut.ts";
import type { Field } from "../values/field.ts";
import type { ContourRow } from "./job.ts";
import { isPolarRow, polarGiven } from "./polar-row.ts";
import {
  OPTIONAL_NUMBER,
  REQUIRED_NUMBER,
  reportNoMotion,
  rowNumber,
  type RowField,
  type RowReader,
} from "./row-reader.ts";

/** Content of one row: a corner, an element to be solved, an undercut or recess, or a centre, which is no element. */
export type ReadRow =
  | { readonly kind: "corner"; readonly corner: CornerElement }
  | {
      readonly kind: "element";
      readonly element: SolveElement;
      readonly solvedAxes: { readonly x: boolean; readonly z: boolean };
    }
  | { readonly kind: "recess"; readonly recess: Undercut | Groove }
  | { readonly kind: "centre" };

/** A coordinate typed as a question mark is to be solved. */
export const SOLVE_MARK = "?";
const empty = (typed: string) => typed.trim() === "";
const isSolveMark = (typed: string) => typed.trim() === SOLVE_MARK;

/** True where an empty coordinate of this row is solved instead of unchanged. */
export function solvesEmptyCoordinates(row: ContourRow): boolean {
  if (row.kind === "L") return row.tangent || !empty(row.angle) || !empty(row.length);
  return (row.kind === "CR" || row.kind === "C") && row.tangent;
}

/** A length above 0. */
const SIZE: Field = { ...OPTIONAL_NUMBER, range: [0.001, 99999.999] };

type Coordinate = { readonly by: number } | { readonly at: number } | null;

/** Coordinate of a row, and its position as far as typed values alone define it. */
function coordinate(reader: RowReader, row: ContourRow, index: number, axis: "x" | "z"): Coordinate {
  const typed = row[axis],
    incremental = axis === "x" ? row.incrementalX : row.incrementalZ,
    before = reader[axis];
  if (isSolveMark(typed) || (empty(typed) && before !== null && solvesEmptyCoordinates(row))) {
    reader[axis] = "sought";
    return null;
  }
  const value = rowNumber(reader, index, axis, typed, before === null ? REQUIRED_NUMBER : OPTIONAL_NUMBER);
  if (value === null) return before === null ? null : { by: 0 };
  if (!incremental || before === null) {
    reader[axis] = value;
    return { at: value };
  }
  reader[axis] = before === "sought" ? before : before + value;
  return { by: value };
}

const onAxis = (c: Coordinate): GivenCoordinate<Axial> => c && ("at" in c ? { at: axial(c.at) } : { by: axial(c.by) });
const onRadius = (c: Coordinate): GivenCoordinate<Radius> =>
  c && ("at" in c ? { at: toRadius(diameter(c.at)) } : { by: toRadius(diameter(c.by)) });

/** Centre of a CC row: typed, or the end of the last row. */
function centreOf(reader: RowReader, row: ContourRow, index: number): Pt | null {
  const say = (field: RowField) =>
    reader.issues.push({ row: index, field, issue: issue("missing", "error", {}, "contour") });
  const one = (axis: "x" | "z", incremental: boolean): number | null => {
    const before = reader[axis],
      value = rowNumber(reader, index, axis, row[axis], OPTIONAL_NUMBER);
    if (value !== null && !incremental) return value;
    if (typeof before === "number") return before + (value ?? 0);
    if (value !== null || empty(row[axis])) say(axis);
    return null;
  };
  const [x, z] = [one("x", row.incrementalX), one("z", row.incrementalZ)];
  return x === null || z === null ? null : { z: axial(z), r: toRadius(diameter(x)) };
}

/** True for a word that is a diameter in this row. */
export const isDiameterWord = (row: ContourRow, word: RecessWord): boolean =>
  row.kind === "GRV" && grooveDiameters(row.form === "AXIAL" ? "axial" : "radial").includes(word);

/** Words of an undercut or recess row, in the order of the control. */
export function recessWords(row: ContourRow): readonly RecessWord[] {
  if (row.kind === "GRV") return GROOVE_WORDS;
  const form = UNDERCUT_FORMS.find((f) => f === row.form);
  return row.kind === "UDC" && form ? UNDERCUT_WORDS[form] : [];
}

function recessOfRow(reader: RowReader, row: ContourRow, index: number): Undercut | Groove {
  const measured = (word: RecessWord, n: number) => (isDiameterWord(row, word) ? toRadius(diameter(n)) : n);
  const words: RecessWords = Object.fromEntries(
    recessWords(row).flatMap((word) => {
      const n = rowNumber(reader, index, null, row.words[word] ?? "", OPTIONAL_NUMBER);
      return n === null ? [] : [[word, measured(word, n)] as const];
    }),
  );
  if (row.kind === "GRV") return { kind: "groove", direction: row.form === "AXIAL" ? "axial" : "radial", words };
  return { kind: "undercut", form: UNDERCUT_FORMS.find((f) => f === row.form) ?? "E", words };
}

/** Reads one row. */
export function readRow(reader: RowReader, row: ContourRow, index: number): ReadRow {
  if (row.kind === "RND" || row.kind === "CHF") {
    const size = rowNumber(reader, index, "r", row.r, REQUIRED_NUMBER);
    return { kind: "corner", corner: { kind: row.kind === "RND" ? "round" : "chamfer", size: size ?? 0 } };
  }
  if (row.kind === "UDC" || row.kind === "GRV") return { kind: "recess", recess: recessOfRow(reader, row, index) };
  if (row.kind === "CC") {
    reader.pole = centreOf(reader, row, index);
    return { kind: "centre" };
  }
  if (isPolarRow(row)) {
    const end = polarGiven(reader, row, index);
    return {
      kind: "element",
      element: shape(reader, row, index, { ...end, choice: row.second ? 1 : 0 }),
      solvedAxes: { x: false, z: false },
    };
  }
  const before = { x: reader.x, z: reader.z };
  const [x, z] = [coordinate(reader, row, index, "x"), coordinate(reader, row, index, "z")];
  const still = empty(row.x) && empty(row.z) && before.x !== null && before.z !== null && !solvesEmptyCoordinates(row);
  if (still && row.kind !== "C") reportNoMotion(reader, row, index);
  const common = { z: onAxis(z), r: onRadius(x), choice: row.second ? (1 as const) : (0 as const) };
  return {
    kind: "element",
    element: shape(reader, row, index, common),
    solvedAxes: {
      x: (x === null && before.x !== null) || isSolveMark(row.x),
      z: (z === null && before.z !== null) || isSolveMark(row.z),
    },
  };
}

function shape(
  reader: RowReader,
  row: ContourRow,
  index: number,
  common: Pick<SolveElement, "z" | "r" | "choice">,
): SolveElement {
  const arc = { ...common, kind: "arc" as const, turn: row.turn, radius: null, centre: null, tangent: row.tangent };
  switch (row.kind) {
    case "LP":
      return { ...common, kind: "line", angle: null, length: null, tangent: false };
    case "CP":
      return { ...arc, tangent: false, centre: reader.pole };
    case "CT":
    case "CTP":
      return { ...arc, turn: null, tangent: true };
    case "C":
      if (!reader.pole)
        reader.issues.push({
          row: index,
          field: null,
          issue: issue("centreMissing", "error", { element: index + 1 }, "contour"),
        });
      return { ...arc, centre: reader.pole };
    case "CR":
      return {
        ...arc,
        radius: isSolveMark(row.r)
          ? null
          : rowNumber(reader, index, "r", row.r, row.tangent ? OPTIONAL_NUMBER : REQUIRED_NUMBER),
      };
    default: {
      const [angle, far] = [
        rowNumber(reader, index, "angle", row.angle, OPTIONAL_NUMBER),
        rowNumber(reader, index, "length", row.length, SIZE),
      ];
      return {
        ...common,
        kind: "line",
        angle: angle === null ? null : degrees(angle),
        length: far === null ? null : length(far),
        tangent: row.tangent,
      };
    }
  }
}
