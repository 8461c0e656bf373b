import { readJson } from "../../program/files/bounded.ts";
import { deflateSync, strToU8 } from "fflate";
import { unpackedText } from "../base/unpack.ts";
import { fileNameOf } from "../base/file-name.ts";
import { LARGEST_PROGRAM } from "../base/limits.ts";
import { plainWork } from "./save-file.ts";
import type { Work } from "../document/work.ts";
import { LINK_DICTIONARY } from "./link-dictionary.ts";

/** Start of the hash, which names the link format. Newer formats have higher numbers. */
export const LINK_FORM = 2;
export const LINK_MARK = `#h${LINK_FORM}=`;
/** Forms of earlier editions: the text of a program alone, and a program with what belongs to it. */
const TEXT_MARK = "#p=";
const PROGRAM_MARK = "#w=";
const WORK_MARK = "#h1=";
/** Version of saved works in these formats. */
const EARLIER_VERSION = 2;

const toBase64Url = (bytes: Uint8Array): string => {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text)
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replace(/={1,2}$/, "");
};

const fromBase64Url = (text: string): Uint8Array =>
  Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));

/** Packs plain data for a link. */
export const packedForLink = (value: unknown, dictionary = LINK_DICTIONARY): string =>
  toBase64Url(deflateSync(strToU8(JSON.stringify(value)), { level: 9, dictionary }));

/** Unpacks the text of `packedForLink` with the same dictionary; null if longer than `most`. Throws if invalid. */
export const unpackedFromLink = (packed: string, most = LARGEST_PROGRAM, dictionary = LINK_DICTIONARY): string | null =>
  unpackedText(fromBase64Url(packed), most, dictionary);

/**
 * A link that contains a work with its tools and settings; nothing is stored anywhere. `page`: address without hash.
 */
export function linkOf(page: string, work: Work): string {
  // Normalised as on reading, so that a received work gives the same link again.
  return page + LINK_MARK + packedForLink({ work: plainWork(work) ?? work });
}

/** Content of a link, or why there is none: too large, from a newer edition, or unreadable. */
export type ReadLink =
  | { readonly kind: "work"; readonly work: Work }
  | { readonly kind: "tooLarge" | "newer" | "damaged" };

function workIn(mark: string, text: string): Work | null {
  if (mark === TEXT_MARK) return { name: fileNameOf(text), text, encoding: "utf-8" };
  const raw = readJson(text);
  if (mark === PROGRAM_MARK) return plainWork(raw, EARLIER_VERSION);
  const work = typeof raw === "object" && raw !== null && "work" in raw ? raw.work : null;
  return mark === WORK_MARK ? plainWork(work, EARLIER_VERSION) : plainWork(work);
}

/** Reads the work from the hash of a link. Never throws, and never unpacks more than `most`. */
export function readLink(hash: string, most = LARGEST_PROGRAM): ReadLink {
  const form = /^#h(\d+)=/.exec(hash)?.[1];
  if (form !== undefined && Number(form) > LINK_FORM) return { kind: "newer" };
  const mark = [TEXT_MARK, PROGRAM_MARK, WORK_MARK, LINK_MARK].find((each) => hash.startsWith(each));
  if (mark === undefined) return { kind: "damaged" };
  try {
    const text = unpackedText(
      fromBase64Url(hash.slice(mark.length)),
      most,
      mark === LINK_MARK || mark === WORK_MARK ? LINK_DICTIONARY : null,
    );
    if (text === null) return { kind: "tooLarge" };
    const work = workIn(mark, text);
    return work ? { kind: "work", work } : { kind: "damaged" };
  } catch {
    return { kind: "damaged" };
  }
}
