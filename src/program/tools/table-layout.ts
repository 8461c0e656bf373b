import type { DrillType } from "../../kernel/plan/tool.ts";
import { INCH } from "../../kernel/units.ts";
import {
  MILL,
  MILL_COLUMNS,
  ruleOf,
  TOOL_COLUMNS,
  type CellName,
  type MillColumn,
  type NumberColumn,
  type ToolColumn,
} from "./tool-columns.ts";
import type { ToolEntry } from "./tool-entry.ts";

/*
 * Layout of a table file of the control, read from the file itself: a BEGIN line, an optional description, a line of
 * titles, and cells aligned under their titles. Reasons: docs/decisions, the tool-table layout.
 */

/** The milling table has its own title for the type. */
export type TableColumn = ToolColumn | MillColumn | "TYP";
export const MILL_FILE = ["T", "NAME", "L", "R", "DL", "DR", "TYP", "LCUTS", "T-ANGLE", "PITCH"] as const;
/** Type names of the control: a word, in older tables a number. */
export const MILL_WORDS: readonly { readonly type: DrillType; readonly words: readonly [string, ...string[]] }[] = [
  { type: "DRILL", words: ["DRILL", "1"] },
  { type: "TAP", words: ["TAP", "2"] },
  { type: "REAM", words: ["REAM", "3"] },
  { type: "CENTER", words: ["CENT", "CENTER", "4"] },
];

/** A column by its title, with its character range: from the title to the next one. */
export interface Title {
  readonly name: string;
  readonly from: number;
  readonly to: number;
}

/** Layout of a table file. */
export interface TableLayout {
  /** Its lines, and the line end of each. */
  readonly lines: readonly string[];
  readonly ends: readonly string[];
  readonly titles: readonly Title[];
  /** First line with a tool, and the line after the last. */
  readonly first: number;
  readonly last: number;
  readonly inch: boolean;
  readonly milling: boolean;
  /** The end mark is missing. */
  readonly cutShort: boolean;
}

const NEEDED: readonly ToolColumn[] = ["T", "TYPE", "TO", "RS"];

function titlesOf(line: string): Title[] {
  const starts = [...line.matchAll(/\S+/g)];
  return starts.map((match, i) => ({
    name: match[0].toUpperCase(),
    from: match.index,
    to: starts[i + 1]?.index ?? Infinity,
  }));
}

/** Skips an optional description between the first line and the titles. */
function afterDescription(lines: readonly string[], at: number): number {
  const first = lines[at] ?? "";
  const close = /#STRUCTBEGIN/i.test(first) ? "#" : /TableDescription/i.test(first) ? ")" : null;
  if (close === null) return at;
  const end = lines.findIndex((line, i) => i > at && line.trimStart().startsWith(close));
  return end < 0 ? lines.length : end + 1;
}

/** A table without TO, but with a radius R, is one of milling tools. */
const isMillTable = (titles: readonly Title[]) =>
  ["T", "R"].every((name) => titles.some((title) => title.name === name)) &&
  !titles.some((title) => title.name === "TO" || title.name === "RS");

/** Reads the layout of a table; null for other files, and the missing columns of an incomplete table. */
export function tableLayoutOf(text: string): TableLayout | { readonly lacks: readonly string[] } | null {
  const pieces = text.split(/(\r\n|\n|\r)/);
  const lines = pieces.filter((_, i) => i % 2 === 0);
  const ends = pieces.filter((_, i) => i % 2 === 1);
  const bare = lines.map((line, i) => (i === 0 ? line.replace(/^\uFEFF/, "") : line).trimEnd());
  const begin = bare.findIndex((line) => line !== "");
  const header = bare[begin] ?? "";
  if (!/^BEGIN\s+\S/i.test(header)) return null;
  const unit = /\s(MM|INCH)(?:\s+U)?$/i.exec((header.split(/\sVERSION/i)[0] ?? "").trimEnd())?.[1];
  let at = afterDescription(bare, begin + 1);
  while (at < bare.length && bare[at] === "") at++;
  const titles = titlesOf(bare[at] ?? "");
  const milling = isMillTable(titles);
  const lacks = milling ? [] : NEEDED.filter((column) => !titles.some((title) => title.name === column));
  if (lacks.length > 0) return { lacks };
  const end = bare.findIndex((line, i) => i > at && /^\[END\]/i.test(line));
  return {
    lines,
    ends,
    titles,
    first: at + 1,
    last: end < 0 ? lines.length : end,
    inch: unit?.toUpperCase() === "INCH",
    milling,
    cutShort: end < 0,
  };
}

const isOf = <C extends TableColumn>(columns: readonly C[], name: string): name is C =>
  columns.some((column) => column === name);

/** Columns of a table that are supported here. */
export const knownColumns = (milling: boolean): readonly TableColumn[] =>
  milling ? [...MILL_FILE, "TYPE"] : TOOL_COLUMNS;

/** Titles of a table without support here. */
export const unknownTitles = ({ titles, milling }: TableLayout): string[] =>
  titles.map((title) => title.name).filter((name) => !isOf(knownColumns(milling), name));

/** Text under a title. */
export const cellIn = (line: string, { from, to }: Title): string => line.slice(from, to).trim();

/** The type of a row of the milling table: its column has either title. */
const typeIn = (cells: Readonly<Record<string, string>>) => cells["TYP"] ?? cells["TYPE"] ?? "";

export const millTypeOf = (word: string) =>
  MILL_WORDS.find(({ words }) => words.includes(word.toUpperCase()))?.type ?? MILL;

/** Whether a type of the milling table is a turning tool, whose data are in the other table. */
export const isTurnWord = (word: string): boolean => /TURN|^29$/i.test(word);

/** Rows of a milling table without a mill: empty places, and turning tools. */
function isNoMill(cells: Readonly<Record<string, string>>): boolean {
  if (isTurnWord(typeIn(cells))) return true;
  return (
    (cells["NAME"] ?? "") === "" &&
    MILL_COLUMNS.every((column) => !(Number((cells[column] ?? "0").replace(",", ".")) !== 0))
  );
}

/** A number without trailing zeros. */
export const shortNumber = (value: number, decimals: number): string => {
  const fixed = value.toFixed(decimals);
  const text = fixed.includes(".") ? fixed.replace(/\.0+$|(?<!0)0+$/, "") : fixed;
  return text === "-0" ? "0" : text;
};

/** A number as tables write it, with a point or a comma. */
export const TABLE_NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)$/;

/** A cell as typed: decimal point, no plus sign, millimetres; "-" means empty. */
export function typedCell(column: TableColumn, cell: string, inch: boolean): string {
  if (column === "NAME") return cell;
  if (cell === "-") return "";
  if (column === "TYPE" || column === "TYP") return cell.toUpperCase();
  if (!TABLE_NUMBER.test(cell)) return cell;
  const value = Number(cell.replace(",", "."));
  const { kind, decimals } = ruleOf(column as NumberColumn);
  if (kind === "length" && inch) return shortNumber(value * INCH, decimals);
  return String(value === 0 ? 0 : value);
}

/** A line of a table as a row; null without a tool of this table. */
export function rowIn({ titles, milling, inch }: TableLayout, line: string): ToolEntry["cells"] | null {
  if (line.trim() === "") return null;
  const raw = Object.fromEntries(titles.map((title) => [title.name, cellIn(line, title)]));
  if (milling && isNoMill(raw)) return null;
  const cells: Partial<Record<ToolColumn | MillColumn, string>> = milling ? { TYPE: millTypeOf(typeIn(raw)) } : {};
  for (const [name, cell] of Object.entries(raw)) {
    if (cell !== "" && isOf(knownColumns(milling), name) && name !== "TYP" && !(milling && name === "TYPE"))
      cells[name] = typedCell(name, cell, inch);
  }
  return cells;
}

/** Turning tools named in a milling table, by number. */
export function turningNames(layout: TableLayout): ReadonlyMap<number, string> {
  const found = new Map<number, string>();
  if (!layout.milling) return found;
  for (const line of layout.lines.slice(layout.first, layout.last)) {
    const cell = (name: string) => {
      const title = layout.titles.find((each) => each.name === name);
      return title ? cellIn(line, title) : "";
    };
    if (isTurnWord(cell("TYP") || cell("TYPE")) && cell("T") !== "")
      found.set(Number(cell("T").replace(",", ".")), cell("NAME"));
  }
  return found;
}

/** Word of a type in a milling table. */
export const wordOfMill = (type: string | undefined): string =>
  MILL_WORDS.find((each) => each.type === type)?.words[0] ?? MILL;

/** Cell of a row under a title. */
export const cellNameOf = (title: string, milling: boolean): CellName =>
  milling && title === "TYP" ? "TYPE" : (title as CellName);
