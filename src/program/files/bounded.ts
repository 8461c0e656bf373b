import { z } from "zod/mini";

/*
 * Everything that the page did not write a moment ago (records of the device, links, archives, files) is read within
 * these bounds: a text is measured before it is parsed, and a number that no device writes is no number.
 */

/** Bounds of a JSON text: characters, nesting, values, and characters of a name (messages repeat names). */
export interface JsonBounds {
  readonly length: number;
  readonly depth: number;
  readonly values: number;
  readonly name: number;
}

/** The largest backup has a tenth of these values; the deepest file that anybody writes has a tenth of this depth. */
export const JSON_BOUNDS: JsonBounds = { length: 200_000_000, depth: 100, values: 8_000_000, name: 1000 };

const QUOTE = 0x22;
const BACKSLASH = 0x5c;
const COLON = 0x3a;
const [COMMA, LIST, LIST_END, OBJECT, OBJECT_END] = [0x2c, 0x5b, 0x5d, 0x7b, 0x7d];

/**
 * Measures a JSON text that arrives in pieces: false as soon as it leaves the bounds. It allocates nothing, so that a
 * text which unpacks to millions of brackets is refused at the first hundred.
 */
export function jsonGauge({ length, depth, values, name }: JsonBounds = JSON_BOUNDS): (piece: string) => boolean {
  let [characters, level, count, text] = [0, 0, 0, 0];
  let inText = false;
  let isEscaped = false;
  return (piece) => {
    characters += piece.length;
    if (characters > length) return false;
    for (let at = 0; at < piece.length; at++) {
      const code = piece.charCodeAt(at);
      if (inText) text += 1;
      if (isEscaped) isEscaped = false;
      else if (code === QUOTE) {
        inText = !inText;
        if (inText) text = -1;
      } else if (inText) isEscaped = code === BACKSLASH;
      else if (code === COLON) {
        if (text > name) return false;
      } else if (code === COMMA) count += 1;
      else if (code === LIST || code === OBJECT) {
        level += 1;
        count += 1;
      } else if (code === LIST_END || code === OBJECT_END) level -= 1;
      if (level > depth || count > values) return false;
    }
    return true;
  };
}

/**
 * The value of a JSON text, with or without a byte order mark. Throws a SyntaxError on other text, a RangeError on one
 * beyond the bounds.
 */
export function readJson(text: string, bounds: JsonBounds = JSON_BOUNDS): unknown {
  if (!jsonGauge(bounds)(text)) throw new RangeError("the data are larger or deeper than any that are used");
  return JSON.parse(text.replace(/^\uFEFF/, ""));
}

/** Range of times, ms since 1970: years 1 to 9999, which every calendar and every format of dates can write. */
const TIMES = { first: -62_135_510_400_000, last: 253_402_128_000_000 };

/** A time, ms since 1970. */
export const moment = z.number().check(z.gte(TIMES.first), z.lte(TIMES.last));

/** A duration or a size that was counted here. */
export const amount = z.number().check(z.gte(0), z.lte(Number.MAX_SAFE_INTEGER));

/** A measured or typed number: coordinates, widths, scores. */
export const measure = z.number().check(z.gte(-1e9), z.lte(1e9));

/** An index, or the number of a tool or a cycle. */
export const whole = z.int().check(z.gte(-1_000_000_000), z.lte(1_000_000_000));

const isRecord = (raw: unknown): raw is Readonly<Record<string, unknown>> =>
  typeof raw === "object" && raw !== null && !Array.isArray(raw);

/** Longest text of a cell, characters: as read, stored and shown. */
export const LONGEST_CELL = 500;

/** A text that a list shows, cut where no such text is longer. */
export const cellText = (text: string): string =>
  text.length > LONGEST_CELL ? `${text.slice(0, LONGEST_CELL - 1)}…` : text;

/** A row that did not pass, with the name it goes by, as far as it has one. */
export interface UnreadRow {
  readonly name: string;
  readonly raw: unknown;
}

const NAMED = z.object({ name: z.string().check(z.minLength(1)) });
const NAMES = ["name", "file", "title", "id"] as const;

/** The name of a row in data that may be anything. */
function nameOfRow(raw: unknown, otherwise: string): string {
  const names = NAMES.map((name) => NAMED.safeParse({ name: isRecord(raw) ? raw[name] : null }).data?.name);
  return (names.find((name) => name !== undefined) ?? otherwise).slice(0, 100);
}

/**
 * Data without the rows of one of their lists that do not pass, so that one row never costs the list. A list is an array,
 * in which an id stands once, or an object by name; rows beyond the first `most` that pass are unread as well.
 */
export function sieved(
  raw: unknown,
  list: string,
  row: z.ZodMiniType<unknown>,
  most = Infinity,
): { readonly raw: unknown; readonly unread: readonly UnreadRow[] } {
  const rows = isRecord(raw) ? raw[list] : undefined;
  if (!isRecord(raw) || typeof rows !== "object" || rows === null) return { raw, unread: [] };
  const ids = new Set<unknown>();
  const unread: UnreadRow[] = [];
  let left = most;
  const good = Object.entries(rows).filter(([key, each]: [string, unknown]) => {
    const id = Array.isArray(rows) && isRecord(each) ? each["id"] : undefined;
    const passes = left > 0 && !ids.has(id) && row.safeParse(each).success;
    if (id !== undefined) ids.add(id);
    if (passes) left -= 1;
    else unread.push({ name: nameOfRow(each, key), raw: each });
    return passes;
  });
  if (unread.length === 0) return { raw, unread };
  const kept = Array.isArray(rows) ? good.map(([, each]: [string, unknown]) => each) : Object.fromEntries(good);
  return { raw: { ...raw, [list]: kept }, unread };
}
