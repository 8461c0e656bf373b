import type { Tool } from "../../kernel/plan/tool.ts";
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
const BOM = "\uFEFF";

/** Splits a sheet into cells. A quoted cell may hold anything, with doubled quotes. Never throws. */
export function cellsOfSheet(text: string, separator: string): string[][] {
  const lines: string[][] = [[]];
  let [cell, isBlank, quoted] = ["", true, false];
  const begin = () => {
    cell = "";
    isBlank = true;
  };
  const add = (c: string) => {
    cell += c;
    isBlank &&= c.trim() === "";
  };
  const push = () => {
    (lines.at(-1) as string[]).push(cell.trim());
    begin();
  };
  for (let i = 0; i < text.length; i++) {
    const c = text[i] as string;
    if (quoted && c === '"' && text[i + 1] === '"') {
      add(c);
      i++;
    } else if (c === '"' && (quoted || isBlank)) {
      quoted = !quoted;
      if (quoted) begin();
    } else if (!quoted && c === separator) push();
    else if (!quoted && (c === "\n" || c === "\r")) {
      if (c === "\r" && text[i + 1] === "\n") i++;
      push();
      lines.push([]);
    } else add(c);
  }
  push();
  return lines.filter((line) => line.some((each) => each !== ""));
}

/** Separator of the cells: the most frequent one in the first line outside of quotes. */
export function separatorOf(line: string): string {
  const bare = line.replaceAll(/"[^"]*"/g, "");
  const [first = ","] = [";", "\t", ","].sort((a, b) => bare.split(b).length - bare.split(a).length);
  return first;
}

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
  const separator = named?.[1] ?? separatorOf(body.trimStart().split(/[\r\n]/, 1)[0] ?? "");
  const [first = [], ...lines] = cellsOfSheet(body, separator);
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

/** Format of a sheet: with decimal comma for spreadsheets that expect it, or with point and comma. */
export type SheetFormat = "comma" | "point";

function quoted(text: string, separator: string): string {
  return text.includes(separator) || /["\r\n]|^\s|\s$/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Writes tools as a sheet, milling tools last. Nothing is rounded. */
export function writeTableCsv(tools: readonly Tool[], mills: readonly MillTool[], manner: SheetFormat): string {
  const separator = manner === "comma" ? ";" : ",";
  const number = (value: string | number | undefined) =>
    typeof value === "number" && manner === "comma" ? String(value).replace(".", ",") : String(value ?? "");
  const line = (cell: (name: CellName) => string | number | undefined) =>
    COLUMNS.map((name) => quoted(number(cell(name)), separator)).join(separator);
  const ofTool = (tool: Tool) =>
    line((name) => {
      const { holder } = tool;
      if (name === "head") return holder?.head ? writeHead(holder.head) : undefined;
      if (name in (holder ?? {})) return holder?.[name as "width"];
      return tool[name as keyof Tool] as string | number | undefined;
    });
  const ofMill = (mill: MillTool) =>
    line((name) => (name === "TYPE" ? (mill.TYPE ?? MILL) : mill[name as keyof MillTool]));
  return `${BOM}${[line(titleOf), ...tools.map(ofTool), ...mills.map(ofMill), ""].join("\r\n")}`;
}
