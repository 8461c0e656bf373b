import {
  PropertyReader,
  type Facts,
  type FileProperties,
  type FileTool,
  type FileToolKind,
  type RefusalReason,
  type RefusedItem,
  type Vocabulary,
} from "./facts.ts";
import { isRecord, jsonOf, MOST_ITEMS, type ForeignContent, type ReadingContext } from "./foreign-file.ts";

/*
 * FreeCAD: a bit (.fctb) is one tool with its parameters and their units, a library (.fctl) numbers bits by their path.
 * Sources: docs/decisions, tool files of other systems.
 */

type Json = Readonly<Record<string, unknown>>;

/** Kinds by the type of a shape, or by the file of the shape in older bits. */
const SHAPES: Readonly<Record<string, FileToolKind | RefusalReason>> = {
  isoshape: "turning",
  drill: "drill",
  tap: "tap",
  reamer: "reamer",
  endmill: "mill",
  ballend: "mill",
  bullnose: "mill",
  chamfer: "mill",
  dovetail: "mill",
  radius: "mill",
  fillet: "mill",
  slittingsaw: "mill",
  taperedballnose: "mill",
  threadmill: "mill",
  vbit: "mill",
  probe: "probe",
};
const shapeName = (text: string): string => text.toLowerCase().replace(/\.fcstd$|[^a-z]/g, "");
const kindOf = (shape: string): FileToolKind | RefusalReason =>
  SHAPES[shape] ?? (shape.startsWith("isoshape") ? "turning" : "noColumn");

const VOCABULARY: Readonly<Record<string, Vocabulary>> = {
  turning: { nose: ["TipRadius"], point: ["TipAngle"], edge: ["EdgeLength"] },
  drill: { cutter: ["Diameter"], drillPoint: ["TipAngle"], flute: ["CuttingEdgeLength"] },
  reamer: { cutter: ["Diameter"], flute: ["CuttingEdgeLength"] },
  tap: { cutter: ["Diameter"], pitch: ["Pitch"], flute: ["CuttingEdgeLength"] },
  mill: { cutter: ["Diameter"] },
};
const IDLE = ["Flutes", "Length", "ShankDiameter", "Material", "Chipload", "SpindleDirection"];

const textOf = (value: unknown) => (typeof value === "string" ? value.slice(0, 200) : "");

const isBit = (json: unknown): json is Json =>
  isRecord(json) && isRecord(json["parameter"]) && typeof json["shape"] === "string";

interface ReadBit {
  readonly item: FileTool | RefusedItem;
  readonly unitAsked: boolean;
}

function bitOf(bit: Json, number: Facts["number"], unit: ReadingContext["unit"]): ReadBit {
  const label = textOf(bit["name"]) || textOf(bit["label"]) || textOf(bit["shape"]);
  const named = textOf(bit["shape-type"]) || textOf(bit["shape"]);
  const kind = kindOf(shapeName(named));
  const vocabulary = VOCABULARY[kind];
  if (!vocabulary) return { item: { label, why: kind as RefusalReason, kind: named }, unitAsked: false };
  const properties: FileProperties = new Map(
    Object.entries(bit["parameter"] as Json).flatMap(([name, value]) =>
      typeof value === "string" || typeof value === "number" ? [[name, { value }] as const] : [],
    ),
  );
  const reader = new PropertyReader(properties, unit);
  const sizes = reader.sizes(vocabulary);
  reader.pass(...IDLE);
  const facts: Facts = {
    ...(number && { number }),
    name: { value: label, from: label },
    kind: { value: kind as FileToolKind, from: named },
    ...sizes,
  };
  return { item: { label, facts, texts: [label], unused: reader.unused }, unitAsked: reader.unitAsked };
}

interface Place {
  readonly nr: number;
  readonly path: string;
}
const placesOf = (json: unknown): readonly Place[] | null => {
  const list = isRecord(json) ? json["tools"] : null;
  const places = Array.isArray(list) ? (list as readonly unknown[]).slice(0, MOST_ITEMS) : [];
  const isPlace = (place: unknown): place is Place =>
    isRecord(place) && typeof place["nr"] === "number" && typeof place["path"] === "string";
  return places.length > 0 && places.every(isPlace) ? places : null;
};

/** Reads a bit or a library of FreeCAD, whose bits are among the other files; null when the text is none. */
export function readFreeCad(text: string, { unit, sibling }: ReadingContext): ForeignContent | null {
  const json = jsonOf(text);
  const places = placesOf(json);
  const bits: readonly ReadBit[] = isBit(json)
    ? [bitOf(json, undefined, unit)]
    : (places ?? []).map(({ nr, path }): ReadBit => {
        const found = jsonOf(sibling(path) ?? "");
        if (isBit(found)) return bitOf(found, { value: nr, from: `nr ${nr}` }, unit);
        return { item: { label: `T${nr}`, why: "fileMissing", kind: path.slice(0, 200) }, unitAsked: false };
      });
  if (bits.length === 0) return null;
  const items = bits.map((bit) => bit.item);
  return {
    tools: items.filter((item): item is FileTool => "facts" in item),
    refused: items.filter((item): item is RefusedItem => !("facts" in item)),
    unitAsked: bits.some((bit) => bit.unitAsked),
  };
}
