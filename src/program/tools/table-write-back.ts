import { INCH } from "../../kernel/units.ts";
import {
  cellIn,
  cellNameOf,
  MILL_WORDS,
  isTurnWord,
  knownColumns,
  tableLayoutOf,
  rowIn,
  TABLE_NUMBER,
  typedCell,
  wordOfMill,
  type TableColumn,
  type TableLayout,
  type Title,
} from "./table-layout.ts";
import { ruleOf, type NumberColumn } from "./tool-columns.ts";
import { cellOf, hasFile, isMillEntry, readEntry, type TableOrigin, type ToolEntry } from "./tool-entry.ts";
import { sameList, shippedList } from "./tool-list.ts";
import { inOneLine, written } from "./tool-table-text.ts";

/** The imported table file with the changes of its tools. */
export interface TableWriteBack {
  readonly text: string;
  readonly changed: number;
  readonly added: number;
  readonly removed: number;
  /** Unchanged shipped tools, which belong to no shop and are not added. */
  readonly shipped: number;
  /** Cells too long for their column: they keep their old text, in a new row they stay empty. */
  readonly tooLong: readonly { readonly tool: string; readonly column: string }[];
}

/** Number format of a column in a file. */
interface ColumnFormat {
  /** Numbers have a comma. */
  readonly comma: boolean;
  /** Positive numbers of the column have a sign. */
  readonly signed: boolean;
  /** Cells end under the end of their column. */
  readonly right: boolean;
}

function columnFormatOf(layout: TableLayout, title: Title): ColumnFormat {
  const body = layout.lines.slice(layout.first, layout.last);
  const own = body.map((line) => line.slice(title.from, title.to)).filter((cell) => cell.trim() !== "");
  const isComma = (line: string) => layout.titles.some((each) => /^[+-]?\d*,\d+$/.test(cellIn(line, each)));
  const numbers = own.filter((cell) => TABLE_NUMBER.test(cell.trim()));
  const rule =
    title.name === "NAME" || title.name === "TYPE" || title.name === "TYP" ? null : ruleOf(title.name as NumberColumn);
  return {
    comma: body.some(isComma),
    signed: numbers.length > 0 ? numbers.some((cell) => cell.trim().startsWith("+")) : (rule?.range[0] ?? 0) < 0,
    right: own.length > 0 && own.every((cell) => cell.startsWith(" ") && title.to !== Infinity),
  };
}

/** Additional decimals in an inch table. */
const MORE_IN_INCH = 1;

/** A value in the format of the file; fewer decimals where the column is narrow, null where it does not fit. */
function fitted(layout: TableLayout, title: Title, manner: ColumnFormat, text: string, before: string): string | null {
  const room = title.to === Infinity ? Infinity : title.to - title.from - 1;
  const fits = (cell: string) => (cell.length <= room ? cell : null);
  if (layout.milling && (title.name === "TYP" || title.name === "TYPE")) {
    const numbered = /^\d+$/.test(before);
    const words = MILL_WORDS.find((each) => each.type === text)?.words;
    return fits(numbered ? (words?.find((word) => /^\d$/.test(word)) ?? "0") : wordOfMill(text));
  }
  if (title.name === "NAME" || title.name === "TYPE" || text.trim() === "") return fits(inOneLine(text));
  const number = Number(text.trim().replace(",", "."));
  if (!Number.isFinite(number)) return fits(text.trim());
  const { kind, decimals } = ruleOf(title.name as NumberColumn);
  const inch = layout.inch && kind === "length";
  const value = inch ? number / INCH : number;
  for (let places = decimals + (inch ? MORE_IN_INCH : 0); places >= 0; places--) {
    const plain = written(Number(value.toFixed(places)), title.name as TableColumn).replace(/^\+/, "");
    const cell = `${manner.signed && !plain.startsWith("-") ? "+" : ""}${manner.comma ? plain.replace(".", ",") : plain}`;
    if (fits(cell) !== null) return cell;
  }
  return null;
}

/** Replaces one cell of a line; all other characters and the length of the line stay. */
function withCell(line: string, { from, to }: Title, cell: string, right: boolean): string {
  const [before, old, behind] = [line.padEnd(from).slice(0, from), line.slice(from, to), line.slice(to)];
  if (right) return `${before}${cell.padStart(to - from - 1)} ${behind}`;
  if (behind !== "") return before + cell.padEnd(to - from) + behind;
  const put = before + cell.padEnd(old.length);
  return line.endsWith(" ") ? put : put.trimEnd();
}

interface Writer {
  readonly layout: TableLayout;
  readonly manners: ReadonlyMap<Title, ColumnFormat>;
  readonly tooLong: { readonly tool: string; readonly column: string }[];
}

/** Writes a row into its line: cells with an unchanged meaning stay as written. */
function lineOf({ layout, manners, tooLong }: Writer, line: string, entry: ToolEntry): string {
  const fresh = line.trim() === "";
  const had = rowIn(layout, line) ?? {};
  let now = line;
  for (const title of layout.titles) {
    const manner = manners.get(title);
    if (!manner) continue;
    const cell = cellNameOf(title.name, layout.milling);
    const text = cellOf(entry, cell).trim();
    const before = cellIn(line, title);
    if (!fresh && ((had[cell] ?? "") === text || typedCell(title.name as TableColumn, before, layout.inch) === text))
      continue;
    const put = fitted(layout, title, manner, text, before);
    if (put === null) tooLong.push({ tool: cellOf(entry, "T"), column: title.name });
    else if (put !== before) now = withCell(now, title, put, manner.right);
  }
  return now;
}

const numberOf = (entry: ToolEntry) => readEntry(entry).number ?? Infinity;
const isUsable = (entry: ToolEntry) => {
  const { tool, mill } = readEntry(entry);
  return tool !== null || mill !== null;
};

const isShipped = (entry: ToolEntry) =>
  shippedList.some((each) => each.cells["T"] === cellOf(entry, "T") && sameList([each], [entry]));

/** Number in a line of a table, whether it holds a tool or not. */
function numberIn(layout: TableLayout, line: string): number | null {
  const title = layout.titles.find((each) => each.name === "T");
  const cell = title ? cellIn(line, title) : "";
  return TABLE_NUMBER.test(cell) ? Number(cell.replace(",", ".")) : null;
}

/**
 * Writes the tools back into their table file: changed cells in place, deleted tools removed, new ones inserted by
 * number; all other lines, columns and characters stay. Invalid rows keep their line. Null when the text is no table.
 */
export function writeBackTable(origin: TableOrigin, list: readonly ToolEntry[]): TableWriteBack | null {
  const layout = tableLayoutOf(origin.text);
  if (!layout || "lacks" in layout) return null;
  const mine = list.filter((entry) => isMillEntry(entry) === layout.milling);
  const here = new Map(
    mine.filter(({ line }) => line?.origin.text === origin.text).map((entry) => [entry.line?.at, entry]),
  );
  const manners = new Map(
    layout.titles
      .filter(({ name }) => knownColumns(layout.milling).some((column) => column === name))
      .map((title) => [title, columnFormatOf(layout, title)]),
  );
  const writer: Writer = { layout, manners, tooLong: [] };
  const names = new Map(
    list.filter((entry) => !isMillEntry(entry)).map((entry) => [numberOf(entry), cellOf(entry, "NAME")]),
  );
  const foreign = mine.filter((entry) => entry.line?.origin.text !== origin.text && isUsable(entry));
  const fresh = foreign.filter((entry) => !isShipped(entry)).sort((a, b) => numberOf(a) - numberOf(b));
  let [changed, added, removed] = [0, 0, 0];
  const titleLine = layout.lines[layout.first - 1] ?? "";
  const blank = titleLine.endsWith(" ") ? " ".repeat(titleLine.length) : "";
  const eol = layout.ends[0] ?? "\r\n";
  const out: string[] = layout.lines.slice(0, layout.first).map((line, i) => line + (layout.ends[i] ?? eol));
  const add = (entry: ToolEntry) => {
    out.push(lineOf(writer, blank, entry) + eol);
    added++;
  };
  for (let i = layout.first; i < layout.last; i++) {
    const line = layout.lines[i] ?? "";
    const end = layout.ends[i] ?? "";
    const number = numberIn(layout, line);
    while (number !== null && fresh[0] && numberOf(fresh[0]) < number) add(fresh.shift() as ToolEntry);
    const taken = number !== null && fresh[0] && numberOf(fresh[0]) === number ? fresh.shift() : undefined;
    const entry = here.get(i) ?? taken;
    if (!entry && rowIn(layout, line)) {
      removed++;
      continue;
    }
    const next = entry ? (isUsable(entry) ? lineOf(writer, line, entry) : line) : turnedName(writer, line, names);
    if (next !== line) changed++;
    out.push(next + end);
  }
  const open = out.at(-1) === "" ? out.pop() : undefined;
  if (fresh.length > 0 && out.length > 0 && !/[\r\n]$/.test(out.at(-1) ?? "")) out.push(`${out.pop() ?? ""}${eol}`);
  fresh.forEach(add);
  if (open !== undefined) out.push(open);
  for (let i = layout.last; i < layout.lines.length; i++) out.push((layout.lines[i] ?? "") + (layout.ends[i] ?? ""));
  return {
    text: out.join(""),
    changed,
    added,
    removed,
    shipped: foreign.filter(isShipped).length,
    tooLong: writer.tooLong,
  };
}

/** Updates the name of a turning tool in its row of the milling table. */
function turnedName(writer: Writer, line: string, names: ReadonlyMap<number, string>): string {
  const { layout, manners, tooLong } = writer;
  const title = layout.titles.find((each) => each.name === "NAME");
  const type = layout.titles.find((each) => each.name === "TYP" || each.name === "TYPE");
  const number = numberIn(layout, line);
  const name = number === null ? undefined : names.get(number);
  const manner = title && manners.get(title);
  if (!title || !type || !manner || !name || !isTurnWord(cellIn(line, type)) || cellIn(line, title) === name)
    return line;
  const put = fitted(layout, title, manner, name, "");
  if (put !== null) return withCell(line, title, put, manner.right);
  tooLong.push({ tool: String(number), column: "NAME" });
  return line;
}

/** Source files of the rows of a list, of one kind; the most frequent one first. */
export function originsOf(list: readonly ToolEntry[], milling: boolean): TableOrigin[] {
  const found = new Map<string, { readonly origin: TableOrigin; readonly rows: number }>();
  for (const entry of list) {
    if (!entry.line || !hasFile(entry) || isMillEntry(entry) !== milling) continue;
    const { origin } = entry.line;
    found.set(origin.text, { origin, rows: (found.get(origin.text)?.rows ?? 0) + 1 });
  }
  return [...found.values()].sort((a, b) => b.rows - a.rows).map(({ origin }) => origin);
}
