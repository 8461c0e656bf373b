import type { Encoding } from "./work.ts";

/** Characters of the bytes 128 to 159 in Windows-1252; all other bytes are the character of the same number. */
const SPECIAL = "€\u0081‚ƒ„…†‡ˆ‰Š‹Œ\u008dŽ\u008f\u0090‘’“”•–—˜™š›œ\u009džŸ";
const FIRST = 128;

const characterOf = (byte: number) => SPECIAL[byte - FIRST] ?? String.fromCharCode(byte);
const byteOf = new Map(Array.from({ length: 256 }, (_, byte) => [characterOf(byte), byte]));

function fromLegacy(file: Uint8Array): string {
  const parts: string[] = [];
  for (let i = 0; i < file.length; i += 0x8000)
    parts.push(Array.from(file.subarray(i, i + 0x8000), characterOf).join(""));
  return parts.join("");
}

/** The text of a file: UTF-8 if it is valid, otherwise the encoding of older controls. Nothing is left out. */
export function decode(file: Uint8Array): { readonly text: string; readonly encoding: Encoding } {
  try {
    return { text: new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(file), encoding: "utf-8" };
  } catch {
    return { text: fromLegacy(file), encoding: "windows-1252" };
  }
}

/** The bytes of a text; a character outside the older encoding makes it UTF-8. */
export function encode(text: string, encoding: Encoding): Uint8Array<ArrayBuffer> {
  const legacy = encoding === "windows-1252" ? Uint8Array.from(text, (c) => byteOf.get(c) ?? 0) : null;
  return legacy && fromLegacy(legacy) === text ? legacy : new TextEncoder().encode(text);
}

/** The first character of a file's text that its encoding lacks; null if it has them all. */
export function notIn({ text, encoding }: { readonly text: string; readonly encoding: Encoding }): string | null {
  if (encoding === "utf-8") return null;
  for (const character of text) if (!byteOf.has(character)) return character;
  return null;
}

/** Bytes among which UTF-16 without a byte order mark is recognized: half of them are 0. */
const LOOKED_AT = 200;

function utf16In(bytes: Uint8Array): "utf-16le" | "utf-16be" | null {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return "utf-16le";
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return "utf-16be";
  const head = bytes.subarray(0, LOOKED_AT);
  const zeros = (odd: number) => head.filter((byte, i) => i % 2 === odd && byte === 0).length;
  if (zeros(1) * 3 > head.length) return "utf-16le";
  return zeros(0) * 3 > head.length ? "utf-16be" : null;
}

/**
 * The text of a file of another program, which may be UTF-16 with or without a byte order mark, and is then written as
 * UTF-8; else as `decode`.
 */
export function decodeAny(bytes: Uint8Array): ReturnType<typeof decode> {
  const wide = utf16In(bytes);
  if (!wide) return decode(bytes);
  try {
    return { text: new TextDecoder(wide, { fatal: true }).decode(bytes), encoding: "utf-8" };
  } catch {
    return decode(bytes);
  }
}
