import { deflateSync, inflateSync, strFromU8, strToU8 } from "fflate";

/** What stands between the page's address and the program in a share link. */
const MARK = "#p=";
/** A link that unpacks to more than this is not opened, characters. */
const LONGEST = 20_000_000;

const toBase64Url = (bytes: Uint8Array): string => {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
};

const fromBase64Url = (text: string): Uint8Array => Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));

/** A link that carries the program itself: nothing is stored anywhere. `page` is the address without anything behind `#`. */
export const shareLink = (page: string, text: string): string => page + MARK + toBase64Url(deflateSync(strToU8(text), { level: 9 }));

/** The program of a link's part behind `#`; null where there is none, or none that can be read. Never throws. */
export function sharedProgram(hash: string): string | null {
  if (!hash.startsWith(MARK)) return null;
  try {
    const text = strFromU8(inflateSync(fromBase64Url(hash.slice(MARK.length))));
    return text.length > LONGEST ? null : text;
  } catch {
    return null;
  }
}
