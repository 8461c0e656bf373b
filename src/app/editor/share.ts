import { deflateSync, strToU8 } from "fflate";
import { LARGEST_PROGRAM } from "../files/limits.ts";
import { readProgram } from "../saving/save-file.ts";
import { filesOf, type ProgramWork } from "../work.ts";
import { unpackedText } from "./unpack.ts";

/** What stands between the page's address and the program in a share link. */
export const MARK = "#p=";
/** The same for a program with files beside it, or with settings of its own. */
const WORK_MARK = "#w=";

const toBase64Url = (bytes: Uint8Array): string => {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
};

const fromBase64Url = (text: string): Uint8Array =>
  Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));

/**
 * A link that carries the program itself: nothing is stored anywhere. `page` is the address without anything behind `#`.
 * What belongs to the program goes along; a program alone is only its text.
 */
export function shareLink(page: string, program: ProgramWork): string {
  const alone = filesOf(program).length === 0 && !program.skipMarked;
  const packed = deflateSync(strToU8(alone ? program.text : JSON.stringify(program)), { level: 9 });
  return page + (alone ? MARK : WORK_MARK) + toBase64Url(packed);
}

/** What a link carries: a program as text or with what belongs to it, one that is larger than is opened, or nothing that can be read. */
export type Shared = { readonly kind: "text"; readonly text: string } | { readonly kind: "work"; readonly program: ProgramWork } | {
  readonly kind: "tooLarge" | "damaged";
};

/** The program of a link's part behind `#`. Never throws, and never unpacks more than it opens. */
export function sharedProgram(hash: string, most = LARGEST_PROGRAM): Shared {
  const mark = [MARK, WORK_MARK].find((each) => hash.startsWith(each));
  if (mark === undefined) return { kind: "damaged" };
  try {
    const text = unpackedText(fromBase64Url(hash.slice(mark.length)), most);
    if (text === null) return { kind: "tooLarge" };
    if (mark === MARK) return { kind: "text", text };
    const program = readProgram(JSON.parse(text));
    return program ? { kind: "work", program } : { kind: "damaged" };
  } catch {
    return { kind: "damaged" };
  }
}
