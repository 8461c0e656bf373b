import { Inflate } from "fflate";

/** Packed bytes per step; a byte unpacks to about a thousand at most. */
const CHUNK = 1024;

/**
 * Unpacks deflated bytes piece by piece and stops once they exceed `most`. Returns the number of unpacked bytes: more
 * than `most` if it stopped. `take` gets each piece up to the limit; `dictionary` is that of the packing. Throws on
 * damaged bytes.
 */
export function inflateUpTo(
  packed: Uint8Array,
  most: number,
  take: (piece: Uint8Array) => void,
  dictionary: Uint8Array | null = null,
): number {
  let size = 0;
  let complete = false;
  const inflate = new Inflate(dictionary ? { dictionary } : {}, (piece, final) => {
    size += piece.length;
    complete = final;
    if (size <= most) take(piece);
  });
  for (let at = 0; at < packed.length && !complete && size <= most; at += CHUNK)
    inflate.push(packed.subarray(at, at + CHUNK), at + CHUNK >= packed.length);
  if (!complete && size <= most) throw new Error("the packed bytes break off");
  return size;
}

/** The text that was deflated as UTF-8; null when it is longer than `most` bytes. Throws on damaged bytes. */
export function unpackedText(packed: Uint8Array, most: number, dictionary: Uint8Array | null = null): string | null {
  const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
  let text = "";
  const size = inflateUpTo(
    packed,
    most,
    (piece) => {
      text += decoder.decode(piece, { stream: true });
    },
    dictionary,
  );
  return size > most ? null : text + decoder.decode();
}
