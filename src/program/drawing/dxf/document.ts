import { numberOf, type Tag } from "./tags.ts";

/** An entity, or a record of a table: its groups in the order of the file. */
export interface DxfRecord {
  readonly type: string;
  readonly tags: readonly Tag[];
  /** VERTEX of a POLYLINE. */
  readonly parts: readonly DxfRecord[];
}

export interface DxfBlock {
  readonly name: string;
  readonly head: DxfRecord;
  readonly entities: readonly DxfRecord[];
}

/** Sections of a DXF file, as far as contours need them. */
export interface DxfDocument {
  readonly header: ReadonlyMap<string, readonly Tag[]>;
  readonly layers: ReadonlyMap<string, DxfRecord>;
  readonly linetypes: ReadonlyMap<string, DxfRecord>;
  readonly blocks: ReadonlyMap<string, DxfBlock>;
  readonly entities: readonly DxfRecord[];
  /** The file ends with EOF. */
  readonly complete: boolean;
  /** More entities than are read. */
  readonly tooMany: boolean;
}

/** Kinds whose groups are read; of all others only the space and the layer are kept. */
const READ = new Set([
  ..."LINE ARC CIRCLE ELLIPSE SPLINE HELIX LWPOLYLINE POLYLINE VERTEX SEQEND INSERT TEXT MTEXT DIMENSION".split(" "),
  ..."ARC_DIMENSION LARGE_RADIAL_DIMENSION LEADER MULTILEADER TOLERANCE".split(" "),
  ..."BLOCK LAYER LTYPE".split(" "),
]);
/** Groups of any entity: layer, linetype, invisible, space. */
const COMMON = new Set([6, 8, 60, 67]);
/** Most entities of a file, and most groups of an entity. */
const MOST_ENTITIES = 200_000;
const MOST_TAGS = 200_000;

/** Name of a table entry for comparison: CAD ignores case. */
export const keyOf = (name: string): string => name.trim().toUpperCase();
export const tagAt = (r: DxfRecord, code: number): string | undefined => r.tags.find((t) => t.code === code)?.text;
export const realAt = (r: DxfRecord, code: number): number | null => numberOf(tagAt(r, code));
export const flagsAt = (r: DxfRecord, code: number): number => Math.trunc(realAt(r, code) ?? 0);
export const wordAt = (r: DxfRecord, code: number): string => (tagAt(r, code) ?? "").trim();

interface Growing {
  type: string;
  tags: Tag[];
  parts: Growing[];
}

/** Sorts the groups of a file into its sections. A file that breaks off is read as far as it goes. */
export function readDocument(tags: Iterable<Tag>): DxfDocument {
  const header = new Map<string, Tag[]>(),
    layers = new Map<string, DxfRecord>(),
    linetypes = new Map<string, DxfRecord>(),
    blocks = new Map<string, { name: string; head: Growing; entities: Growing[] }>();
  const entities: Growing[] = [];
  let section: string | null = "",
    variable: Tag[] | null = null,
    record: Growing | null = null,
    block: { name: string; head: Growing; entities: Growing[] } | null = null,
    polyline: Growing | null = null,
    inApplication = false,
    complete = false,
    count = 0;
  const finished = () => {
    if (!record) return;
    if (record.type === "LAYER") layers.set(keyOf(wordAt(record, 2)), record);
    if (record.type === "LTYPE") linetypes.set(keyOf(wordAt(record, 2)), record);
    if (record.type === "BLOCK" && block) {
      block.name = wordAt(record, 2);
      blocks.set(keyOf(block.name), block);
    }
  };
  const begin = (type: string) => {
    finished();
    record = { type, tags: [], parts: [] };
    if (section === "TABLES") return;
    if (type === "BLOCK") block = { name: "", head: record, entities: [] };
    else if (type === "ENDBLK") block = null;
    else if (type === "VERTEX") polyline?.parts.push(record);
    else if (type === "SEQEND") polyline = null;
    else if (type !== "ATTRIB") {
      polyline = type === "POLYLINE" ? record : null;
      count += 1;
      if (count <= MOST_ENTITIES) (block ? block.entities : entities).push(record);
    }
  };
  for (const tag of tags) {
    const { code, text } = tag;
    if (code === 0) {
      const type = text.trim().toUpperCase();
      if (type === "EOF") {
        complete = true;
        break;
      }
      if (type === "SECTION" || type === "ENDSEC") {
        finished();
        record = block = polyline = variable = null;
        section = type === "SECTION" ? null : "";
      } else if (section === "ENTITIES" || section === "BLOCKS" || section === "TABLES") begin(type);
    } else if (section === null) {
      if (code === 2) section = text.trim().toUpperCase();
    } else if (section === "HEADER") {
      if (code === 9) header.set(text.trim().toUpperCase(), (variable = []));
      else variable?.push(tag);
    } else if (record) {
      const growing: Growing = record;
      // Groups between { and } (102) belong to applications; an embedded object (101) has groups of its own to the end.
      if (code === 102 || code === 101) inApplication = code === 101 || text.trim().startsWith("{");
      const isKept = (READ.has(growing.type) && code < 1000) || COMMON.has(code);
      if (isKept && !inApplication && growing.tags.length < MOST_TAGS) growing.tags.push(tag);
    }
    if (code === 0) inApplication = false;
  }
  finished();
  return { header, layers, linetypes, blocks, entities, complete, tooMany: count > MOST_ENTITIES };
}
