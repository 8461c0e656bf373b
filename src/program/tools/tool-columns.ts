import { DRILL_TYPES, TOOL_TYPES, type DrillType, type ToolType } from "../../kernel/plan/tool.ts";
import type { Field } from "../values/field.ts";

/** The columns of the turning-tool table, in the order of the table. */
export const TOOL_COLUMNS = [
  "T",
  "NAME",
  "ZL",
  "XL",
  "DZL",
  "DXL",
  "DYL",
  "RS",
  "DRS",
  "TO",
  "ORI",
  "T-ANGLE",
  "P-ANGLE",
  "CUTLENGTH",
  "CUTWIDTH",
  "DCW",
  "TYPE",
] as const;
export type ToolColumn = (typeof TOOL_COLUMNS)[number];
/** Numbers of the holder, beside the columns of the control. */
export const HOLDER_NUMBERS = ["width", "length", "offsetZ", "offsetX"] as const;
export type HolderNumber = (typeof HOLDER_NUMBERS)[number];
/** Cells of the holder: its numbers, the axis of its shank, and its head as corners. */
export const HOLDER_CELLS = [...HOLDER_NUMBERS, "axis", "head"] as const;
export type HolderCell = (typeof HOLDER_CELLS)[number];
/**
 * What the maker states about the use of a blade or a bar, beside the columns of the control, by the symbols of ISO
 * 13399: diameters of an axial groove, cutting depth, largest diameter to part off, smallest bore.
 */
export const LIMIT_NUMBERS = ["DAXN", "DAXX", "CDX", "CUTDIA", "DMIN"] as const;
export type LimitNumber = (typeof LIMIT_NUMBERS)[number];
/** The limits with the support of a blade. */
export const LIMIT_CELLS = [...LIMIT_NUMBERS, "SUPPORT"] as const;
/** Length of a drill's point, beside the columns of the control. */
export const POINT_LENGTH = "PL";
/** Cells of a row that no table of the control has. */
export const BESIDE_CELLS = [...HOLDER_CELLS, ...LIMIT_CELLS, POINT_LENGTH] as const;
export type BesideCell = (typeof BESIDE_CELLS)[number];
/**
 * Columns of a milling tool besides T and NAME: length, radius, their deltas, cutting edge length of a drill, pitch of
 * a tap. The point angle of a drill is in T-ANGLE.
 */
export const MILL_COLUMNS = ["L", "R", "DL", "DR", "LCUTS", "PITCH"] as const;
export type MillColumn = (typeof MILL_COLUMNS)[number];
export type NumberColumn = Exclude<ToolColumn, "NAME" | "TYPE"> | MillColumn;
export type CellName = ToolColumn | MillColumn | BesideCell;
/** Cells that hold one number. */
export type NumberCell = NumberColumn | HolderNumber | LimitNumber | typeof POINT_LENGTH;
/** Type of a milling tool that is no drill. */
export const MILL = "MILL";
/** Types of the table of milling tools. */
export const MILL_TYPES = [MILL, ...DRILL_TYPES] as const;
/** Columns of that table after T, NAME and the type, in order. */
export const MILL_TABLE = [
  "R",
  "DR",
  "L",
  "DL",
  "T-ANGLE",
  "LCUTS",
  "PITCH",
] as const satisfies readonly NumberColumn[];

/**
 * Rules of a number column. The ranges are recalled (tag K1, K2), not read on a printed page: the printed values for
 * DXL, DYL and DZL, ±999.9999, belong to the compensation table `.tco` (TNC7 basic, 81762x-19).
 */
export interface ColumnRule {
  readonly kind: "length" | "angle" | "number";
  readonly range: Field["range"];
  /** Decimals of the control. More typed decimals are kept; tables are printed and shown with these. */
  readonly decimals: number;
}

const FAR = 99999.9999;
const anyLength: ColumnRule = { kind: "length", range: [-FAR, FAR], decimals: 4 };
const size: ColumnRule = { kind: "length", range: [0, FAR], decimals: 4 };
const angle: ColumnRule = { kind: "angle", range: [0, 179.999], decimals: 3 };

export const COLUMN_RULES: Readonly<Record<NumberColumn, ColumnRule>> = {
  T: { kind: "number", range: [0, 32767.9], decimals: 1 },
  ZL: anyLength,
  XL: anyLength,
  DZL: anyLength,
  DXL: anyLength,
  DYL: anyLength,
  RS: size,
  DRS: { ...anyLength, range: [-999.9999, 999.9999] },
  TO: { kind: "number", range: [1, 9], decimals: 0 },
  ORI: { kind: "angle", range: [-360, 360], decimals: 3 },
  "T-ANGLE": angle,
  "P-ANGLE": angle,
  CUTLENGTH: size,
  CUTWIDTH: size,
  DCW: anyLength,
  L: anyLength,
  R: size,
  DL: anyLength,
  DR: { ...anyLength, range: [-999.9999, 999.9999] },
  LCUTS: size,
  PITCH: { ...size, range: [0, 9.9999] },
};
/** The point of a drill may be flat. */
const POINT: ColumnRule = { ...angle, range: [0, 180] };

/** The smallest side of a holder box, mm. */
const LEAST_SIDE = 0.001;
export const HOLDER_RULES: Readonly<Record<HolderNumber, ColumnRule>> = {
  width: { ...size, range: [LEAST_SIDE, FAR] },
  length: { ...size, range: [LEAST_SIDE, FAR] },
  offsetZ: anyLength,
  offsetX: anyLength,
};

const isHolderNumber = (cell: string): cell is HolderNumber => HOLDER_NUMBERS.some((each) => each === cell);
/** Whether a cell is one of the limits. */
export const isLimit = (cell: string): cell is LimitNumber => LIMIT_NUMBERS.some((each) => each === cell);

export const isToolType = (text: string): text is ToolType => TOOL_TYPES.some((type) => type === text);
export const isDrillType = (text: string): text is DrillType => DRILL_TYPES.some((type) => type === text);
export const isMillType = (text: string): boolean => MILL_TYPES.some((type) => type === text);

/** Rule of a cell for a tool type. */
export function ruleOf(cell: NumberCell, type = ""): ColumnRule {
  if (isHolderNumber(cell)) return HOLDER_RULES[cell];
  if (isLimit(cell) || cell === POINT_LENGTH) return size;
  return cell === "T-ANGLE" && isDrillType(type) ? POINT : COLUMN_RULES[cell];
}

/** Columns that shape the insert of some types only; all others apply to every type. */
const SHAPING: Partial<Record<CellName, readonly (ToolType | DrillType)[]>> = {
  "T-ANGLE": ["ROUGH", "FINISH", "DRILL", "CENTER"],
  "P-ANGLE": ["ROUGH", "FINISH", "THREAD"],
  CUTLENGTH: ["ROUGH", "FINISH", "RECESS", "RECTURN", "THREAD"],
  CUTWIDTH: ["RECESS", "RECTURN"],
  DCW: ["RECESS", "RECTURN"],
  LCUTS: DRILL_TYPES,
  PITCH: ["TAP"],
  DAXN: ["RECESS", "RECTURN"],
  DAXX: ["RECESS", "RECTURN"],
  CDX: ["RECESS", "RECTURN"],
  CUTDIA: ["RECESS", "RECTURN"],
  SUPPORT: ["RECESS", "RECTURN"],
  PL: ["DRILL", "CENTER"],
};

/** Whether a column applies to a type; with an unknown type all do. */
export function applies(column: CellName, type: string): boolean {
  const types: readonly string[] | undefined = SHAPING[column];
  return !types || !(isToolType(type) || isMillType(type)) || types.includes(type);
}
