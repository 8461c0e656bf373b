import type { Statement } from "../../nc/statement.ts";
import { noWords, type AxisWord, type NamedWord, type Value, type Words } from "../../nc/words.ts";
import { readRows, type RowReading } from "./contour-rows.ts";
import { roundedTo } from "../values/field.ts";
import type { ContourRow } from "./job.ts";
import { polarWords } from "./polar-row.ts";
import { formWord } from "../blocks/recess-words.ts";
import { recessWords } from "./read-row.ts";
import { POSITION_DECIMALS, typedAxis, typedValue } from "../values/typed-value.ts";

const path = (
  kind: "L" | "RND" | "CR" | "C" | "CC" | "CT" | "LP" | "CP" | "CTP",
  words: Partial<Words>,
): Statement => ({
  kind: "path",
  path: kind,
  words: { ...noWords, ...words },
});

/** X and Z as typed; where one was solved, both as numbers, so that the control needs no more. */
function axesOf(row: ContourRow, reading: RowReading | undefined): AxisWord[] {
  const typed = [...typedAxis("X", row.x, row.incrementalX), ...typedAxis("Z", row.z, row.incrementalZ)];
  if (!reading?.end || !(reading.solvedAxes.x || reading.solvedAxes.z)) return typed;
  const word = (axis: "X" | "Z", value: number): AxisWord => ({
    axis,
    value: roundedTo(value, POSITION_DECIMALS),
    incremental: false,
  });
  const { x, z } = reading.end;
  return [
    ...(reading.solvedAxes.x || row.incrementalX ? [word("X", x)] : typed.filter((w) => w.axis === "X")),
    ...(reading.solvedAxes.z || row.incrementalZ ? [word("Z", z)] : typed.filter((w) => w.axis === "Z")),
  ];
}

/** Typed words of an undercut or recess. */
const namedWords = (row: ContourRow): NamedWord[] =>
  recessWords(row).flatMap((name) => {
    const value = typedValue(row.words[name] ?? "");
    return value === null ? [] : [{ name, value }];
  });

/** Elements described by their end point; others may be full circles. */
const NAMES_ITS_END: ReadonlySet<ContourRow["kind"]> = new Set(["L", "CR", "CT", "LP", "CTP"]);

function statement(row: ContourRow, reading: RowReading | undefined): Statement[] {
  const axes = axesOf(row, reading),
    size = typedValue(row.r);
  if (reading && (reading.solvedAxes.x || reading.solvedAxes.z) && !reading.end && axes.length === 0) return [];
  if (NAMES_ITS_END.has(row.kind) && axes.length === 0 && Object.keys(polarWords(row)).length === 0) return [];
  switch (row.kind) {
    case "L":
      return [path("L", { axes })];
    case "CR": {
      const radius: Value | null =
        size ??
        (reading === undefined || reading.radius === null ? null : roundedTo(reading.radius, POSITION_DECIMALS));
      return [
        path("CR", {
          axes,
          ...(radius !== null && { radius }),
          turn: (size === null ? reading?.turn : null) ?? row.turn,
        }),
      ];
    }
    case "C":
      return [path("C", { axes, turn: row.turn })];
    case "CC":
    case "CT":
      return [path(row.kind, { axes })];
    case "LP":
    case "CTP":
      return [path(row.kind, polarWords(row))];
    case "CP":
      return [path("CP", { ...polarWords(row), turn: row.turn })];
    case "RND":
      return [path("RND", size === null ? {} : { radius: size })];
    case "UDC":
      return [{ kind: "undercut", form: formWord(row.form), words: namedWords(row) }];
    case "GRV":
      return [{ kind: "groove", form: row.form === "AXIAL" ? "AXIAL" : "RADIAL", words: namedWords(row) }];
    case "CHF":
      return [{ kind: "chamfer", length: size, words: noWords }];
  }
}

/** Whether a row has a block in the program. */
export const hasBlock = (row: ContourRow, reading: RowReading | undefined): boolean =>
  statement(row, reading).length > 0;

const known = new WeakMap<readonly ContourRow[], readonly Statement[]>();

/**
 * Blocks of a contour table, cached per state: typed values and solved coordinates. An unsolved element has no block.
 */
export function contourStatements(rows: readonly ContourRow[]): readonly Statement[] {
  const reading = readRows(rows),
    made = known.get(rows) ?? rows.flatMap((row, i) => statement(row, reading.rows[i]));
  known.set(rows, made);
  return made;
}
