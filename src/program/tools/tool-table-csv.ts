import type { Tool } from "../../kernel/plan/tool.ts";
import { csvCells, csvFormat, csvSeparator, writeCsv, type CsvCell } from "../files/csv.ts";
import { writeHead } from "./holder-cells.ts";
import { TABLE_NUMBER } from "./table-layout.ts";
import {
  HOLDER_CELLS,
  LIMIT_CELLS,
  POINT_LENGTH,
  isDrillType,
  isMillType,
  isToolType,
  MILL,
  MILL_COLUMNS,
  MILL_TABLE,
  TOOL_COLUMNS,
  type CellName,
} from "./tool-columns.ts";
import type { MillTool, ToolEntry } from "./tool-entry.ts";
import type { TableFile } from "./tool-table-text.ts";

/*
 * Tools as a sheet: one title line, one line per tool, cells separated by comma, semicolon or tab. Columns have the
 * names of the control, in any order; holder cells are prefixed with `HOLDER.`.
 */

const HOLDER = "HOLDER.";
const COLUMNS: readonly CellName[] = [...TOOL_COLUMNS, ...MILL_COLUMNS, ...LIMIT_CELLS, POINT_LENGTH, ...HOLDER_CELLS];
const titleOf = (cell: CellName): string =>
  HOLDER_CELLS.some((each) => each === cell) ? `${HOLDER}${cell.toUpperCase()}` : cell;
const cellOfTitle = new Map(COLUMNS.map((cell) => [titleOf(cell), cell]));

/** A number with a decimal point, from either decimal sign. */
const typed = (cell: string) => (TABLE_NUMBER.test(cell) ? cell.replace(",", ".").replace(/^\+/, "") : cell);

function rowOf(titles: readonly (CellName | null)[], line: readonly string[]): ToolEntry["cells"] {
  const cells: Partial<Record<CellName, string>> = {};
  titles.forEach((cell, i) => {
    const text = line[i] ?? "";
    if (cell && text !== "") cells[cell] = cell === "NAME" || cell === "head" ? text : typed(text);
  });
  const type = (cells.TYPE ?? "").toUpperCase();
  const mill =
    isMillType(type) ||
    (!isToolType(type) && cells.R !== undefined && cells.RS === undefined && cells.TO === undefined);
  if (mill) cells.TYPE = isDrillType(type) ? type : MILL;
  else if (type !== "") cells.TYPE = type;
  const columns: readonly CellName[] = mill
    ? ["T", "NAME", "TYPE", ...MILL_TABLE, POINT_LENGTH]
    : [...TOOL_COLUMNS, ...LIMIT_CELLS, ...HOLDER_CELLS];
  return Object.fromEntries(Object.entries(cells).filter(([cell]) => columns.some((each) => each === cell)));
}

/** Titles of a possible tool sheet: its first line names T and one more column. */
function titlesIn(line: readonly string[]): readonly (CellName | null)[] | null {
  const titles = line.map((cell) => cellOfTitle.get(cell.toUpperCase().replaceAll(/\s+/g, "")) ?? null);
  return titles.includes("T") && titles.filter((title) => title !== null).length > 1 ? titles : null;
}

/** Reads tools from a sheet as spreadsheets write it. */
export function readTableCsv(text: string): TableFile {
  const whole = text.replace(/^\uFEFF/, "");
  const named = /^sep=(.)\r?\n/i.exec(whole);
  const body = named ? whole.slice(named[0].length) : whole;
  const separator = named?.[1] ?? csvSeparator(body.trimStart().split(/[\r\n]/, 1)[0] ?? "");
  const [first = [], ...lines] = csvCells(body, separator);
  const titles = titlesIn(first);
  if (!titles) return { problem: "notATable" };
  if (lines.length === 0) return { problem: "noRows" };
  const leftOut = first.filter((name, i) => titles[i] === null && name !== "");
  return {
    rows: lines.map((line) => rowOf(titles, line)),
    leftOut,
    cutShort: false,
    columns: titles.filter((title) => title !== null),
  };
}

/** Writes tools as a sheet with the decimal sign of a language, milling tools last. Nothing is rounded. */
export function writeTableCsv(tools: readonly Tool[], mills: readonly MillTool[], decimal: string): string {
  const line = (cell: (name: CellName) => CsvCell) => COLUMNS.map(cell);
  const ofTool = (tool: Tool) =>
    line((name) => {
      const { holder } = tool;
      if (name === "head") return holder?.head && writeHead(holder.head);
      if (name in (holder ?? {})) return holder?.[name as "width"];
      return tool[name as keyof Tool] as CsvCell;
    });
  const ofMill = (mill: MillTool) =>
    line((name) => (name === "TYPE" ? (mill.TYPE ?? MILL) : mill[name as keyof MillTool]));
  return writeCsv([line(titleOf), ...tools.map(ofTool), ...mills.map(ofMill)], csvFormat(decimal));
}
