import { csvCells, csvSeparator } from "../files/csv.ts";
import { unitOf, type FileProperties, type FileProperty, type FileTool, type RefusedItem } from "./facts.ts";
import { MOST_ITEMS, type ForeignContent, type ReadingContext } from "./foreign-file.ts";
import { dinTool, isDin4000 } from "./din4000.ts";
import { fusionSheet, sorted } from "./fusion.ts";
import { isoTool, ISO13399_SYMBOLS } from "./iso13399.ts";

/*
 * Lists of properties as text: a sheet with the letters of DIN 4000 or the symbols of ISO 13399 as titles, a list with a
 * symbol, its meaning and a value on each line as the pages of makers show it, and the sheet that Fusion exports.
 */

/** Fewer symbols may be there by chance. */
const LEAST_SYMBOLS = 4;

/** Characters that tell which separator a text uses. */
const HEAD = 4000;

interface Read {
  readonly item: FileTool | RefusedItem;
  readonly unitAsked: boolean;
}

/** A tool from its properties, by the standard that they belong to. */
export function toolOfProperties(properties: FileProperties, unit: ReadingContext["unit"], label: string): Read {
  if (isDin4000(properties)) return { item: dinTool(properties), unitAsked: false };
  const { tool, unitAsked } = isoTool(properties, unit, { label, texts: [label] });
  return { item: tool, unitAsked };
}

const symbolOf = (cell: string) =>
  cell
    .trim()
    .toUpperCase()
    .replace(/(?<!\s)\s*[[(](?:MM|INCH|IN|DEG|°)[\])]$/, "");
const countSymbols = (names: readonly string[]) => new Set(names.filter((name) => ISO13399_SYMBOLS.has(name))).size;
const NAMES = ["NAME", "DESCRIPTION", "PRODUCT", "ORDERCODE", "ORDER CODE", "ITEMNUMBER", "ID"];

/** A line of titles is no property. */
const TITLES = /^(?:value|wert|valeur|值)?$/i;

/** A sheet with one tool on each line. */
function wide(rows: readonly (readonly string[])[], unit: ReadingContext["unit"]): readonly Read[] | null {
  const names = (rows[0] ?? []).map(symbolOf);
  const isDin = names.includes("NSM");
  if (!isDin && (countSymbols(names) < LEAST_SYMBOLS || names.includes("T"))) return null;
  return rows.slice(1, MOST_ITEMS + 1).map((row, i) => {
    const cells = names.map((name, at) => [name, (row[at] ?? "").trim()] as const);
    const label = cells.find(([name, cell]) => NAMES.includes(name) && cell !== "")?.[1] ?? `${i + 1}`;
    const filled = cells.filter(([name, cell]) => name !== "" && cell !== "" && (isDin || !NAMES.includes(name)));
    return toolOfProperties(new Map(filled.map(([name, value]) => [name, { value }])), unit, label);
  });
}

/** A list with one property on each line: its symbol first, its value last or before its unit. */
function tall(rows: readonly (readonly string[])[], { unit, name }: ReadingContext): Read | null {
  const properties = new Map<string, FileProperty>();
  for (const row of rows.slice(0, MOST_ITEMS)) {
    const symbol = symbolOf(row[0] ?? "");
    const cells = row.slice(1).filter((cell) => cell.trim() !== "");
    const own = cells.length > 1 ? unitOf(cells.at(-1) ?? "") : null;
    const value = (own === null ? cells.at(-1) : cells.at(-2))?.trim();
    if (symbol !== "" && value !== undefined && !properties.has(symbol))
      properties.set(symbol, { value, ...(own && { unit: own }) });
  }
  const names = [...properties.keys()];
  if (!isDin4000(properties) && (countSymbols(names) < LEAST_SYMBOLS || countSymbols(names) * 4 < names.length))
    return null;
  const label = NAMES.map((each) => String(properties.get(each)?.value ?? "")).find((each) => !TITLES.test(each));
  for (const each of NAMES) properties.delete(each);
  return toolOfProperties(properties, unit, label ?? name.replace(/\.\w+$/, ""));
}

/** Reads a list of properties; null when the text is none. */
export function readPropertyList(text: string, context: ReadingContext): ForeignContent | null {
  const whole = text.replace(/^\uFEFF/, "").trimStart();
  if (/^[<{[]|^ISO-10303-21|^BEGIN\s/i.test(whole)) return null;
  const rows = csvCells(
    whole,
    csvSeparator(
      whole
        .slice(0, HEAD)
        .split(/[\r\n]+/)
        .slice(0, 20)
        .join(" "),
    ),
  );
  const sheet = fusionSheet(rows, context);
  if (sheet) return sheet;
  const single = wide(rows, context.unit) ? null : tall(rows, context);
  const read = wide(rows, context.unit) ?? (single ? [single] : []);
  if (read.length === 0) return null;
  return { ...sorted(read.map(({ item }) => item)), unitAsked: read.some(({ unitAsked }) => unitAsked) };
}
