import { deflateSync, strToU8 } from "fflate";
import { unpackedText } from "../base/unpack.ts";
import { fileNameOf } from "../base/file-name.ts";
import { LARGEST_PROGRAM } from "../base/limits.ts";
import { plainWork } from "./save-file.ts";
import type { Work } from "../document/work.ts";
import { COMMON } from "./words-of-links.ts";

/** What stands between the page's address and the work: the form of the link. Newer forms have higher numbers. */
export const LINK_FORM = 2;
export const LINK_MARK = `#h${LINK_FORM}=`;
/** Forms of earlier editions: the text of a program alone, and a program with what belongs to it. */
const TEXT_MARK = "#p=";
const PROGRAM_MARK = "#w=";
const WORK_MARK = "#h1=";
/** Version of saved works at the time of these. */
const EARLIER_VERSION = 2;

const toBase64Url = (bytes: Uint8Array): string => {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
};

const fromBase64Url = (text: string): Uint8Array =>
  Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));

/** Plain data as the end of a link. */
export const packedForLink = (value: unknown): string =>
  toBase64Url(deflateSync(strToU8(JSON.stringify(value)), { level: 9, mem: 12, dictionary: COMMON }));

/** The text that `packedForLink` packed; null where it is longer than `most`. Throws where it is none. */
export const unpackedFromLink = (packed: string, most = LARGEST_PROGRAM): string | null =>
  unpackedText(fromBase64Url(packed), most, COMMON);

/**
 * A link that carries a work with all that it brings along: nothing is stored anywhere. `page` is the address without
 * anything behind `#`.
 */
export function linkOf(page: string, work: Work): string {
  // As it is read, so that the link of what a link brought is the same link.
  return page + LINK_MARK + packedForLink({ work: plainWork(work) ?? work });
}

/** What a link carries; or that it carries more than is opened, comes from a newer edition, or can not be read. */
export type ReadLink =
  { readonly kind: "work"; readonly work: Work } | { readonly kind: "tooLarge" | "newer" | "damaged" };

function workIn(mark: string, text: string): Work | null {
  if (mark === TEXT_MARK) return { name: fileNameOf(text), text, encoding: "utf-8" };
  const raw: unknown = JSON.parse(text);
  if (mark === PROGRAM_MARK) return plainWork(raw, EARLIER_VERSION);
  const work = typeof raw === "object" && raw !== null && "work" in raw ? raw.work : null;
  return mark === WORK_MARK ? plainWork(work, EARLIER_VERSION) : plainWork(work);
}

/** The work of a link's part behind `#`. Never throws, and never unpacks more than it opens. */
export function readLink(hash: string, most = LARGEST_PROGRAM): ReadLink {
  const form = /^#h(\d+)=/.exec(hash)?.[1];
  if (form !== undefined && Number(form) > LINK_FORM) return { kind: "newer" };
  const mark = [TEXT_MARK, PROGRAM_MARK, WORK_MARK, LINK_MARK].find((each) => hash.startsWith(each));
  if (mark === undefined) return { kind: "damaged" };
  try {
    const text = unpackedText(
      fromBase64Url(hash.slice(mark.length)),
      most,
      mark === LINK_MARK || mark === WORK_MARK ? COMMON : null,
    );
    if (text === null) return { kind: "tooLarge" };
    const work = workIn(mark, text);
    return work ? { kind: "work", work } : { kind: "damaged" };
  } catch {
    return { kind: "damaged" };
  }
}
