import { packedFiles, unpackedFile } from "../base/unpack.ts";
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
  const unpack = (archive: Uint8Array, depth: number): boolean => {
    const files = packedFiles(archive).filter(({ name: path }) => {
      const lower = path.toLowerCase();
      return !lower.endsWith("/") && endings.some((ending) => lower.endsWith(ending));
    });
    // The sizes of all files are added up before any is unpacked, and none becomes larger than it says.
    size += files.reduce((sum, file) => sum + file.size, 0);
    if (size > limits.bytes || texts.length + files.length > limits.texts) return false;
    return files.every((file) => {
      const content = unpackedFile(file);
      if (content === null) return false;
      if (!isZip(content)) texts.push({ name: file.name, ...decodeAny(content), packed: true });
      else if (depth < limits.depth && ARCHIVE.test(file.name)) return unpack(content, depth + 1);
      return true;
    });
  };
  return unpack(bytes, 1) ? texts : "tooLarge";
}
