/** JSON data; a field that is `undefined` counts as missing. */
export type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };

/** Difference between two values: none, a replacement, or a change of text, fields or elements. */
export type Difference =
  | 0
  | { readonly to: Json }
  /** Unchanged characters at start and end, and the new text between. */
  | { readonly text: readonly [number, number, string] }
  | { readonly fields: { readonly [key: string]: Difference }; readonly without?: readonly string[] }
  /** Unchanged elements at start and end, and the new ones between. */
  | { readonly list: readonly [number, number, readonly Json[]] }
  | { readonly each: { readonly [index: string]: Difference } };

const isList = (value: Json): value is readonly Json[] => Array.isArray(value);
const isObject = (value: Json): value is { readonly [key: string]: Json } =>
  typeof value === "object" && value !== null && !isList(value);

/** Length of the common start and the common end of two lists, without overlap. */
function common(
  a: ArrayLike<unknown>,
  b: ArrayLike<unknown>,
  same: (i: number, j: number) => boolean,
): readonly [number, number] {
  const most = Math.min(a.length, b.length);
  let start = 0;
  while (start < most && same(start, start)) start++;
  let end = 0;
  while (end < most - start && same(a.length - 1 - end, b.length - 1 - end)) end++;
  return [start, end];
}

/** Characters that are compared at once: the engine compares whole pieces far faster than one by one. */
const PIECE = 4096;

/** The same of two texts. */
function commonText(a: string, b: string): readonly [number, number] {
  const most = Math.min(a.length, b.length);
  let start = 0;
  while (start + PIECE <= most && a.slice(start, start + PIECE) === b.slice(start, start + PIECE)) start += PIECE;
  while (start < most && a.charCodeAt(start) === b.charCodeAt(start)) start++;
  const tail = (of: string, end: number) => of.slice(of.length - end - PIECE, of.length - end);
  let end = 0;
  while (end + PIECE <= most - start && tail(a, end) === tail(b, end)) end += PIECE;
  while (end < most - start && a.charCodeAt(a.length - 1 - end) === b.charCodeAt(b.length - 1 - end)) end++;
  return [start, end];
}

function betweenObjects(a: { readonly [key: string]: Json }, b: { readonly [key: string]: Json }): Difference {
  const fields: [string, Difference][] = [];
  for (const [key, value] of Object.entries(b)) {
    if (value === undefined) continue;
    const before = Object.hasOwn(a, key) ? a[key] : undefined;
    const found = before === undefined ? { to: value } : differenceOf(before, value);
    if (found !== 0) fields.push([key, found]);
  }
  const without = Object.keys(a).filter(
    (key) => a[key] !== undefined && (!Object.hasOwn(b, key) || b[key] === undefined),
  );
  if (fields.length === 0 && without.length === 0) return 0;
  return { fields: Object.fromEntries(fields), ...(without.length > 0 && { without }) };
}

function betweenLists(a: readonly Json[], b: readonly Json[]): Difference {
  const found = a.length === b.length ? a.map((value, i) => differenceOf(value, b[i] as Json)) : null;
  if (found) {
    const each = found.flatMap((one, i) => (one === 0 ? [] : [[String(i), one] as const]));
    return each.length === 0 ? 0 : { each: Object.fromEntries(each) };
  }
  const [start, end] = common(a, b, (i, j) => differenceOf(a[i] as Json, b[j] as Json) === 0);
  return { list: [start, end, b.slice(start, b.length - end)] };
}

/** Difference between two values. Identical objects are not compared further. */
export function differenceOf(a: Json, b: Json): Difference {
  if (a === b) return 0;
  if (typeof a === "string" && typeof b === "string") {
    const [start, end] = commonText(a, b);
    return { text: [start, end, b.slice(start, b.length - end)] };
  }
  if (isList(a) && isList(b)) return betweenLists(a, b);
  return isObject(a) && isObject(b) ? betweenObjects(a, b) : { to: b };
}

const ownOf = (fields: { readonly [key: string]: Difference }, key: string): Difference =>
  (Object.hasOwn(fields, key) && fields[key]) || 0;

/** Applies a difference. Unchanged parts keep their identity. */
export function withDifference(a: Json, by: Difference): Json {
  if (by === 0) return a;
  if ("to" in by) return by.to;
  if ("text" in by && typeof a === "string")
    return a.slice(0, by.text[0]) + by.text[2] + a.slice(a.length - by.text[1]);
  if ("list" in by && isList(a)) return [...a.slice(0, by.list[0]), ...by.list[2], ...a.slice(a.length - by.list[1])];
  if ("each" in by && isList(a)) return a.map((value, i) => withDifference(value, by.each[i] ?? 0));
  if (!("fields" in by) || !isObject(a)) throw new Error("the difference is one of another value");
  const kept = Object.entries(a)
    .filter(([key]) => !by.without?.includes(key))
    .map(([key, value]) => [key, withDifference(value, ownOf(by.fields, key))]);
  const fresh = Object.entries(by.fields)
    .filter(([key]) => !Object.hasOwn(a, key) || a[key] === undefined)
    .flatMap(([key, found]) => (found !== 0 && "to" in found ? [[key, found.to]] : []));
  return Object.fromEntries([...kept, ...fresh]) as Json;
}

/** JSON replacer that sorts fields, so that equal values give equal text. */
const inOrder = (_: string, value: unknown): unknown =>
  typeof value === "object" && value !== null && !Array.isArray(value)
    ? Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)))
    : value;

/** Short hash of a value; different values practically never share one. */
export function fingerprint(value: unknown): string {
  const text = JSON.stringify(value, inOrder) ?? "";
  let [a, b] = [0xdeadbeef, 0x41c6ce57];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    a = Math.imul(a ^ code, 2654435761);
    b = Math.imul(b ^ code, 1597334677);
  }
  return `${text.length} ${(a >>> 0).toString(36)} ${(b >>> 0).toString(36)}`;
}
