import type { DrillType, Tool } from "../kernel/tool.ts";
import { INCH } from "../kernel/units.ts";
import { MILL, MILL_COLUMNS, ruleOf, TOOL_COLUMNS, type MillColumn, type NumberColumn, type ToolColumn } from "./tool-columns.ts";
import type { MillTool, ToolEntry } from "./tool-entry.ts";

/*
 * The tables of turning and of milling tools as the control keeps it in a file: a BEGIN line, a line of column titles, one line a tool with
 * every cell beginning under its title, and [END]. Nobody has printed this file in a manual; the layout is that of the
 * other tables of the control. Reasons: docs/decisions, the tool-table layout.
 */

/** In the table of milling tools the type stands under a title of its own. */
type Column = ToolColumn | MillColumn | "TYP";
const MILL_FILE = ["T", "NAME", "L", "R", "DL", "DR", "TYP", "LCUTS", "T-ANGLE", "PITCH"] as const;
/** How the control calls the types that count here: by a word, in older tables by its number. */
const DRILLS: readonly { readonly type: DrillType; readonly words: readonly [string, ...string[]] }[] = [
  { type: "DRILL", words: ["DRILL", "1"] },
  { type: "TAP", words: ["TAP", "2"] },
  { type: "CENTER", words: ["CENT", "CENTER", "4"] },
];

/** Characters of each column with the space behind it. */
const WIDTHS: Readonly<Record<Column, number>> = {
  T: 8,
  NAME: 33,
  ZL: 13,
  XL: 13,
  DZL: 13,
  DXL: 13,
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

const rounded = (value: number, decimals: number) => {
  const text = value.toFixed(decimals).replace(/\.?0+$/, "");
  return text === "-0" ? "0" : text;
};

function written(value: string | number | undefined, column: Column): string {
  if (value === undefined) return "";
  if (typeof value === "string" || column === "NAME" || column === "TYPE" || column === "TYP") return String(value);
  const { decimals, range: [min] } = ruleOf(column);
  const text = decimals === 0 ? String(value) : rounded(value, decimals);
  return min < 0 && !text.startsWith("-") ? `+${text}` : text;
}

function table<C extends Column>(name: string, columns: readonly C[], rows: readonly { readonly [K in C]?: string | number }[]): string {
  const line = (cells: (column: C) => string) => columns.map((column) => cells(column).padEnd(WIDTHS[column])).join("");
  return [`BEGIN ${name} MM`, line((column) => column), ...rows.map((row) => line((column) => written(row[column], column))), "[END]", ""]
    .join(LINE_END);
}

/** Writes tools as the control's table, in millimetres; numbers are rounded to what its columns keep. A holder has no column. */
export const writeTableText = (tools: readonly Tool[]): string => table("TOOLTURN.TRN", TOOL_COLUMNS, tools);

/** Writes milling tools as the control's tool table, with the columns that count here. */
export const writeMillText = (mills: readonly MillTool[]): string =>
  table("TOOL.T", MILL_FILE, mills.map((mill) => ({ ...mill, TYP: DRILLS.find((each) => each.type === mill.TYPE)?.words[0] ?? MILL })));

/** Rows of a file with the names of what has no place in this table; or why it is none. */
export type TableFile = { readonly rows: readonly ToolEntry["cells"][]; readonly leftOut: readonly string[]; readonly cutShort: boolean }
  | { readonly problem: "notATable" | "noRows" } | { readonly problem: "columnsMissing"; readonly columns: readonly string[] };

const NEEDED: readonly ToolColumn[] = ["T", "TYPE", "TO", "RS"];

interface Title {
  readonly name: string;
  readonly from: number;
  readonly to: number;
}

/** Titles with the characters that belong to them: from the title to the next one. */
function titlesOf(line: string): Title[] {
  const starts = [...line.matchAll(/\S+/g)];
  return starts.map((match, i) => ({ name: match[0].toUpperCase(), from: match.index, to: starts[i + 1]?.index ?? Infinity }));
}

/** A description of the columns may stand between the first line and the titles. */
function afterDescription(lines: readonly string[], at: number): number {
  const first = lines[at] ?? "";
  const close = /#STRUCTBEGIN/i.test(first) ? "#" : /TableDescription/i.test(first) ? ")" : null;
  if (close === null) return at;
  const end = lines.findIndex((line, i) => i > at && line.trimStart().startsWith(close));
  return end < 0 ? lines.length : end + 1;
}

const isOf = <C extends Column>(columns: readonly C[], name: string): name is C => columns.some((column) => column === name);

/** A table without TO, but with a radius R, is one of milling tools. */
const isMillTable = (titles: readonly Title[]) =>
  ["T", "R"].every((name) => titles.some((title) => title.name === name))
  && !titles.some((title) => title.name === "TO" || title.name === "RS");

/** The type of a row of the milling table: its column has either title. */
const typeIn = (cells: Readonly<Record<string, string>>) => cells["TYP"] ?? cells["TYPE"] ?? "";

const millTypeOf = (cells: Readonly<Record<string, string>>) =>
  DRILLS.find(({ words }) => words.includes(typeIn(cells).toUpperCase()))?.type ?? MILL;

/** Places of a milling table that hold no tool of its own: empty ones, and turning tools, whose data are elsewhere. */
function isNoMill(cells: Readonly<Record<string, string>>): boolean {
  if (/TURN|^29$/i.test(typeIn(cells))) return true;
  return (cells["NAME"] ?? "") === "" && MILL_COLUMNS.every((column) => !(Number((cells[column] ?? "0").replace(",", ".")) !== 0));
}

/** A cell as one would have typed it: decimal point, no plus sign, millimetres; "-" stands for an empty one. */
function typed(column: Column, cell: string, inch: boolean): string {
  if (column === "NAME") return cell;
  if (cell === "-") return "";
  if (column === "TYPE") return cell.toUpperCase();
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)$/.test(cell)) return cell;
  const value = Number(cell.replace(",", "."));
  const { kind, decimals } = ruleOf(column as NumberColumn);
  if (kind === "length" && inch) return rounded(value * INCH, decimals);
  return String(value === 0 ? 0 : value);
}

/** Reads a table as the control keeps it, with other columns and in another order too; decimal comma and INCH included. */
export function readTableText(text: string): TableFile {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/).map((line) => line.trimEnd());
  const begin = lines.findIndex((line) => line !== "");
  const header = /^BEGIN\s+\S.*?(?:\s(MM|INCH))?(?:\s+VERSION.*|\s+U)?$/i.exec(lines[begin] ?? "");
  if (!header) return { problem: "notATable" };
  let at = afterDescription(lines, begin + 1);
  while (at < lines.length && lines[at] === "") at++;
  const titles = titlesOf(lines[at] ?? "");
  const milling = isMillTable(titles);
  const known: readonly Column[] = milling ? [...MILL_FILE, "TYPE"] : TOOL_COLUMNS;
  const columns = milling ? [] : NEEDED.filter((column) => !titles.some((title) => title.name === column));
  if (columns.length > 0) return { problem: "columnsMissing", columns };
  const inch = header[1]?.toUpperCase() === "INCH";
  const rows: ToolEntry["cells"][] = [];
  const end = lines.findIndex((line, i) => i > at && /^\[END\]/i.test(line));
  for (const line of lines.slice(at + 1, end < 0 ? undefined : end)) {
    if (line === "") continue;
    const raw = Object.fromEntries(titles.map(({ name, from, to }) => [name, line.slice(from, to).trim()]));
    if (milling && isNoMill(raw)) continue;
    const cells: Partial<Record<ToolColumn | MillColumn, string>> = milling ? { TYPE: millTypeOf(raw) } : {};
    for (const [name, cell] of Object.entries(raw)) {
      if (cell !== "" && isOf(known, name) && name !== "TYP" && !(milling && name === "TYPE")) cells[name] = typed(name, cell, inch);
    }
    rows.push(cells);
  }
  if (rows.length === 0) return { problem: "noRows" };
  return { rows, leftOut: titles.map((title) => title.name).filter((name) => !isOf(known, name)), cutShort: end < 0 };
}
