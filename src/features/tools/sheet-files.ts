import { retryImport } from "../../app/base/parts.ts";
import { decode } from "../../app/document/encoding.ts";
import { readSheet, type Sheet } from "../../program/tool-sheets/sheet.ts";

/** A sheet with the name of its file. */
export interface NamedSheet {
  readonly name: string;
  readonly sheet: Sheet;
}

/** A workbook is a packed file: it begins with PK. */
export const isWorkbook = (bytes: Uint8Array): boolean => bytes[0] === 0x50 && bytes[1] === 0x4b;

/** Bytes among which UTF-16 without a mark is recognized: half of them are 0. */
const LOOKED_AT = 200;

function utf16In(bytes: Uint8Array): "utf-16le" | "utf-16be" | null {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return "utf-16le";
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return "utf-16be";
  const head = bytes.subarray(0, LOOKED_AT);
  const zeros = (odd: number) => head.filter((byte, i) => i % 2 === odd && byte === 0).length;
  if (zeros(1) * 3 > head.length) return "utf-16le";
  return zeros(0) * 3 > head.length ? "utf-16be" : null;
}

/** The sheet in a file: a workbook, or text as UTF-8, UTF-16 or Windows-1252; null when there is none. */
export async function sheetInFile(bytes: Uint8Array): Promise<Sheet | null> {
  if (isWorkbook(bytes)) {
    const { unpackWorkbook } = await retryImport(() => import("./unpack-workbook.ts"));
    return unpackWorkbook(bytes);
  }
  const wide = utf16In(bytes);
  return readSheet(wide ? new TextDecoder(wide).decode(bytes) : decode(bytes).text);
}
