import { readBarCode, readHolderCode, type HolderCode } from "./holder-code.ts";
import { readInsertCode, type InsertCode } from "./insert-code.ts";
import { readMakerCode } from "./maker-code.ts";
import type { MakerCode } from "./maker-code-shape.ts";

/** Why a code is not read: a family of thread or grooving tools whose makers number their inserts. */
export type NotCovered = "thread" | "groove" | "unknown";

/** A typed tool code: an insert, a holder, both, or an unsupported code. */
export interface ToolCodes {
  readonly insert: InsertCode | null;
  readonly holder: HolderCode | null;
  readonly notCovered: NotCovered | null;
  /** A thread, groove or part-off tool by the designation of its makers. */
  readonly maker?: MakerCode;
}

const GAP = String.raw`[\s\-_/·]*`;
const THREAD = new RegExp(
  String.raw`^(?:\d{2}${GAP}[EI][RLN]|S[EI][RLN]${GAP}\d|[SACE]\d{2}[A-Z]${GAP}S?[EI][RLN]|[TL]T[EI]?[RLN]${GAP}\d)`,
);
const GROOVE = new RegExp(
  String.raw`^(?:M[GR][GM]N|MG[EI]?[HV][RLN]|MG[EI][HV]|[NRL]\d{3}|T?D[CGN]${GAP}\d|GX|LC[GM]|GTN|GFN|SP\d{3}|N151|[A-Z]?QD)`,
);
const BAR = /^[A-J S]\s*\d{2}\s*[A-Z]?(?:[\s\-_/·]*[A-Z]{0,5})/;
/** Five letters of a holder and four of an insert, followed by digits or nothing. */
const HOLDER = new RegExp(String.raw`^[CDMPSWX]${GAP}(?:[A-Z]${GAP}){4}(?:\d|$)`);
const INSERT = new RegExp(String.raw`^[A-Z](?:${GAP}[A-Z]){0,3}(?:${GAP}\d|${GAP}$)`);

const isBar = (text: string) => /^[A-JS]\s*\d{2}\s*(?:$|[A-Z])/.test(text) && BAR.test(text);
const isHolder = (text: string) => HOLDER.test(text);
const isInsert = (text: string) => INSERT.test(text);

function readOne(text: string): ToolCodes {
  const none = { insert: null, holder: null, notCovered: null };
  const maker = readMakerCode(text);
  if (maker) return { ...none, maker };
  if (THREAD.test(text)) return { ...none, notCovered: "thread" };
  if (GROOVE.test(text)) return { ...none, notCovered: "groove" };
  if (isBar(text)) return { ...none, holder: readBarCode(text) };
  if (isHolder(text)) return { ...none, holder: readHolderCode(text) };
  const insert = isInsert(text) ? readInsertCode(text) : null;
  return insert ? { ...none, insert } : { ...none, notCovered: "unknown" };
}

/** Characters of two codes with all that may stand between their parts. */
const LONGEST = 200;

/** Possible starts of a second code: after a space, a plus or a comma. */
const placesOfSecond = (text: string) =>
  [...text.matchAll(/(?<![\s+,;])[\s+,;]+(?=[A-Z])/g)].map((found) => [found.index, found[0].length] as const);

/**
 * Reads a typed code: of an insert, of a holder, or of both in either order, in any case, with any gaps. Never throws;
 * an empty text has neither.
 */
export function readToolCodes(typed: string): ToolCodes {
  const text = typed.trim().slice(0, LONGEST).toUpperCase();
  if (text === "") return { insert: null, holder: null, notCovered: null };
  const strong = (codes: ToolCodes) =>
    codes.notCovered === null && (codes.holder?.parts.length ?? codes.insert?.parts.length ?? 0) > 4;
  for (const [at, gap] of placesOfSecond(text)) {
    const [first, second] = [readOne(text.slice(0, at)), readOne(text.slice(at + gap))];
    if (!strong(first) || !strong(second) || (first.insert === null) === (second.insert === null)) continue;
    return { insert: first.insert ?? second.insert, holder: first.holder ?? second.holder, notCovered: null };
  }
  return readOne(text);
}
