import { packedFiles, unpackedFile } from "../base/unpack.ts";
import { sheetOfWorkbook } from "../../program/tool-sheets/workbook.ts";
import type { Sheet } from "../../program/tool-sheets/sheet.ts";

/** Larger parts of a workbook are not unpacked, bytes. */
const LARGEST_PART = 20_000_000;

/** The first sheet with titles of a workbook; null for another file. Throws on damaged bytes of a packed one. */
export function sheetInWorkbook(bytes: Uint8Array): Sheet | null {
  // A workbook is a zip: it begins with PK.
  if (bytes[0] !== 0x50 || bytes[1] !== 0x4b) return null;
  const files = new Map(packedFiles(bytes).map((file) => [file.name, file]));
  let left = 2 * LARGEST_PART;
  return sheetOfWorkbook((path) => {
    const file = files.get(path),
      part = file && unpackedFile(file, Math.min(left, LARGEST_PART));
    if (!part) return null;
    left -= part.length;
    return new TextDecoder().decode(part);
  });
}
