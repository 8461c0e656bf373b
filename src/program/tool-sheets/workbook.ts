import { MOST_COLUMNS, MOST_LINES, sheetOf, type Sheet } from "./sheet.ts";

/*
 * The cells of a workbook as spreadsheets save it (Office Open XML, ECMA-376 part 1, 18.3 and 18.4): texts are shared by
 * all sheets, a cell has its place, its type and its value. Formulas count with the value that was saved.
 */

/** Text of a part of the file by its path; null where it is not there. */
export type PartOf = (path: string) => string | null;

interface Tag {
  readonly kind: "open" | "close" | "text";
  /** Name without its prefix; the text itself. */
  readonly name: string;
  readonly attributes: string;
  readonly isEmpty: boolean;
}

const TOKEN = /<(\/?)(?:[\w.-]+:)?([\w.-]+)((?:\s[^<>]*?)?)(\/?)>|<[^>]*>|([^<]+)/g;
const ENTITIES: Readonly<Record<string, string>> = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };

const plain = (text: string) =>
  text.replace(
    /&(?:#x([\da-fA-F]{1,6})|#(\d{1,7})|(\w{2,4}));/g,
    (whole, hex?: string, decimal?: string, name?: string) => {
      if (name !== undefined) return ENTITIES[name] ?? whole;
      const code = hex !== undefined ? parseInt(hex, 16) : Number(decimal);
      return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
    },
  );

function* tagsOf(xml: string): Generator<Tag> {
  for (const [, slash, name, attributes = "", empty, text] of xml.matchAll(TOKEN)) {
    if (text !== undefined) yield { kind: "text", name: plain(text), attributes: "", isEmpty: false };
    else if (name !== undefined)
      yield { kind: slash ? "close" : "open", name, attributes, isEmpty: !slash && empty === "/" };
  }
}

/** An attribute by its name, with or without a prefix. */
const attribute = ({ attributes }: Tag, name: string): string | null => {
  const found = new RegExp(`(?:^|[\\s:])${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`).exec(attributes);
  return found ? plain(found[1] ?? found[2] ?? "") : null;
};

/** Texts of the table of shared texts; readings of Asian scripts (rPh) are left out. */
function sharedTexts(xml: string): string[] {
  const out: string[] = [];
  let [inText, inReading] = [false, false];
  for (const tag of tagsOf(xml)) {
    const { kind, name } = tag;
    if (kind === "text") {
      if (inText && !inReading && out.length > 0) out.push(`${out.pop() ?? ""}${name}`);
    } else if (name === "si" && kind === "open") out.push("");
    else if (name === "t") inText = kind === "open" && !tag.isEmpty;
    else if (name === "rPh") inReading = kind === "open" && !tag.isEmpty;
  }
  return out;
}

/** Column of a place such as AB12, from 0; −1 for another text. */
function columnOf(place: string): number {
  const letters = /^([A-Z]{1,3})\d*$/.exec(place)?.[1] ?? "";
  return [...letters].reduce((sum, letter) => sum * 26 + letter.charCodeAt(0) - 64, 0) - 1;
}

/** A stored number as it is shown: binary fractions such as 0.80000000000000004 are rounded. */
const shown = (value: string): string => {
  const number = Number(value);
  return value.trim() !== "" && Number.isFinite(number) ? String(Number(number.toPrecision(12))) : value;
};

function cellsIn(xml: string, shared: readonly string[]): string[][] {
  const rows: string[][] = [];
  let [at, type, value, taking] = [-1, "n", "", false];
  for (const tag of tagsOf(xml)) {
    const { kind, name } = tag;
    if (kind === "text") {
      if (taking) value += name;
    } else if (name === "row" && kind === "open") {
      if (rows.length > MOST_LINES) break;
      rows.push([]);
    } else if (name === "c" && kind === "open") {
      const row = rows.at(-1) ?? [];
      const place = columnOf(attribute(tag, "r") ?? "");
      [at, type, value] = [place < 0 ? row.length : place, attribute(tag, "t") ?? "n", ""];
    } else if (name === "v" || name === "t") taking = kind === "open" && !tag.isEmpty;
    if (name !== "c" || !(kind === "close" || tag.isEmpty) || at < 0 || at >= MOST_COLUMNS) continue;
    const row = rows.at(-1);
    while (row && row.length < at) row.push("");
    if (row) row[at] = type === "s" ? (shared[Number(value)] ?? "") : type === "n" ? shown(value) : value;
  }
  return rows;
}

/** Paths of the sheets in the order of the workbook. */
function sheetPaths(part: PartOf): string[] {
  const targets = new Map<string, string>();
  for (const tag of tagsOf(part("xl/_rels/workbook.xml.rels") ?? ""))
    if (tag.name === "Relationship") targets.set(attribute(tag, "Id") ?? "", attribute(tag, "Target") ?? "");
  const ids = [...tagsOf(part("xl/workbook.xml") ?? "")]
    .filter(({ kind, name }) => kind === "open" && name === "sheet")
    .map((tag) => attribute(tag, "id") ?? "");
  const found = ids.flatMap((id) => targets.get(id) ?? []);
  return (found.length > 0 ? found : ["worksheets/sheet1.xml"]).map((target) =>
    target.startsWith("/") ? target.slice(1) : `xl/${target}`,
  );
}

/** The first sheet of a workbook that has titles and lines; null if none has. Never throws. */
export function sheetOfWorkbook(part: PartOf): Sheet | null {
  const shared = sharedTexts(part("xl/sharedStrings.xml") ?? "");
  for (const path of sheetPaths(part).slice(0, 20)) {
    const sheet = sheetOf(cellsIn(part(path) ?? "", shared));
    if (sheet) return sheet;
  }
  return null;
}
