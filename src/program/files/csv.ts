/*
 * Cells of CSV files: the one place that writes and reads them. What leaves is inert: text that a spreadsheet would run
 * as a formula gets an apostrophe in front, which marks it as text, and which is taken away on reading.
 */

/** Marks a file as UTF-8 for spreadsheets. */
const BOM = "\uFEFF";

/** Contents of a cell: text, a number, or nothing. */
export type CsvCell = string | number | null | undefined;

/** Format of CSV cells: the separator between them, and the decimal sign of numbers. */
export interface CsvFormat {
  readonly separator: string;
  readonly decimal: string;
}

/** The format that spreadsheets of a language expect: with a decimal comma, cells are separated by semicolons. */
export const csvFormat = (decimal: string): CsvFormat => ({ separator: decimal === "," ? ";" : ",", decimal });

/** Text that begins like a formula, also behind apostrophes, so that one of them can be added and taken away. */
const FORMULA = /^'*(?:\s*[=+\-@|%＝＋－＠]|[\t\r\n])/;

/** One cell as written. Numbers stay numbers, a negative one too. */
export function csvCell(value: CsvCell, { separator, decimal }: CsvFormat): string {
  if (value === null || value === undefined) return "";
  if (typeof value === "number") return String(value).replace(".", decimal);
  const inert = FORMULA.test(value) ? `'${value}` : value;
  return inert.includes(separator) || /["\r\n\t]|^\s|\s$/.test(inert) ? `"${inert.replaceAll('"', '""')}"` : inert;
}

/** Writes lines of cells as a CSV file. */
export function writeCsv(lines: readonly (readonly CsvCell[])[], format: CsvFormat): string {
  const written = lines.map((cells) => cells.map((cell) => csvCell(cell, format)).join(format.separator));
  return BOM + written.map((line) => `${line}\r\n`).join("");
}

const withoutMark = (cell: string): string =>
  cell.startsWith("'") && FORMULA.test(cell.slice(1)) ? cell.slice(1) : cell;

/** Splits a CSV file into cells. A quoted cell may hold anything, with doubled quotes. Never throws. */
export function csvCells(text: string, separator: string): string[][] {
  const lines: string[][] = [[]];
  let cell = "";
  let begun = false;
  let quoted = false;
  let closed = false;
  const push = () => {
    (lines.at(-1) as string[]).push(withoutMark(closed ? cell : cell.trim()));
    cell = "";
    begun = closed = false;
  };
  for (let i = 0; i < text.length; i++) {
    const c = text[i] as string;
    if (quoted && c === '"' && text[i + 1] === '"') {
      cell += c;
      begun = true;
      i++;
    } else if (c === '"' && (quoted || !begun)) {
      quoted = !quoted;
      closed = !quoted;
      if (quoted) cell = "";
    } else if (!quoted && c === separator) push();
    else if (!quoted && (c === "\n" || c === "\r")) {
      if (c === "\r" && text[i + 1] === "\n") i++;
      push();
      lines.push([]);
    } else if (!closed || c.trim() !== "") {
      cell += c;
      begun ||= c.trim() !== "";
    }
  }
  push();
  return lines.filter((line) => line.some((each) => each !== ""));
}

/** Separator of the cells: the most frequent one in the first line outside of quotes. */
export function csvSeparator(line: string): string {
  const bare = line.replaceAll(/"[^"]*"/g, "");
  const [first = ","] = [";", "\t", ","].sort((a, b) => bare.split(b).length - bare.split(a).length);
  return first;
}
