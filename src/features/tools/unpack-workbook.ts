import { unzipSync } from "fflate";
import { sheetOfWorkbook } from "../../program/tool-sheets/workbook.ts";
import type { Sheet } from "../../program/tool-sheets/sheet.ts";

/** Larger parts of a workbook are not unpacked, bytes. */
const LARGEST_PART = 20_000_000;

/** The first sheet with titles of a packed workbook; null when there is none. Throws on damaged bytes. */
export function unpackWorkbook(bytes: Uint8Array): Sheet | null {
  let left = 2 * LARGEST_PART;
  const parts = unzipSync(bytes, {
    filter: ({ name, originalSize }) => {
      if (!/^xl\/.*\.(?:xml|rels)$/.test(name) || originalSize > Math.min(left, LARGEST_PART)) return false;
      left -= originalSize;
      return true;
    },
  });
  return sheetOfWorkbook((path) => {
    const part = parts[path];
    return part ? new TextDecoder().decode(part) : null;
  });
}
