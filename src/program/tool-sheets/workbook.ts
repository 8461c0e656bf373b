import { attributeOf, elementsIn, elementsOf, readXml, textInside, type XmlElement } from "../files/xml.ts";
import { MOST_COLUMNS, MOST_LINES, sheetOf, type Sheet } from "./sheet.ts";

/*
 * The cells of a workbook as spreadsheets save it: Office Open XML (ECMA-376 part 1, 18.3 and 18.4) or OpenDocument
 * (ISO/IEC 26300, 9.1). Formulas count with the value that was saved.
 */

/** Text of a part of the file by its path; null where it is not there. */
export type PartOf = (path: string) => string | null;

/** Most sheets that are looked at. */
const MOST_SHEETS = 20;

const rootOf = (xml: string | null): XmlElement | null => (xml === null ? null : readXml(xml, "kept").root);

/** The texts of an Office element, without the readings of Asian scripts (rPh). */
const officeText = (e: XmlElement): string =>
  elementsIn(e)
    .map((inner) => (inner.local === "t" ? textInside(inner) : inner.local === "rPh" ? "" : officeText(inner)))
    .join("");

/** Column of a place such as AB12, from 0; −1 for another text. */
function columnOf(place: string): number {
  const letters = /^([A-Z]{1,3})\d*$/.exec(place)?.[1] ?? "";
  return [...letters].reduce((sum, letter) => sum * 26 + letter.charCodeAt(0) - 64, 0) - 1;
}

/** A stored number as it is shown: binary fractions such as 0.80000000000000004 are rounded. */
const shown = (value: string): string => {
  const number = Number(value);
  return value.trim() !== "" && Number.isFinite(number) ? String(Number(number.toPrecision(12))) : value;
};

/** Rows of an Office sheet: a cell has its place, its type and its value; texts are shared by all sheets. */
function officeRows(sheet: XmlElement, shared: readonly string[]): string[][] {
  return elementsOf(sheet, "row")
    .slice(0, MOST_LINES)
    .map((row) => {
      const cells: string[] = [];
      for (const cell of elementsIn(row, "c")) {
        const place = columnOf(attributeOf(cell, "r") ?? "");
        const at = place < 0 ? cells.length : place;
        if (at >= MOST_COLUMNS) continue;
        while (cells.length < at) cells.push("");
        const type = attributeOf(cell, "t") ?? "n";
        const value = elementsIn(cell, "v").map(textInside).join("");
        if (type === "inlineStr") cells[at] = officeText(cell);
        else if (type === "s") cells[at] = shared[Number(value)] ?? "";
        else cells[at] = type === "n" ? shown(value) : value;
      }
      return cells;
    });
}

/** Rows of the sheets of an Office workbook, in its order. */
function* officeSheets(part: PartOf): Generator<string[][]> {
  const links = rootOf(part("xl/_rels/workbook.xml.rels")),
    book = rootOf(part("xl/workbook.xml")),
    texts = rootOf(part("xl/sharedStrings.xml"));
  const targets = new Map(
    (links ? elementsOf(links, "Relationship") : []).map((e) => [attributeOf(e, "Id"), attributeOf(e, "Target")]),
  );
  const found = (book ? elementsOf(book, "sheet") : []).flatMap((e) => targets.get(attributeOf(e, "id")) ?? []);
  const shared = (texts ? elementsIn(texts, "si") : []).map(officeText);
  for (const target of found.length > 0 ? found : ["worksheets/sheet1.xml"]) {
    const sheet = rootOf(part(target.startsWith("/") ? target.slice(1) : `xl/${target}`));
    if (sheet) yield officeRows(sheet, shared);
  }
}

/** How often a cell or row of OpenDocument stands side by side. */
const timesOf = (e: XmlElement, attribute: string, most: number) =>
  Math.min(Math.max(Math.floor(Number(attributeOf(e, attribute) ?? 1)) || 1, 1), most);

/** Running text of OpenDocument: spaces, tabs and line breaks are elements, notes are left out. */
const openText = (e: XmlElement): string =>
  e.content
    .map((c): string => {
      if (typeof c === "string") return c.replace(/\s+/g, " ");
      if (c.local === "s") return " ".repeat(timesOf(c, "c", 100));
      if (c.local === "tab" || c.local === "line-break") return " ";
      return c.local === "annotation" || c.local === "note" ? "" : openText(c);
    })
    .join("");

/** Value of a cell: a saved number, or its paragraphs. */
function openValue(cell: XmlElement): string {
  const number = /^(?:float|percentage|currency)$/.test(attributeOf(cell, "value-type") ?? "");
  const value = number ? attributeOf(cell, "value") : undefined;
  return value === undefined ? elementsIn(cell, "p").map(openText).join(" ") : shown(value);
}

/** Rows of a sheet of OpenDocument; rows may be grouped, equal cells and rows are stored once. */
function openRows(table: XmlElement): string[][] {
  const rows: string[][] = [];
  for (const row of elementsOf(table, "table-row")) {
    const cells: string[] = [];
    for (const cell of elementsIn(row)) {
      if (cell.local !== "table-cell" && cell.local !== "covered-table-cell") continue;
      const value = openValue(cell);
      const times = timesOf(cell, "number-columns-repeated", MOST_COLUMNS - cells.length);
      if (cells.length < MOST_COLUMNS) cells.push(...Array<string>(times).fill(value));
    }
    // Empty rows fill a sheet to its end.
    const isEmpty = cells.every((cell) => cell === "");
    const times = isEmpty ? 0 : timesOf(row, "number-rows-repeated", MOST_LINES);
    for (let i = 0; i < times && rows.length < MOST_LINES; i += 1) rows.push(cells);
  }
  return rows;
}

/** Rows of the sheets of a workbook of OpenDocument; sheets within cells are not looked at. */
function* openSheets(part: PartOf): Generator<string[][]> {
  const content = rootOf(part("content.xml"));
  for (const table of content ? elementsOf(content, "table") : []) yield openRows(table);
}

/** The first sheet of a workbook that has titles and lines; null if none has. Never throws. */
export function sheetOfWorkbook(part: PartOf): Sheet | null {
  for (const sheets of [officeSheets, openSheets]) {
    let looked = 0;
    for (const rows of sheets(part)) {
      const sheet = sheetOf(rows);
      if (sheet) return sheet;
      if ((looked += 1) >= MOST_SHEETS) break;
    }
  }
  return null;
}
