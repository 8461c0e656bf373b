import { readTableCsv } from "../tools/tool-table-csv.ts";
import { readTableJson } from "../tools/tool-table-json.ts";
import { readTableText, type TableFile } from "../tools/tool-table-text.ts";
import type { ForeignReader } from "./foreign-file.ts";
import { readFreeCad } from "./freecad.ts";
import { readFusion } from "./fusion.ts";
import { readLinuxCnc } from "./linuxcnc.ts";
import { readPart21Tools } from "./part21-tools.ts";
import { readPropertyList } from "./property-lists.ts";

/** How a file of tools is recognised and read: a file of this app or of the control, or one of another system. */
type ToolFileFormat =
  | { readonly endings: readonly string[]; readonly own: (text: string) => TableFile | null }
  | { readonly endings: readonly string[]; readonly foreign: ForeignReader };

const ifFound = (read: TableFile): TableFile | null => ("problem" in read && read.problem === "notATable" ? null : read);
const isJson = (text: string) => /^\uFEFF?\s*[{[]/.test(text);

/**
 * Every format that can be imported, one line each; the first that recognises the content reads the file, its name does
 * not count. The file picker, the import dialog, `verify --tools` and the documentation follow this table.
 */
export const TOOL_FILE_FORMATS = {
  control: { endings: [".trn", ".t", ".tab"], own: (text) => (/^\uFEFF?\s*BEGIN\s/i.test(text) ? readTableText(text) : null) },
  fusion: { endings: [".tools", ".json"], foreign: readFusion },
  freecad: { endings: [".fctl", ".fctb"], foreign: readFreeCad },
  json: { endings: [".json"], own: (text) => (isJson(text) ? ifFound(readTableJson(text)) : null) },
  part21: { endings: [".p21", ".zip"], foreign: readPart21Tools },
  linuxcnc: { endings: [".tbl"], foreign: readLinuxCnc },
  properties: { endings: [".csv", ".txt"], foreign: readPropertyList },
  sheet: { endings: [".csv", ".txt", ".tsv"], own: (text) => (isJson(text) ? null : ifFound(readTableCsv(text))) },
} as const satisfies Readonly<Record<string, ToolFileFormat>>;

export type ToolFormatName = keyof typeof TOOL_FILE_FORMATS;
/** Formats of other systems. */
export type ForeignFormat = {
  [N in ToolFormatName]: (typeof TOOL_FILE_FORMATS)[N] extends { readonly foreign: ForeignReader } ? N : never;
}[ToolFormatName];

/** Endings of all formats, for the file picker. */
export const TOOL_FILE_ENDINGS: readonly string[] = [
  ...new Set(Object.values(TOOL_FILE_FORMATS).flatMap(({ endings }) => endings)),
];
