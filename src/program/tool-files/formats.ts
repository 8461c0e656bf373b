import { readToolFile } from "../tools/tool-table-json.ts";
import type { ForeignReader } from "./foreign-file.ts";
import { readFreeCad } from "./freecad.ts";
import { readFusion } from "./fusion.ts";
import { readLinuxCnc } from "./linuxcnc.ts";
import { readPart21Tools } from "./part21-tools.ts";
import { readPropertyList } from "./property-lists.ts";
import { readHsmLibrary, readPropertyXml } from "./xml-tools.ts";

/** How a file of tools is recognised and read: by the formats of this app and of the control, or of another system. */
type ToolFileFormat =
  | { readonly endings: readonly string[]; readonly own: typeof readToolFile }
  | { readonly endings: readonly string[]; readonly foreign: ForeignReader };

/**
 * Every format that can be imported, one line each; the first that recognises the content reads the file, its name does
 * not count. The file picker, the import dialog, `verify --tools` and the documentation follow this table.
 */
export const TOOL_FILE_FORMATS = {
  fusion: { endings: [".tools", ".json"], foreign: readFusion },
  freecad: { endings: [".fctl", ".fctb"], foreign: readFreeCad },
  part21: { endings: [".p21", ".zip"], foreign: readPart21Tools },
  hsm: { endings: [".hsmlib"], foreign: readHsmLibrary },
  propertyXml: { endings: [".xml"], foreign: readPropertyXml },
  linuxcnc: { endings: [".tbl"], foreign: readLinuxCnc },
  properties: { endings: [".csv", ".txt"], foreign: readPropertyList },
  own: { endings: [".trn", ".t", ".tab", ".json", ".csv", ".tsv", ".txt", ".xlsx", ".ods"], own: readToolFile },
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
