import { fillingOf, isWholeCode } from "../iso-codes/code-cells.ts";
import { readToolCodes } from "../iso-codes/tool-code.ts";
import { INCH } from "../../kernel/units.ts";
import {
  isDrillType,
  isMillType,
  isToolType,
  MILL,
  MILL_TABLE,
  POINT_LENGTH,
  ruleOf,
  type CellName,
  type NumberCell,
} from "../tools/tool-columns.ts";
import { meaningOfTitle, plainTitle, saysDiameter, unitIn, type SheetCell } from "./column-words.ts";
import type { Sheet } from "./sheet.ts";
import { orientationOfWord, supportOfWord, typeOfWord } from "./value-words.ts";

/** How a column of a sheet is read. */
export interface ColumnChoice {
  readonly cell: SheetCell;
  /** Lengths are in inch; a unit in the cell itself goes first. */
  readonly inch: boolean;
  /** A radius is given as a diameter. */
  readonly diameter: boolean;
}

/** The words of a sheet for types and orientations, each with the value that it stands for; "" for none. */
export interface WordChoices {
  readonly TYPE: Readonly<Record<string, string>>;
  readonly TO: Readonly<Record<string, string>>;
}

/** What the columns of a sheet are, in their order; null for a column that is not used. */
export interface Assignment {
  readonly columns: readonly (ColumnChoice | null)[];
  readonly words: WordChoices;
}

/** Cells whose words are assigned. */
export type WordCell = keyof WordChoices;
export const WORD_CELLS: readonly WordCell[] = ["TYPE", "TO"];
/** Most different words of a column that are assigned. */
export const MOST_WORDS = 60;
/** Cells that a sheet may give as a diameter. */
export const isRadius = (cell: SheetCell): boolean => cell === "R" || cell === "RS";
const WORDS: readonly SheetCell[] = ["NAME", "TYPE", "CODE", "SUPPORT"];
/** Whether a column holds lengths, so that its unit matters. */
export const isLength = (cell: SheetCell): boolean =>
  !WORDS.includes(cell) && ruleOf(cell as NumberCell).kind === "length";

/** What sheets of one origin have in common: their titles. */
export const signatureOf = ({ titles }: Sheet): string => JSON.stringify(titles.map(plainTitle));

/** The values of a column that are not empty, in the order of the sheet. */
export const valuesIn = ({ lines }: Sheet, at: number): string[] =>
  lines.map((line) => line[at] ?? "").filter((cell) => cell !== "");

const isCode = (text: string) => isWholeCode(readToolCodes(text.slice(0, 80)));
const isWhole = (text: string) => /^[Tt]?\s*\d{1,5}(?:[.,]\d)?$/.test(text);
const most = (values: readonly string[], fits: (value: string) => boolean) =>
  values.length > 0 && values.filter(fits).length * 10 >= values.length * 7;

/** What the values of a column say where its title says nothing. */
function meaningOfValues(sheet: Sheet, at: number): SheetCell | null {
  const values = valuesIn(sheet, at).slice(0, MOST_WORDS);
  if (most(values, isCode)) return "CODE";
  if (most(values, (value) => typeOfWord(value) !== null && !/\d/.test(value))) return "TYPE";
  if (at === 0 && most(values, isWhole) && new Set(values).size === values.length) return "T";
  return null;
}

/** Proposed columns: by title first, the surest title for each cell, then by values. */
export function proposedAssignment(sheet: Sheet): Assignment {
  const titled = sheet.titles.map(meaningOfTitle);
  const taken = new Set<SheetCell>();
  const columns = sheet.titles.map((): ColumnChoice | null => null);
  const take = (at: number, cell: SheetCell) => {
    if (taken.has(cell)) return;
    taken.add(cell);
    const title = sheet.titles[at] ?? "";
    const inTitle = unitIn(title);
    columns[at] = { cell, inch: isLength(cell) && inTitle === "inch", diameter: isRadius(cell) && saysDiameter(title) };
  };
  const order = titled.flatMap((found, at) => (found ? [{ at, ...found }] : [])).sort((a, b) => b.sure - a.sure);
  for (const { at, cell } of order) take(at, cell);
  sheet.titles.forEach((_, at) => {
    const cell = columns[at] ? null : meaningOfValues(sheet, at);
    if (cell) take(at, cell);
  });
  return withWords(sheet, { columns, words: { TYPE: {}, TO: {} } });
}

/** The different words of a column with a meaning, in the order of the sheet. */
export function wordsIn(sheet: Sheet, { columns }: Pick<Assignment, "columns">, cell: WordCell): string[] {
  const at = columns.findIndex((column) => column?.cell === cell);
  return at < 0 ? [] : [...new Set(valuesIn(sheet, at))].slice(0, MOST_WORDS);
}

/** Adds proposals for the words that have no value yet. */
export function withWords(sheet: Sheet, { columns, words }: Assignment): Assignment {
  const propose = { TYPE: typeOfWord, TO: orientationOfWord };
  const filled = WORD_CELLS.map((cell) => [
    cell,
    Object.fromEntries(
      wordsIn(sheet, { columns }, cell).map((word) => [
        word,
        ownValue(words[cell], word) ?? String(propose[cell](word) ?? ""),
      ]),
    ),
  ]);
  return { columns, words: Object.fromEntries(filled) as unknown as WordChoices };
}

const ownValue = (words: Readonly<Record<string, string>>, word: string) =>
  Object.hasOwn(words, word) ? words[word] : undefined;

const NUMBER = /^([+-]?)(\d+(?:[.,]\d+)?|[.,]\d+)\s*(?:mm|inch|in|"|°|deg)?$/i;
const FRACTION = /^(?:(\d+)[\s-]+)?(\d+)\/(\d+)\s*(?:inch|in|")?$/i;

/** A number as it is typed: decimal comma, unit and fraction are understood; other text stays as it is. */
function numberText(text: string, { cell, inch, diameter }: ColumnChoice): string {
  const [plain, fraction] = [NUMBER.exec(text), FRACTION.exec(text)];
  const value = plain
    ? Number(`${plain[1]}${plain[2]}`.replace(",", "."))
    : fraction && Number(fraction[3]) !== 0
      ? Number(fraction[1] ?? 0) + Number(fraction[2]) / Number(fraction[3])
      : NaN;
  if (!Number.isFinite(value)) return text;
  const own = unitIn(text) ?? (fraction ? "inch" : null);
  const isInch = isLength(cell) && (own ? own === "inch" : inch);
  const scaled = value * (isInch ? INCH : 1) * (diameter && isRadius(cell) ? 0.5 : 1);
  return String(Math.round(scaled * 1e6) / 1e6);
}

type Cells = Partial<Record<CellName, string>>;

/** Cells that a milling tool or a drill has instead of those of a turning tool. */
const INSTEAD: readonly (readonly [from: CellName, to: CellName])[] = [
  ["RS", "R"],
  ["P-ANGLE", "T-ANGLE"],
  ["CUTLENGTH", "LCUTS"],
];
const MILL_CELLS: readonly CellName[] = ["T", "NAME", "TYPE", ...MILL_TABLE, POINT_LENGTH];

/** A tool of the table of milling tools has the cells of that table. */
function fitted(cells: Cells): Cells {
  const type = cells.TYPE ?? "";
  const isMill =
    isMillType(type) ||
    (!isToolType(type) && cells.R !== undefined && cells.RS === undefined && cells.TO === undefined);
  if (!isMill) {
    const { R, ...others } = cells;
    return R !== undefined && cells.RS === undefined && cells.TYPE === "BUTTON" ? { ...others, RS: R } : others;
  }
  const moved: Cells = { ...cells, TYPE: isDrillType(type) ? type : MILL };
  for (const [from, to] of INSTEAD) if (moved[to] === undefined && moved[from] !== undefined) moved[to] = moved[from];
  return Object.fromEntries(Object.entries(moved).filter(([cell]) => MILL_CELLS.some((each) => each === cell)));
}

/** One line of a sheet as the cells of a tool, with the numbers of `T` as they are written. */
function cellsOf(line: readonly string[], { columns, words }: Assignment): Cells {
  const cells: Cells = {};
  let code = "";
  columns.forEach((column, at) => {
    const text = line[at] ?? "";
    if (!column || text === "") return;
    const { cell } = column;
    if (cell === "CODE") code = text;
    else if (cell === "TYPE" || cell === "TO") cells[cell] = ownValue(words[cell], text) || text;
    else if (cell === "T") cells.T = text.replace(/^[Tt]\s*(?=\d)/, "").replace(",", ".");
    else if (cell === "NAME") cells.NAME = text;
    else if (cell === "SUPPORT") cells.SUPPORT = supportOfWord(text);
    else cells[cell] = numberText(text, column);
  });
  const filled = code === "" ? [] : fillingOf(readToolCodes(code.slice(0, 80)), { id: "", cells }).cells;
  for (const { cell, to } of filled) if ((cells[cell] ?? "") === "") cells[cell] = to;
  return fitted(cells);
}

/** The tools of a sheet, each with its line from 1, and whether its number is only proposed. */
export interface SheetTools {
  readonly rows: readonly { readonly cells: Cells; readonly line: number; readonly isNumbered: boolean }[];
  /** Numbers that more than one line has: only the last one is imported. */
  readonly twice: readonly string[];
  /** Titles of the columns that are not used. */
  readonly unused: readonly string[];
  /** Cells that the sheet gives. */
  readonly given: readonly CellName[];
}

/**
 * The tools of a sheet by an assignment. A line without a number gets the lowest one that is neither in the sheet nor
 * in `taken`; a line without anything but a number or a name is no tool.
 */
export function toolsOfSheet(sheet: Sheet, assignment: Assignment, taken: ReadonlySet<number> = new Set()): SheetTools {
  const read = sheet.lines
    .map((line, i) => ({ cells: cellsOf(line, assignment), line: i + 1 }))
    .filter(({ cells }) => Object.keys(cells).some((cell) => cell !== "T"));
  const numbers = new Set([...taken, ...read.map(({ cells }) => Number(cells.T ?? NaN))]);
  let next = 1;
  const rows = read.map(({ cells, line }) => {
    if ((cells.T ?? "") !== "") return { cells, line, isNumbered: true };
    while (numbers.has(next)) next++;
    return { cells: { ...cells, T: String(next++) }, line, isNumbered: false };
  });
  const all = rows.map(({ cells }) => cells.T ?? "");
  const twice = [...new Set(all.filter((number, i) => all.indexOf(number) !== i))];
  const unused = sheet.titles.filter((title, at) => title !== "" && !assignment.columns[at]);
  const given = [...new Set(read.flatMap(({ cells }) => Object.keys(cells) as CellName[]))];
  return { rows, twice, unused, given };
}
