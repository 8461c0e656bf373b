import { decoded } from "../decode.ts";

/** A group of a DXF file: its code, and its value as text; numbers are read where they are used. */
export interface Tag {
  readonly code: number;
  readonly text: string;
}

/** First bytes of a binary DXF file. */
const BINARY = "AutoCAD Binary DXF\r\n\u001a\0";
/** Bytes in which a file says what it is. */
const HEAD = 4000;
const latin = (bytes: Uint8Array, from: number, to: number) => String.fromCharCode(...bytes.subarray(from, to));

/** Kinds of values in binary files by their codes (DXF reference, "Group code value types"). */
const VALUES: readonly (readonly [
  from: number,
  to: number,
  kind: "real" | "short" | "long" | "wide" | "bool" | "chunk",
])[] = [
  [10, 59, "real"],
  [60, 79, "short"],
  [90, 99, "long"],
  [110, 149, "real"],
  [160, 169, "wide"],
  [170, 179, "short"],
  [210, 239, "real"],
  [270, 289, "short"],
  [290, 299, "bool"],
  [310, 319, "chunk"],
  [370, 389, "short"],
  [400, 409, "short"],
  [420, 429, "long"],
  [440, 459, "long"],
  [460, 469, "real"],
  [1004, 1004, "chunk"],
  [1010, 1059, "real"],
  [1060, 1070, "short"],
  [1071, 1071, "long"],
];
const kindOf = (code: number) => VALUES.find(([from, to]) => code >= from && code <= to)?.[2];

/** Tags of a binary file; codes have two bytes, in files before release 13 one. Ends where the file is cut off. */
function* binaryTags(bytes: Uint8Array, text: (bytes: Uint8Array) => string): Generator<Tag> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isShort = bytes[BINARY.length + 1] !== 0;
  let at = BINARY.length;
  const has = (count: number) => at + count <= bytes.length;
  while (has(2)) {
    let code = view.getUint8(at);
    at += 1;
    if (!isShort) {
      code = view.getInt16(at - 1, true);
      at += 1;
    } else if (code === 255) {
      if (!has(2)) return;
      code = view.getInt16(at, true);
      at += 2;
    }
    const kind = kindOf(code);
    if (kind === undefined) {
      const end = bytes.indexOf(0, at);
      if (end < 0) return;
      yield { code, text: text(bytes.subarray(at, end)) };
      at = end + 1;
    } else if (kind === "chunk") {
      if (!has(1)) return;
      at += 1 + view.getUint8(at);
    } else {
      const size = { real: 8, wide: 8, long: 4, short: 2, bool: 1 }[kind];
      if (!has(size)) return;
      const value =
        kind === "real"
          ? view.getFloat64(at, true)
          : kind === "wide"
            ? Number(view.getBigInt64(at, true))
            : integer(view, at, size);
      at += size;
      yield { code, text: String(value) };
    }
  }
}
const integer = (view: DataView, at: number, size: number) =>
  size === 4 ? view.getInt32(at, true) : size === 2 ? view.getInt16(at, true) : view.getInt8(at);

/** Tags of a text file. A line that should be a code and is none is skipped, so that one lost line costs one group. */
function* textTags(text: string): Generator<Tag> {
  const lines = /([^\r\n]*)(\r\n|\n|\r|$)/gy;
  const next = () => {
    if (lines.lastIndex >= text.length) return null;
    return lines.exec(text)?.[1] ?? null;
  };
  for (let line = next(); line !== null; line = next()) {
    const typed = line.trim();
    if (!/^-?\d{1,5}$/.test(typed)) continue;
    const value = next();
    if (value === null) return;
    if (typed !== "999") yield { code: Number(typed), text: value };
  }
}

/** Encodings by $DWGCODEPAGE; files since release 2007 are UTF-8. */
function encodingOf(page: string): string {
  const number = /(\d+)/.exec(page)?.[1] ?? "1252";
  const named: Readonly<Record<string, string>> = {
    "932": "shift_jis",
    "936": "gbk",
    "949": "euc-kr",
    "950": "big5",
    "866": "ibm866",
    "874": "windows-874",
  };
  return named[number] ?? (/^125\d$/.test(number) ? `windows-${number}` : "windows-1252");
}

/** The code page that a file names in its first bytes; in binary files its name stands behind the group code. */
const pageOf = (head: string): string => /\$DWGCODEPAGE[^A-Z]*([A-Z0-9_]+)/i.exec(head)?.[1] ?? "";

/** Reads the groups of a DXF file, text or binary, in its encoding; null when it is no DXF file. */
export function readTags(bytes: Uint8Array): Iterable<Tag> | null {
  const head = latin(bytes, 0, Math.min(bytes.length, HEAD)),
    encoding = encodingOf(pageOf(head));
  if (head.startsWith(BINARY)) return binaryTags(bytes, (part) => decoded(part, encoding));
  const text = decoded(bytes, encoding).replace(/^\uFEFF/, "");
  // Comments (999) may stand before the first section.
  return /^\s*(?:999[^\r\n]*(?:\r\n|\n|\r(?!\n))[^\r\n]*[\r\n]\s*)*0[ \t]*[\r\n]\s*SECTION/i.test(text.slice(0, HEAD))
    ? textTags(text)
    : null;
}

/** A finite number of a group within sane limits; null otherwise. Some programs write a decimal comma. */
export function numberOf(text: string | undefined): number | null {
  if (text === undefined) return null;
  const typed = text.trim().replace(",", ".");
  const value = typed === "" ? Number.NaN : Number(typed);
  return Number.isFinite(value) && Math.abs(value) < 1e9 ? value : null;
}
