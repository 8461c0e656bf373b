import type { Pt } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { RowField, RowReading, RowsReading } from "./contour-rows.ts";
import { anyNumber, roundedTo, readText, sumOf } from "../values/field.ts";
import type { ContourRow } from "./job.ts";
import { isPolarRow, polarNames, polarOf, polarTyped, withPolar, type PolarName } from "./polar-row.ts";
import { SOLVE_MARK } from "./read-row.ts";
import { positionAsTyped } from "../values/typed-value.ts";

type Rows = readonly ContourRow[];

/** One dimension of an element as in a drawing: X as diameter and absolute, also for an incremental row. */
export interface ContourDimension {
  readonly row: number;
  readonly field: RowField;
  /** Its resulting value; null while unknown. */
  readonly value: number | null;
  /** Initial text of the input: the text of its field, or the value. */
  readonly text: string;
  /** It is not typed: inherited, or computed from other values. A print puts it in brackets. */
  readonly follows: boolean;
}

/** Decimals of an angle read from the drawing. */
const ANGLE_DECIMALS = 4;
const isEmpty = (text: string) => text.trim() === "" || text.trim() === SOLVE_MARK;
const numberOf = (text: string): number | null => readText({ ...anyNumber, decimals: null }, text).value;
const END_KINDS: readonly ContourRow["kind"][] = ["L", "CR", "C", "CT"];
/** Elements with a size: radius or chamfer. */
const SIZE_KINDS: readonly ContourRow["kind"][] = ["RND", "CHF", "CR"];

/** End point of an element, or the centre of a CC row. */
function pointOfRow(row: ContourRow, reading: RowReading): { readonly x: number; readonly z: number } | null {
  if (row.kind !== "CC") return reading.end;
  return reading.pole && { x: toDiameter(reading.pole.r), z: reading.pole.z };
}

const pointAt = ({ x, z }: { readonly x: number; readonly z: number }): Pt => ({
  z: axial(z),
  r: toRadius(diameter(x)),
});

/** Dimensions of an element, in keyboard order. */
export function dimensionsOf(rows: Rows, reading: RowsReading, index: number): readonly ContourDimension[] {
  const row = rows[index],
    read = reading.rows[index];
  if (!row || !read) return [];
  const one = (field: RowField, typed: string, value: number | null, isAdded = false): ContourDimension => {
    const follows = isEmpty(typed);
    const shown = follows || isAdded ? (value === null ? "" : positionAsTyped(value)) : typed;
    return { row: index, field, value, text: shown, follows };
  };
  if (isPolarRow(row)) {
    const at = read.pole && read.end ? polarOf(read.pole, pointAt(read.end)) : null;
    return polarNames(row).map((name) => {
      const { text, incremental } = polarTyped(row, name);
      return one(name, text, at && at[name], incremental);
    });
  }
  if (SIZE_KINDS.includes(row.kind) && row.kind !== "CR") return [one("r", row.r, numberOf(row.r))];
  const at = pointOfRow(row, read);
  const ends =
    END_KINDS.includes(row.kind) || row.kind === "CC"
      ? [one("x", row.x, at && at.x, row.incrementalX), one("z", row.z, at && at.z, row.incrementalZ)]
      : [];
  const first = read.inherited.x === null;
  if (row.kind === "CR") return [...ends, one("r", row.r, read.radius)];
  if (row.kind !== "L" || first) return ends;
  return [...ends, one("length", row.length, read.length), one("angle", row.angle, read.angle)];
}

/** Writes an absolute value into an incremental coordinate as an increment. */
function added(
  text: string,
  incremental: boolean,
  before: number | null,
): { readonly text: string; readonly incremental: boolean } {
  const value = numberOf(text);
  if (!incremental || text.trim() === "") return { text, incremental };
  return value === null || before === null
    ? { text, incremental: false }
    : { text: positionAsTyped(value - before), incremental };
}

/** Changes the angle of a line; the coordinate of its longer component stays. */
function turned(row: ContourRow, read: RowReading, text: string): Partial<ContourRow> {
  if (text.trim() === "") return { angle: text, ...(row.length.trim() === "" ? placed(row, read) : {}) };
  const open = { incrementalX: false, incrementalZ: false };
  if (row.length.trim() !== "") return { angle: text, x: "", z: "", ...open };
  const {
    end,
    inherited: { x, z },
  } = read;
  if (!end || x === null || z === null) return { angle: text };
  const { r: from } = pointAt({ x, z }),
    { r: to } = pointAt(end);
  return Math.abs(end.z - z) >= Math.abs(to - from)
    ? { angle: text, x: "", incrementalX: false, z: row.incrementalZ ? row.z : positionAsTyped(end.z) }
    : { angle: text, z: "", incrementalZ: false, x: row.incrementalX ? row.x : positionAsTyped(end.x) };
}

/** Changes the length of a line in its direction; a line along an axis stays written by its coordinate. */
function lengthened(row: ContourRow, read: RowReading, text: string): Partial<ContourRow> {
  if (text.trim() === "") return { length: text, ...(row.angle.trim() === "" ? placed(row, read) : {}) };
  const {
      end,
      inherited: { x, z },
      angle,
    } = read,
    value = numberOf(text);
  const open = { x: "", z: "", incrementalX: false, incrementalZ: false };
  if (row.angle.trim() !== "") return { length: text, ...open };
  if (!end || x === null || z === null || angle === null || value === null || row.length.trim() !== "" || row.tangent)
    return { length: text };
  const from = pointAt({ x, z }),
    to = pointAt(end);
  if (Math.abs(to.r - from.r) < SAME) {
    const way = Math.sign(to.z - from.z) * value;
    return { z: positionAsTyped(row.incrementalZ ? way : z + way) };
  }
  if (Math.abs(to.z - from.z) < SAME) {
    const way = toDiameter(radius(Math.sign(to.r - from.r) * value));
    return { x: positionAsTyped(row.incrementalX ? way : x + way) };
  }
  return { length: text, angle: String(roundedTo(angle, ANGLE_DECIMALS)), ...open };
}

/** Writes out the end point, because the value that defined it was removed. */
function placed(row: ContourRow, { end }: RowReading): Partial<ContourRow> {
  return end && isEmpty(row.x) && isEmpty(row.z)
    ? { x: positionAsTyped(end.x), z: positionAsTyped(end.z), incrementalX: false, incrementalZ: false }
    : {};
}

function polarChange(row: ContourRow, read: RowReading, name: PolarName, text: string): Partial<ContourRow> {
  const { incremental } = polarTyped(row, name),
    { x, z } = read.inherited;
  const before = read.pole && x !== null && z !== null ? polarOf(read.pole, pointAt({ x, z }))[name] : null;
  return { words: withPolar(row.words, name, added(text, incremental, before)) };
}

/**
 * Change of a row by a dimension typed in the drawing. Sums are evaluated; unreadable text is kept and reported in the
 * table.
 */
function changeOf(row: ContourRow, read: RowReading, field: RowField, typed: string): Partial<ContourRow> {
  const text = sumOf(typed) ?? typed;
  switch (field) {
    case "x": {
      const next = added(text, row.incrementalX, read.inherited.x);
      return { x: next.text, incrementalX: next.incremental };
    }
    case "z": {
      const next = added(text, row.incrementalZ, read.inherited.z);
      return { z: next.text, incrementalZ: next.incremental };
    }
    case "r":
      return { r: text };
    case "angle":
      return turned(row, read, text);
    case "length":
      return lengthened(row, read, text);
    default:
      return polarChange(row, read, field, text);
  }
}

/** The table with a dimension typed in the drawing. */
export function dimensionTyped(rows: Rows, reading: RowsReading, index: number, field: RowField, typed: string): Rows {
  const row = rows[index],
    read = reading.rows[index];
  if (!row || !read) return rows;
  const change = changeOf(row, read, field, typed);
  const same = Object.entries(change).every(([name, value]) => row[name as keyof ContourRow] === value);
  return same ? rows : rows.with(index, { ...row, ...change });
}

/** Constraint mark at an element. */
export type Hold = "tangent" | "horizontal" | "vertical" | "sought";

/** Constraints of an element besides typed coordinates: tangency, unchanged coordinates, solved values. */
export function holdsOf(row: ContourRow, read: RowReading): readonly Hold[] {
  const {
    end,
    inherited: { x, z },
    solvedAxes,
  } = read;
  const stays = (typed: string, from: number | null, to: number | null, isSought: boolean) =>
    typed.trim() === "" && from !== null && to !== null && !isSought && Math.abs(to - from) < SAME;
  const isLine = row.kind === "L";
  return [
    ...(row.tangent || row.kind === "CT" || row.kind === "CTP" ? ["tangent" as const] : []),
    ...(isLine && stays(row.x, x, end && end.x, solvedAxes.x) ? ["horizontal" as const] : []),
    ...(isLine && stays(row.z, z, end && end.z, solvedAxes.z) ? ["vertical" as const] : []),
    ...(solvedAxes.x || solvedAxes.z || read.missingValues > 0 || row.r.trim() === SOLVE_MARK
      ? ["sought" as const]
      : []),
  ];
}
