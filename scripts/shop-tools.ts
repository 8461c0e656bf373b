import { textsOfFile } from "../src/app/document/file-texts.ts";
import { sheetInWorkbook } from "../src/app/document/workbook-file.ts";
import { toolForeign } from "../src/i18n/en/tool-foreign.ts";
import type { LengthUnit } from "../src/kernel/units.ts";
import type { ForeignTool } from "../src/program/tool-files/foreign-tool.ts";
import { jsonOf } from "../src/program/tool-files/foreign-file.ts";
import { TOOL_FILE_ENDINGS } from "../src/program/tool-files/formats.ts";
import { numbered, readToolFiles, type ForeignTools } from "../src/program/tool-files/read-tool-files.ts";
import { builtInTools } from "../src/program/iso-codes/usual-tools.ts";
import { readTools, type ShopTools } from "../src/program/tools/read-tools.ts";
import type { CellName } from "../src/program/tools/tool-columns.ts";
import { readEntry } from "../src/program/tools/tool-entry.ts";
import { isLength, proposedAssignment, toolsOfSheet } from "../src/program/tool-sheets/assignment.ts";
import { unitIn } from "../src/program/tool-sheets/column-words.ts";
import { readSheet, type Sheet } from "../src/program/tool-sheets/sheet.ts";
import { unknownToolKeys } from "../src/program/tools/tool-keys.ts";
import { readList } from "../src/program/tools/tool-list.ts";

/** Tools of a shop's file, and a line for each thing that is doubtful about them; or why the file cannot be used. */
export type ReadShopTools =
  | { readonly tools: ShopTools; readonly notes: readonly string[] }
  | { readonly problem: string };

/** The formats of other systems, for the help. */
export const toolFormatNames = Object.values(toolForeign.formats).join(", ");

/** The tools file of this command, strictly: a value of a wrong type refuses it, an unknown key is named. */
function ownTools(text: string): ReadShopTools {
  const tools = readTools(text);
  if ("problem" in tools) return tools;
  const notes = unknownToolKeys(jsonOf(text)).map(({ at, key, nearest }) => {
    const hint = nearest === null ? "" : `; did you mean ${nearest}?`;
    return `unknown key ${at === "" ? "" : `${at}.`}${key}${hint}`;
  });
  return { tools, notes };
}

function notesOfTool({ cells, origins, label }: ForeignTool): readonly string[] {
  const name = `T${cells.T ?? ""} ${label}`.trim();
  const proposed = Object.entries(origins)
    .filter(([, { why }]) => why.length > 0)
    .map(([cell, { why }]) => {
      const reasons = why.map((each) => toolForeign.why[each]).join("; ");
      return `${name}: proposed ${cell} ${cells[cell as CellName] ?? ""} (${reasons})`;
    });
  const missing = readEntry({ id: "", cells })
    .issues.filter(({ severity, at }) => severity === "error" && !cells[at as CellName])
    .map(({ at }) => at);
  return [...proposed, ...(missing.length > 0 ? [`${name}: ${toolForeign.missing(missing.join(", "))}`] : [])];
}

const notesOf = ({ tools, refused, assumedUnit }: ForeignTools): readonly string[] => [
  ...(assumedUnit === null ? [] : [`the file does not state its unit: read in ${assumedUnit} (--tools-unit)`]),
  ...tools.flatMap(notesOfTool),
  ...refused.map(({ label, why, kind }) => `not read: ${label}: ${toolForeign.refusals[why](kind)}`),
];

/** Numbers of the built-in tools and drills: a tool without a number gets another one. */
const SHIPPED = [...builtInTools.table.tools, ...(builtInTools.table.mills ?? [])].map(({ T }): number => T);

/** Columns that a sheet needs to be one of tools: what each tool is. */
const SAYS_KIND: ReadonlySet<string> = new Set(["TYPE", "CODE"]);

/** A sheet with titles of its own, its columns as the page proposes them; null when they say nothing about tools. */
function sheetTools(sheet: Sheet | null, unit: LengthUnit): ReadShopTools | null {
  if (!sheet) return null;
  const { columns, words } = proposedAssignment(sheet);
  if (!columns.some((column) => column && SAYS_KIND.has(column.cell))) return null;
  const titleOf = (at: number) => sheet.titles[at] ?? "";
  const inUnit = columns.map((column, at) =>
    column && isLength(column.cell) && unitIn(titleOf(at)) === null ? { ...column, inch: unit === "inch" } : column,
  );
  const taken = new Set<number>(SHIPPED);
  const { rows, twice, unused } = toolsOfSheet(sheet, { columns: inUnit, words }, taken);
  const read = columns.flatMap((column, at) => (column ? [`${titleOf(at)} as ${column.cell}`] : []));
  const { table } = readList(rows.map(({ cells }, i) => ({ id: `r${i}`, cells })));
  const notes = [
    `columns read by their titles and values, lengths in ${unit} where no unit stands (--tools-unit): ${read.join(", ")}`,
    ...(unused.length > 0 ? [`columns not read: ${unused.join(", ")}`] : []),
    ...(twice.length > 0 ? [`numbers that stand twice, the last one counts: ${twice.join(", ")}`] : []),
    ...rows.flatMap(({ cells, line, isNumbered }) =>
      isNumbered ? [] : [`line ${line} without a number: proposed T${cells.T ?? ""}`],
    ),
  ];
  return { tools: table, notes };
}

/** Reads the file of `--tools`: the JSON of this app, a table of the control, a sheet, or a file of another system. */
export function readShopTools(name: string, data: Uint8Array, unit: LengthUnit): ReadShopTools {
  let texts: ReturnType<typeof textsOfFile>;
  try {
    const workbook = sheetTools(sheetInWorkbook(data), unit);
    if (workbook) return workbook;
    texts = textsOfFile(name, data, TOOL_FILE_ENDINGS);
  } catch {
    return { problem: "the archive is damaged" };
  }
  if (texts === "tooLarge") return { problem: "the archive is too large" };
  const all = readToolFiles(texts, unit);
  const [only] = texts;
  const isForeign = all.some(({ content }) => "foreign" in content);
  if (only && !isForeign && /^\s*[{[]/.test(only.text)) return ownTools(only.text);
  const read = all.filter(({ content }) => !("problem" in content));
  if (read.length === 0)
    return (only && sheetTools(readSheet(only.text), unit)) ?? { problem: "not a table of tools in a known format" };
  const foreign = read.flatMap(({ content }) => ("foreign" in content ? [content.foreign] : []));
  const rows = read.flatMap(({ content }) => ("table" in content ? content.table.rows : []));
  const taken = new Set([...SHIPPED, ...rows.map(({ T }) => Number(T))]);
  const tools = numbered(
    foreign.flatMap((each) => each.tools),
    taken,
  );
  const { table } = readList([...rows, ...tools.map(({ cells }) => cells)].map((cells, i) => ({ id: `r${i}`, cells })));
  const first = foreign[0];
  const notes = first ? notesOf({ ...first, tools, refused: foreign.flatMap((each) => each.refused) }) : [];
  return { tools: table, notes };
}
