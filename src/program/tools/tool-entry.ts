import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { fixesFinding, offerOf, withOffer } from "../../kernel/plan/offer.ts";
import { BLADE_SUPPORTS, USUAL_TOOTH, type BladeSupport, type DrillType, type Tool } from "../../kernel/plan/tool.ts";
import { radians } from "../../kernel/units.ts";
import { checkTool } from "./check-tool.ts";
import { readText } from "../values/field.ts";
import { readAxis, readHead, writeHead } from "./holder-cells.ts";
import {
  applies,
  HOLDER_CELLS,
  HOLDER_NUMBERS,
  isDrillType,
  isMillType,
  LIMIT_CELLS,
  LIMIT_NUMBERS,
  MILL_TABLE,
  POINT_LENGTH,
  ruleOf,
  TOOL_COLUMNS,
  type CellName,
  type NumberCell,
} from "./tool-columns.ts";

/** Source file of table rows, kept so that it can be exported with nothing else changed. */
export interface TableOrigin {
  readonly name: string;
  readonly text: string;
  readonly encoding: "utf-8" | "windows-1252";
}

/** A table file with a non-enumerable text: otherwise serializing rows one by one would repeat it in each. */
export function tableOrigin(name: string, text: string, encoding: TableOrigin["encoding"]): TableOrigin {
  return Object.defineProperty({ name, text, encoding }, "text", { enumerable: false });
}

/** Whether a row still has its complete source file: a row that was serialized alone has not. */
export const hasFile = ({ line }: ToolEntry): boolean => typeof line?.origin.text === "string";

/** Source line of a row in a table file. */
export interface TableLine {
  readonly origin: TableOrigin;
  readonly at: number;
}

/** One row of the tool table as typed: every cell is text, an empty or missing cell is empty. */
export interface ToolEntry {
  readonly id: string;
  readonly cells: Readonly<Partial<Record<CellName, string>>>;
  readonly line?: TableLine;
}

/**
 * A milling tool or a drill with all its columns, mm and degrees; a missing cell is absent, and so is the type of a
 * mill.
 */
export type MillTool = { readonly T: number; readonly NAME: string; readonly R: number; readonly TYPE?: DrillType } & {
  readonly [C in Exclude<(typeof MILL_TABLE)[number], "R"> | typeof POINT_LENGTH]?: number;
};

/** A row read: the tool when every cell can be used, and everything found, each at its column. */
export interface EntryReading {
  readonly tool: Tool | null;
  /** The same for a row of a milling tool. */
  readonly mill: MillTool | null;
  /** Number of the tool; null while none can be read. */
  readonly number: number | null;
  readonly issues: readonly Issue[];
}

export const cellOf = (entry: ToolEntry, cell: CellName): string => entry.cells[cell] ?? "";

export const isMillEntry = (entry: ToolEntry): boolean => isMillType(cellOf(entry, "TYPE"));

/** A tool as a typed row. */
export function entryOf(tool: Tool, id: string): ToolEntry {
  const cells: Partial<Record<CellName, string>> = {};
  for (const column of [...TOOL_COLUMNS, ...LIMIT_CELLS]) {
    const value = tool[column];
    if (value !== undefined) cells[column] = String(value);
  }
  const { holder } = tool;
  if (holder) {
    for (const cell of HOLDER_NUMBERS) cells[cell] = String(holder[cell]);
    if (holder.axis) cells.axis = holder.axis;
    if (holder.head && holder.head.length > 0) cells.head = writeHead(holder.head);
  }
  return { id, cells };
}

/**
 * Longest name of the control, and the characters it takes (TNC7, 81762x-16, topic on tool names). It turns small
 * letters into capitals on saving, as the page does while they are typed; a file may bring others.
 */
const LONGEST_NAME = 32;
const NAME = /^[A-Z0-9#$%&,\-._]*$/;

function nameIssues(text: string): Issue[] {
  if (text.length > LONGEST_NAME) return [issue("toolName", "error", { text, max: LONGEST_NAME }, "NAME")];
  return NAME.test(text) ? [] : [issue("toolName", "warning", { text, max: LONGEST_NAME }, "NAME")];
}

/** One number: its value, null when empty, or its issue. */
function numberOf(cell: NumberCell, text: string, type: string): number | null | Issue {
  const { value, issue: found } = readText({ ...ruleOf(cell, type), id: cell, optional: true, decimals: null }, text);
  return found?.code === "outOfRange"
    ? issue("toolColumn", "error", { column: cell, ...found.data }, cell)
    : (found ?? value);
}

interface Numbers {
  readonly values: Partial<Record<NumberCell, number>>;
  readonly issues: readonly Issue[];
}

/** All numbers of a row. Cells that do not apply to its type are taken when valid and never reported. */
function numbersOf(entry: ToolEntry): Numbers {
  const type = cellOf(entry, "TYPE");
  const values: Partial<Record<NumberCell, number>> = {};
  const issues: Issue[] = [];
  const columns = TOOL_COLUMNS.filter((column) => column !== "NAME" && column !== "TYPE");
  for (const cell of [...columns, ...HOLDER_NUMBERS, ...LIMIT_NUMBERS]) {
    const read = numberOf(cell, cellOf(entry, cell), type);
    if (read === null) continue;
    if (typeof read === "number") values[cell] = read;
    else if (HOLDER_NUMBERS.some((each) => each === cell) || applies(cell, type)) issues.push(read);
  }
  for (const cell of ["CUTLENGTH", ...LIMIT_NUMBERS] as const) if (values[cell] === 0) delete values[cell];
  return { values, issues };
}

/** A holder exists as soon as one of its cells is filled; its sides are then required, empty offsets are 0. */
function holderIssues(entry: ToolEntry): Issue[] {
  if (!HOLDER_CELLS.some((cell) => cellOf(entry, cell).trim() !== "")) return [];
  const [axis, head] = [cellOf(entry, "axis"), cellOf(entry, "head")];
  return [
    ...(["width", "length"] as const)
      .filter((cell) => cellOf(entry, cell).trim() === "")
      .map((cell) => issue("missing", "error", {}, cell)),
    ...(readAxis(axis) === null ? [issue("holderAxis", "error", { text: axis }, "axis")] : []),
    ...(readHead(head) === null ? [issue("holderHead", "error", { text: head }, "head")] : []),
  ];
}

/** Reads the support of a blade; null when invalid. */
export const readSupport = (text: string): BladeSupport | "" | null => {
  const word = text.trim().toUpperCase();
  return word === "" ? "" : (BLADE_SUPPORTS.find((each) => each === word) ?? null);
};

/** Limits that contradict each other, and an unknown word for the support, where the type uses them. */
function limitIssues(entry: ToolEntry, { DAXN, DAXX, TO }: Numbers["values"]): Issue[] {
  const text = cellOf(entry, "SUPPORT");
  if (!applies("SUPPORT", cellOf(entry, "TYPE"))) return [];
  return [
    ...(readSupport(text) === null ? [issue("bladeSupport", "error", { text }, "SUPPORT")] : []),
    ...(readSupport(text) === "STRAIGHT" && (TO === 4 || TO === 8)
      ? [issue("straightBlade", "warning", {}, "SUPPORT")]
      : []),
    ...(DAXN !== undefined && DAXX !== undefined && DAXX < DAXN
      ? [issue("toolColumn", "error", { column: "DAXX", value: DAXX, min: DAXN }, "DAXX")]
      : []),
  ];
}

/** Keeps the first issue of each column. */
function firstOfEach(all: readonly Issue[]): Issue[] {
  const found = new Map<string | undefined, Issue>();
  for (const each of all) if (!found.has(each.at)) found.set(each.at, each);
  return [...found.values()];
}

/** Stated lengths of a point are rounded, and its edges are relieved at the corner, mm. */
const SAME_POINT = 0.2;

/** Smallest radius of a drill. */
const LEAST_DRILL = 0.001;

/** Reads the row of a milling tool or a drill: its radius is required, and must stay positive with its delta. */
function readMill(entry: ToolEntry): EntryReading {
  const type = cellOf(entry, "TYPE");
  const drill = isDrillType(type) ? type : null;
  const values: Partial<Record<NumberCell, number>> = {};
  const found: Issue[] = [];
  for (const column of ["T", ...MILL_TABLE, POINT_LENGTH] as const) {
    if (!applies(column, type)) continue;
    const read = numberOf(column, cellOf(entry, column), type);
    if (typeof read === "number") values[column] = read;
    else if (read !== null) found.push(read);
    else if (column === "T" || column === "R") found.push(issue("missing", "error", {}, column));
  }
  const { T, R, ...others } = values;
  const wear = values.DR ?? 0;
  const least = drill ? LEAST_DRILL : 0;
  if (R !== undefined && R < least)
    found.push(issue("toolColumn", "error", { column: "R", value: R, min: least, nearest: least }, "R"));
  else if (R !== undefined && R + wear < least)
    found.push(issue("toolColumn", "error", { column: "DR", value: wear, min: least - R, nearest: least - R }, "DR"));
  if (drill && R !== undefined && others["T-ANGLE"] && others.PL) {
    const length = (R + wear) / Math.tan(radians(others["T-ANGLE"]) / 2);
    if (Math.abs(length - others.PL) > SAME_POINT)
      found.push(
        issue("pointDiffers", "warning", { length: others.PL, byAngle: length, angle: others["T-ANGLE"] }, "PL"),
      );
  }
  const NAME = cellOf(entry, "NAME");
  const issues = firstOfEach([...found, ...nameIssues(NAME)]);
  const sound = T !== undefined && R !== undefined && issues.every((each) => each.severity !== "error");
  return {
    tool: null,
    mill: sound ? { T, NAME, ...(drill && { TYPE: drill }), R, ...others } : null,
    number: T ?? null,
    issues,
  };
}

/** Reads one row, of a turning or milling tool. Offered values have been tested. */
export function readEntry(entry: ToolEntry): EntryReading {
  const read = isMillEntry(entry) ? readMill : readTurning;
  const reading = read(entry);
  const tried = (found: Issue): Issue => {
    const [offer, cell] = [offerOf(found), found.at];
    if (offer === null || cell === undefined) return found;
    const other = read({ ...entry, cells: { ...entry.cells, [cell]: String(offer) } });
    return fixesFinding(found, reading.issues, other.issues) ? found : withOffer(found, null);
  };
  return { ...reading, issues: reading.issues.map(tried) };
}

function readTurning(entry: ToolEntry): EntryReading {
  const { values, issues } = numbersOf(entry);
  const { T, width, length, offsetZ = 0, offsetX = 0, ...columns } = values;
  const [axis, head] = [readAxis(cellOf(entry, "axis")), readHead(cellOf(entry, "head"))];
  const support = readSupport(cellOf(entry, "SUPPORT"));
  const shank =
    width === undefined || length === undefined
      ? null
      : { width, length, offsetZ, offsetX, ...(axis && { axis }), ...(head && head.length > 0 && { head }) };
  const row = {
    ...(T !== undefined && { T }),
    NAME: cellOf(entry, "NAME"),
    TYPE: cellOf(entry, "TYPE"),
    ...columns,
    ...(support && { SUPPORT: support }),
    ...(shank && { holder: shank }),
  };
  const { holder: _, ...checked } = row;
  const kept = firstOfEach([
    ...issues,
    ...(T === undefined ? [issue("missing", "error", {}, "T")] : []),
    ...nameIssues(row.NAME),
    ...checkTool(checked),
    ...holderIssues(entry),
    ...limitIssues(entry, values),
    ...flanks(row.TYPE, values),
  ]);
  const sound = kept.every((each) => each.severity !== "error");
  return { tool: sound ? (row as unknown as Tool) : null, mill: null, number: T ?? null, issues: kept };
}

/** Reports unknown flank data of an insert, at its column. */
function flanks(type: string, values: Numbers["values"]): Issue[] {
  if (type === "THREAD" && values.CUTLENGTH === undefined)
    return [issue("toothAssumed", "info", { height: USUAL_TOOTH }, "CUTLENGTH")];
  if (type !== "ROUGH" && type !== "FINISH") return [];
  const empty = (["T-ANGLE", "P-ANGLE"] as const).find((column) => values[column] === undefined);
  return empty ? [issue("flanksNotChecked", "info", {}, empty)] : [];
}
