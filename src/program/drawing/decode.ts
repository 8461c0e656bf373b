interface Decoder {
  decode(bytes: Uint8Array): string;
}
/** Part of every browser and of Node; the pure layers have no DOM types. */
declare const TextDecoder: new (label?: string, options?: { readonly fatal?: boolean }) => Decoder;

function decoder(label: string): Decoder | null {
  try {
    return new TextDecoder(label);
  } catch {
    return null;
  }
}

/** Text of a file: UTF-16 by its mark, UTF-8 where it is valid, otherwise the named encoding, otherwise Windows Latin. */
export function decoded(bytes: Uint8Array, encoding = "windows-1252"): string {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return new TextDecoder("utf-16le").decode(bytes);
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return new TextDecoder("utf-16be").decode(bytes);
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return (decoder(encoding) ?? new TextDecoder("windows-1252")).decode(bytes);
  }
}
