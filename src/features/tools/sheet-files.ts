import { retryImport } from "../../app/base/parts.ts";
import { decodeAny } from "../../app/document/encoding.ts";
import { readSheet, type Sheet } from "../../program/tool-sheets/sheet.ts";

/** A sheet with the name of its file. */
export interface NamedSheet {
  readonly name: string;
  readonly sheet: Sheet;
}

/** A workbook is a packed file: it begins with PK. */
export const isWorkbook = (bytes: Uint8Array): boolean => bytes[0] === 0x50 && bytes[1] === 0x4b;

/** The sheet in a file: a workbook, or text as UTF-8, UTF-16 or Windows-1252; null when there is none. */
export async function sheetInFile(bytes: Uint8Array): Promise<Sheet | null> {
  if (isWorkbook(bytes)) {
    const { sheetInWorkbook } = await retryImport(() => import("../../app/document/workbook-file.ts"));
    return sheetInWorkbook(bytes);
  }
  return readSheet(decodeAny(bytes).text);
}
