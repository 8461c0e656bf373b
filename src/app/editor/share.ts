import { deflateSync, strToU8 } from "fflate";
import { LARGEST_PROGRAM } from "../files/limits.ts";
import { unpackedText } from "./unpack.ts";

/** What stands between the page's address and the program in a share link. */
export const MARK = "#p=";

const toBase64Url = (bytes: Uint8Array): string => {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
};

const fromBase64Url = (text: string): Uint8Array =>
  Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));

/** A link that carries the program itself: nothing is stored anywhere. `page` is the address without anything behind `#`. */
export const shareLink = (page: string, text: string): string => page + MARK + toBase64Url(deflateSync(strToU8(text), { level: 9 }));

/** What a link carries: a program, one that is larger than is opened, or nothing that can be read. */
export type Shared = { readonly kind: "program"; readonly text: string } | { readonly kind: "tooLarge" | "damaged" };

/** The program of a link's part behind `#`. Never throws, and never unpacks more than it opens. */
export function sharedProgram(hash: string, most = LARGEST_PROGRAM): Shared {
  if (!hash.startsWith(MARK)) return { kind: "damaged" };
  try {
    const text = unpackedText(fromBase64Url(hash.slice(MARK.length)), most);
    return text === null ? { kind: "tooLarge" } : { kind: "program", text };
  } catch {
    return { kind: "damaged" };
  }
}
