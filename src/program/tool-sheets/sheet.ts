import { cellText } from "../files/bounded.ts";
import { csvCells } from "../files/csv.ts";

/** A sheet of any origin: the titles of its columns, and its lines as text. */
export interface Sheet {
  readonly titles: readonly string[];
  readonly lines: readonly (readonly string[])[];
}

/** Most lines and columns of a sheet that is read; a list of tools is far smaller. */
export const MOST_LINES = 5000;
export const MOST_COLUMNS = 200;
/** Longest text that is read as a sheet, characters. */
const LARGEST_TEXT = 5_000_000;
/** Lines among which the titles are looked for: a sheet may begin with a heading. */
const HEAD_LINES = 20;

const isNumber = (cell: string) => /^[+-]?[\d.,]+$/.test(cell.trim());

/** A sheet from its cells; null where there are no two columns, or no line below the titles. */
export function sheetOf(cells: readonly (readonly string[])[]): Sheet | null {
  const rows = cells
    .slice(0, MOST_LINES + HEAD_LINES)
    .map((row) => row.slice(0, MOST_COLUMNS).map((cell) => cellText(cell.trim())))
    .filter((row) => row.some((cell) => cell !== ""));
  const words = rows.slice(0, HEAD_LINES).map((row) => row.filter((cell) => cell !== "" && !isNumber(cell)).length);
  const at = words.indexOf(Math.max(...words));
  const titles = rows[at] ?? [];
  const lines = rows.slice(at + 1, at + 1 + MOST_LINES);
  return titles.filter((title) => title !== "").length > 1 && lines.length > 0 ? { titles, lines } : null;
}

/** The separator that divides most of the first lines into equally many cells. */
function separatorIn(text: string): string {
  const lines = text.split(/\r\n|\n|\r/, HEAD_LINES).filter((line) => line.trim() !== "");
  const bare = lines.map((line) => line.replaceAll(/"[^"]*"/g, ""));
  const rate = (separator: string) => {
    const counts = bare.map((line) => line.split(separator).length);
    const most = Math.max(...counts);
    return most < 2 ? 0 : counts.filter((count) => count === most).length * 100 + most;
  };
  // A comma may be a decimal sign: it separates only where nothing else does.
  const [first = ",", second] = [";", "\t", "|", ","].sort((a, b) => rate(b) - rate(a));
  return first === "," && second && rate(second) > 0 ? second : first;
}

/** Reads a sheet from text: CSV, TSV, or cells copied from a spreadsheet. Never throws. */
export function readSheet(text: string): Sheet | null {
  const whole = text.replace(/^\uFEFF/, "");
  if (whole.includes("\u0000") || /^\s*[{[<]/.test(whole)) return null;
  const named = /^sep=(.)\r?\n/i.exec(whole);
  const body = named ? whole.slice(named[0].length) : whole;
  return sheetOf(csvCells(body.slice(0, LARGEST_TEXT), named?.[1] ?? separatorIn(body)));
}
