import type { Tool } from "../../kernel/plan/tool.ts";
import {
  cellNameOf,
  knownColumns,
  tableLayoutOf,
  MILL_FILE,
  rowIn,
  shortNumber,
  turningNames,
  unknownTitles,
  wordOfMill,
  type TableColumn,
} from "./table-layout.ts";
import { ruleOf, TOOL_COLUMNS, type CellName } from "./tool-columns.ts";
import type { MillTool, ToolEntry } from "./tool-entry.ts";

/*
 * Turning and milling tables as files of the control, written in one layout and read in any (`table-layout.ts`). No
 * manual prints this file; the layout is that of other tables of the control. Reasons: docs/decisions, the tool-table
 * layout.
 */

/** Width of each column in characters, with the trailing space. */
const WIDTHS: Readonly<Record<TableColumn, number>> = {
  T: 8,
  NAME: 33,
  ZL: 13,
  XL: 13,
  DZL: 13,
  DXL: 13,
  DYL: 13,
  RS: 12,
  DRS: 11,
  TO: 4,
  ORI: 10,
  "T-ANGLE": 9,
  "P-ANGLE": 9,
  CUTLENGTH: 12,
  CUTWIDTH: 12,
  DCW: 13,
  TYPE: 8,
  L: 13,
  R: 12,
  DL: 13,
  DR: 11,
  TYP: 8,
  LCUTS: 12,
  PITCH: 9,
};
const LINE_END = "\r\n";

/** A text as one cell of a line: a name from another file may hold line ends, which would begin another row. */
export const inOneLine = (text: string): string => text.replace(/\p{Cc}+/gu, " ").trim();

/** A value as the control writes it in a column. */
export function written(value: string | number | undefined, column: TableColumn): string {
  if (value === undefined) return "";
  if (typeof value === "string" || column === "NAME" || column === "TYPE" || column === "TYP")
    return inOneLine(String(value));
  const {
    decimals,
    range: [min],
  } = ruleOf(column);
  const text = decimals === 0 ? String(value) : shortNumber(value, decimals);
  return min < 0 && !text.startsWith("-") ? `+${text}` : text;
}

function table<C extends TableColumn>(
  name: string,
  columns: readonly C[],
  rows: readonly { readonly [K in C]?: string | number }[],
): string {
  const line = (cells: (column: C) => string) => columns.map((column) => cells(column).padEnd(WIDTHS[column])).join("");
  return [
    `BEGIN ${name} MM`,
    line((column) => column),
    ...rows.map((row) => line((column) => written(row[column], column))),
    "[END]",
    "",
  ].join(LINE_END);
}

/**
 * Writes tools as a table of the control, in millimetres; numbers are rounded to the resolution of its columns. A
 * holder has no column.
 */
export const writeTableText = (tools: readonly Tool[]): string => table("TOOLTURN.TRN", TOOL_COLUMNS, tools);

/** Writes milling tools as a tool table of the control, with the columns used here. */
export const writeMillText = (mills: readonly MillTool[]): string =>
  table(
    "TOOL.T",
    MILL_FILE,
    mills.map((mill) => ({ ...mill, TYP: wordOfMill(mill.TYPE) })),
  );

/** Rows of a file with the names of unsupported columns; or why it is invalid. */
export type TableFile =
  | {
      readonly rows: readonly ToolEntry["cells"][];
      readonly leftOut: readonly string[];
      readonly cutShort: boolean;
      /** Cells with a column in the file; absent for all. */
      readonly columns?: readonly CellName[];
      /**
       * For a table of the control: which one, the line of each row, and the turning tools named in a milling table.
       */
      readonly table?: {
        readonly milling: boolean;
        readonly lines: readonly number[];
        readonly turning: ReadonlyMap<number, string>;
      };
    }
  | { readonly problem: "notATable" | "noRows" }
  | { readonly problem: "columnsMissing"; readonly columns: readonly string[] };

/** Reads a table of the control, also with other columns or order; decimal comma and INCH included. */
export function readTableText(text: string): TableFile {
  const layout = tableLayoutOf(text);
  if (!layout) return { problem: "notATable" };
  if ("lacks" in layout) return { problem: "columnsMissing", columns: layout.lacks };
  const found = layout.lines.map((line, i) => (i < layout.first || i >= layout.last ? null : rowIn(layout, line)));
  const lines = found.flatMap((row, i) => (row ? [i] : []));
  const turning = turningNames(layout);
  if (lines.length === 0 && turning.size === 0) return { problem: "noRows" };
  return {
    rows: found.filter((row) => row !== null),
    leftOut: unknownTitles(layout),
    cutShort: layout.cutShort,
    columns: layout.titles
      .filter(({ name }) => knownColumns(layout.milling).some((column) => column === name))
      .map(({ name }) => cellNameOf(name, layout.milling)),
    table: { milling: layout.milling, lines, turning },
  };
}
