import { unzipSync } from "fflate";
import { decodeAny } from "./encoding.ts";
import type { Encoding } from "./work.ts";

/** A text file, as chosen or out of an archive. */
export interface FileText {
  readonly name: string;
  readonly text: string;
  readonly encoding: Encoding;
  /** Whether it was packed in a chosen archive. */
  readonly packed: boolean;
}

/** Limits of unpacking an archive: bytes of all texts, texts, and archives within archives. */
export interface TextLimits {
  readonly bytes: number;
  readonly texts: number;
  readonly depth: number;
}
const LIMITS: TextLimits = { bytes: 100_000_000, texts: 3000, depth: 2 };

const isZip = (bytes: Uint8Array) => bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] === 3 && bytes[3] === 4;
const ARCHIVE = /\.(?:zip|tools)$/i;

/**
 * The texts of a chosen file: its own, or those in an archive whose names have one of the endings. `tooLarge`: an
 * archive beyond the limits. Throws on a damaged archive.
 */
export function textsOfFile(
  name: string,
  bytes: Uint8Array,
  endings: readonly string[],
  limits: TextLimits = LIMITS,
): readonly FileText[] | "tooLarge" {
  if (!isZip(bytes)) return [{ name, ...decodeAny(bytes), packed: false }];
  const texts: FileText[] = [];
  let size = 0;
  const unpack = (packed: Uint8Array, depth: number): boolean => {
    let count = 0;
    let fits = true;
    // The sizes of all entries are added up before any is unpacked, and none becomes larger than it says.
    const entries = unzipSync(packed, {
      filter: (entry) => {
        const lower = entry.name.toLowerCase();
        if (!fits || lower.endsWith("/") || !endings.some((ending) => lower.endsWith(ending))) return false;
        size += entry.originalSize;
        count += 1;
        fits = size <= limits.bytes && texts.length + count <= limits.texts;
        return fits;
      },
    });
    if (!fits) return false;
    return Object.entries(entries).every(([path, content]) => {
      if (!isZip(content)) texts.push({ name: path, ...decodeAny(content), packed: true });
      else if (depth < limits.depth && ARCHIVE.test(path)) return unpack(content, depth + 1);
      return true;
    });
  };
  return unpack(bytes, 1) ? texts : "tooLarge";
}
