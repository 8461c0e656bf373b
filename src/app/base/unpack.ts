import { Inflate, strFromU8 } from "fflate";
import { LARGEST_PROGRAM } from "./limits.ts";

/** Packed bytes per step; a byte unpacks to about a thousand at most. */
const CHUNK = 1024;

/**
 * What packed bytes may unpack to, bytes: programs of equal blocks shrink to a hundredth, only a trap to less. Small
 * ones may shrink as far as they like.
 */
const mostOf = (packed: Uint8Array, most: number): number => Math.min(most, LARGEST_PROGRAM + 200 * packed.length);

/**
 * Unpacks deflated bytes piece by piece and stops once they exceed `most`, or once `take` refuses a piece (false).
 * Returns the number of unpacked bytes: more than `most` if it stopped. `take` gets each piece up to the limit;
 * `dictionary` is that of the packing. Throws on damaged bytes.
 */
export function inflateUpTo(
  packed: Uint8Array,
  limit: number,
  take: (piece: Uint8Array) => boolean | void,
  dictionary: Uint8Array | null = null,
): number {
  const most = mostOf(packed, limit);
  let size = 0;
  let complete = false;
  const inflate = new Inflate(dictionary ? { dictionary } : {}, (piece, final) => {
    size += piece.length;
    complete = final;
    if (size <= most && take(piece) === false) size = Infinity;
  });
  for (let at = 0; at < packed.length && !complete && size <= most; at += CHUNK)
    inflate.push(packed.subarray(at, at + CHUNK), at + CHUNK >= packed.length);
  if (!complete && size <= most) throw new Error("the packed bytes break off");
  return size > most ? Infinity : size;
}

/** Measures a text that arrives in pieces; false once it is not to be used. */
type Gauge = (piece: string) => boolean;

/**
 * The text that was deflated as UTF-8; null when it is longer than `most` bytes or beyond its gauge. Throws on damaged
 * bytes.
 */
export function unpackedText(
  packed: Uint8Array,
  most: number,
  dictionary: Uint8Array | null = null,
  gauge: Gauge = () => true,
): string | null {
  const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
  let text = "";
  const size = inflateUpTo(
    packed,
    most,
    (piece) => {
      const more = decoder.decode(piece, { stream: true });
      text += more;
      return gauge(more);
    },
    dictionary,
  );
  return size > most ? null : text + decoder.decode();
}

/** A file of a zip: its name, its unpacked size as declared, and its bytes as they are stored. */
export interface PackedFile {
  readonly name: string;
  readonly size: number;
  readonly isDeflated: boolean;
  readonly packed: Uint8Array;
}

/** Marks of the records of a zip, and their least lengths (APPNOTE.TXT of PKWARE, 4.3). */
const RECORDS = {
  end: { mark: 0x06054b50, length: 22 },
  entry: { mark: 0x02014b50, length: 46 },
  local: { mark: 0x04034b50, length: 30 },
} as const;
/** Flag of a file whose name is in UTF-8. */
const UTF8 = 1 << 11;
/** A size or place of this value stands in the field of large files. */
const LARGE = 0xffffffff;
/** Longest comment behind the directory, bytes. */
const COMMENT = 0xffff;

/** The values of an entry that were too large for its fields, in their order. */
function largeValues(view: DataView, from: number, to: number): number[] {
  for (let at = from; at + 4 <= to; at += 4 + view.getUint16(at + 2, true)) {
    if (view.getUint16(at, true) !== 1) continue;
    const count = Math.floor(view.getUint16(at + 2, true) / 8);
    return Array.from({ length: count }, (_, i) => Number(view.getBigUint64(at + 4 + 8 * i, true)));
  }
  return [];
}

/** The files in the directory of a zip, unpacked only by `unpackedFile`. Throws on damaged bytes. */
export function packedFiles(bytes: Uint8Array): PackedFile[] {
  const { end, entry, local } = RECORDS;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let tail = bytes.length - end.length;
  while (view.getUint32(tail, true) !== end.mark)
    if ((tail -= 1) < bytes.length - end.length - COMMENT) throw new Error("no directory of a zip");
  let at = view.getUint32(tail + 16, true);
  return Array.from({ length: view.getUint16(tail + 10, true) }, () => {
    if (view.getUint32(at, true) !== entry.mark) throw new Error("the directory of the zip is damaged");
    const nameEnd = at + entry.length + view.getUint16(at + 28, true),
      extraEnd = nameEnd + view.getUint16(at + 30, true);
    const large = largeValues(view, nameEnd, extraEnd);
    const [size = 0, length = 0, place = 0] = [at + 24, at + 20, at + 42].map((field) => {
      const value = view.getUint32(field, true);
      return value === LARGE ? (large.shift() ?? value) : value;
    });
    if (view.getUint32(place, true) !== local.mark) throw new Error("a file of the zip is damaged");
    const from = place + local.length + view.getUint16(place + 26, true) + view.getUint16(place + 28, true);
    const name = strFromU8(bytes.subarray(at + entry.length, nameEnd), (view.getUint16(at + 8, true) & UTF8) === 0);
    const isDeflated = view.getUint16(at + 10, true) === 8;
    at = extraEnd + view.getUint16(at + 32, true);
    return { name, size, isDeflated, packed: bytes.subarray(from, from + length) };
  });
}

/**
 * The text of a file of a zip in UTF-8; null when it is longer than `most` bytes or beyond its gauge. Throws on damaged
 * bytes.
 */
export function unpackedFileText({ isDeflated, packed }: PackedFile, most: number, gauge: Gauge): string | null {
  if (isDeflated) return unpackedText(packed, most, null, gauge);
  const text = packed.length > most ? null : new TextDecoder("utf-8", { ignoreBOM: true }).decode(packed);
  return text !== null && gauge(text) ? text : null;
}

/** The bytes of a file of a zip; null when they are more than declared or than `most`. Throws on damaged bytes. */
export function unpackedFile({ size, isDeflated, packed }: PackedFile, most = size): Uint8Array | null {
  if (size > mostOf(packed, most)) return null;
  if (!isDeflated) return packed.length > size ? null : packed;
  const out = new Uint8Array(size);
  let at = 0;
  const found = inflateUpTo(packed, size, (piece) => {
    out.set(piece, at);
    at += piece.length;
  });
  return found > size ? null : out.subarray(0, at);
}
