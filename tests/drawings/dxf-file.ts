/** A group of a DXF file: code and value. */
export type Group = readonly [code: number, value: string | number];
/** Groups of an entity as "LINE 8 0 10 0 20 12": values without blanks. */
export type Entity = string;

export const groupsOf = (entity: Entity): Group[] => {
  const [type = "", ...rest] = entity.trim().split(/\s+/);
  return [[0, type], ...rest.flatMap((code, i): Group[] => (i % 2 === 0 ? [[Number(code), rest[i + 1] ?? ""]] : []))];
};

export interface Parts {
  /** Header variables: name, code and value. */
  readonly header?: readonly (readonly [name: string, code: number, value: string | number])[];
  readonly layers?: readonly Entity[];
  readonly linetypes?: readonly Entity[];
  /** Blocks: name and entities; the base point is the origin. */
  readonly blocks?: Readonly<Record<string, readonly Entity[]>>;
  readonly entities: readonly Entity[];
}

const section = (name: string, groups: readonly Group[]): Group[] =>
  groups.length === 0 ? [] : [[0, "SECTION"], [2, name], ...groups, [0, "ENDSEC"]];
const table = (name: string, entries: readonly Entity[]): Group[] =>
  entries.length === 0
    ? []
    : [[0, "TABLE"], [2, name], [70, entries.length], ...entries.flatMap(groupsOf), [0, "ENDTAB"]];

/** The groups of a whole file; sections without content are left out, as many programs do. */
export function dxfGroups({ header = [], layers = [], linetypes = [], blocks = {}, entities }: Parts): Group[] {
  return [
    ...section(
      "HEADER",
      header.flatMap(([name, code, value]): Group[] => [
        [9, name],
        [code, value],
      ]),
    ),
    ...section("TABLES", [...table("LTYPE", linetypes), ...table("LAYER", layers)]),
    ...section(
      "BLOCKS",
      Object.entries(blocks).flatMap(([name, inner]): Group[] => [
        [0, "BLOCK"],
        [8, "0"],
        [2, name],
        [70, 0],
        [10, 0],
        [20, 0],
        [30, 0],
        ...inner.flatMap(groupsOf),
        [0, "ENDBLK"],
      ]),
    ),
    [0, "SECTION"],
    [2, "ENTITIES"],
    ...entities.flatMap(groupsOf),
    [0, "ENDSEC"],
    [0, "EOF"],
  ];
}

export const MM: NonNullable<Parts["header"]> = [["$INSUNITS", 70, 4]];

export const asText = (groups: readonly Group[], newLine = "\n"): string =>
  groups.map(([code, value]) => `${String(code).padStart(3)}${newLine}${value}${newLine}`).join("");

export const utf8 = (text: string): Uint8Array => new TextEncoder().encode(text);
/** Text of one byte a character, for files of older programs. */
export const bytesOf = (text: string): Uint8Array => Uint8Array.from(text, (c) => c.charCodeAt(0));

const isReal = (code: number) => (code >= 10 && code <= 59) || (code >= 210 && code <= 239);
const isShort = (code: number) => (code >= 60 && code <= 79) || (code >= 370 && code <= 389);
const isLong = (code: number) => code >= 90 && code <= 99;

/** A binary file; files before release 13 have codes of one byte. */
export function asBinary(groups: readonly Group[], shortCodes = false): Uint8Array {
  const out: number[] = [...bytesOf("AutoCAD Binary DXF\r\n\u001a\0")];
  const push = (size: number, write: (view: DataView) => void) => {
    const buffer = new ArrayBuffer(size);
    write(new DataView(buffer));
    out.push(...new Uint8Array(buffer));
  };
  for (const [code, value] of groups) {
    if (shortCodes) out.push(code);
    else push(2, (v) => v.setInt16(0, code, true));
    if (isReal(code)) push(8, (v) => v.setFloat64(0, Number(value), true));
    else if (isShort(code)) push(2, (v) => v.setInt16(0, Number(value), true));
    else if (isLong(code)) push(4, (v) => v.setInt32(0, Number(value), true));
    else out.push(...bytesOf(String(value)), 0);
  }
  return Uint8Array.from(out);
}

export const line = (x1: number, y1: number, x2: number, y2: number, more = "8 0"): Entity =>
  `LINE ${more} 10 ${x1} 20 ${y1} 11 ${x2} 21 ${y2}`;
export const arc = (x: number, y: number, r: number, from: number, to: number, more = "8 0"): Entity =>
  `ARC ${more} 10 ${x} 20 ${y} 40 ${r} 50 ${from} 51 ${to}`;
export const polyline = (closed: boolean, points: readonly (readonly number[])[], more = "8 0"): Entity =>
  `LWPOLYLINE ${more} 90 ${points.length} 70 ${closed ? 1 : 0} ${points
    .map(([x, y, bulge]) => `10 ${x} 20 ${y}${bulge === undefined ? "" : ` 42 ${bulge}`}`)
    .join(" ")}`;
