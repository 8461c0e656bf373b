import { radians } from "../../../kernel/units.ts";
import type { LineRole } from "../drawing.ts";
import { roleOfName, roleOfPattern } from "../roles.ts";
import {
  after,
  objectPlacing,
  placed,
  placedCurve,
  shift,
  spin,
  stretch,
  times,
  UNPLACED,
  type Curve3,
  type Placing,
  type V3,
} from "../space.ts";
import { flagsAt, keyOf, wordAt, realAt, type DxfDocument, type DxfRecord } from "./document.ts";
import { curvesOf, normalOf, pointAt } from "./entities.ts";
import { hintOf } from "./texts.ts";

/** Deepest nesting of blocks, and most entities after all blocks are inserted. */
const DEEPEST = 24,
  MOST_PLACED = 60_000,
  MOST_CELLS = 10_000;
/** Flags of a layer (70) and a block (70). */
const FROZEN = 1,
  EXTERNAL = 4;

/** A curve where it stands in the world, with what its entity says of it. */
export interface PlacedCurve {
  readonly curve: Curve3;
  readonly layer: string;
  readonly kind: string;
  readonly role: LineRole;
  /** Lineweight in hundredths of a millimetre; null where none is stated. */
  readonly weight: number | null;
}

export interface PlacedText {
  readonly text: string;
  readonly at: V3;
}

/** Everything a space of a drawing shows, and what it does not. */
export interface Expanded {
  readonly curves: PlacedCurve[];
  readonly texts: PlacedText[];
  readonly hiddenLayers: Map<string, number>;
  readonly skipped: Map<string, number>;
  readonly missing: Set<string>;
  readonly recursive: Set<string>;
  invisible: number;
  broken: number;
  /** Entities of the other space. */
  elsewhere: number;
  isFull: boolean;
}

/** What an entity takes from the insert of its block. */
interface Context {
  readonly placing: Placing;
  readonly layer: string | null;
  readonly linetype: string;
  readonly weight: number | null;
  readonly path: readonly string[];
}

/** Entities that show nothing a contour needs. */
const SILENT = new Set(["ATTDEF", "VIEWPORT", "SEQEND", "POINT", "ACAD_PROXY_ENTITY", "SUN", "LIGHT"]);
const count = (of: Map<string, number>, key: string) => of.set(key, (of.get(key) ?? 0) + 1);

/** Whether layers hide entities: frozen ones hide also the inserts on them. */
function visibilityOf(doc: DxfDocument, layer: string) {
  const found = doc.layers.get(keyOf(layer));
  if (!found) return "shown";
  if (flagsAt(found, 70) & FROZEN) return "frozen";
  return (realAt(found, 62) ?? 7) < 0 ? "off" : "shown";
}

const byBlock = (name: string) => keyOf(name) === "BYBLOCK";
const byLayer = (name: string) => name === "" || keyOf(name) === "BYLAYER";

function roleOf(doc: DxfDocument, linetype: string, layer: string): LineRole {
  const named = byLayer(linetype) ? wordAt(doc.layers.get(keyOf(layer)) ?? NO_RECORD, 6) : linetype;
  const pattern = doc.linetypes.get(keyOf(named));
  const byPattern = pattern ? roleOfPattern(flagsAt(pattern, 73)) : "outline";
  const byLinetype = byPattern === "outline" && !pattern ? roleOfName(named) : byPattern;
  return byLinetype === "outline" ? roleOfName(layer) : byLinetype;
}
const NO_RECORD: DxfRecord = { type: "", tags: [], parts: [] };

/** A lineweight: −1 by layer, −2 by block, −3 default (no statement). */
function weightOf(doc: DxfDocument, r: DxfRecord, layer: string, context: Context): number | null {
  const own = realAt(r, 370) ?? -1;
  if (own === -2) return context.weight;
  const weight = own === -1 ? (realAt(doc.layers.get(keyOf(layer)) ?? NO_RECORD, 370) ?? -3) : own;
  return weight > 0 ? weight : null;
}

/** Placings of the cells of an insert: mirrored and scaled by its factors, rotated, repeated in rows and columns. */
function cellsOf(r: DxfRecord, base: V3): Placing[] {
  const at = pointAt(r, 10) ?? [0, 0, 0],
    factor = (code: number) => realAt(r, code) ?? 1;
  const [columns, rows] = [Math.max(1, flagsAt(r, 70) || 1), Math.max(1, flagsAt(r, 71) || 1)],
    [dx, dy] = [realAt(r, 44) ?? 0, realAt(r, 45) ?? 0];
  const frame = after(after(objectPlacing(normalOf(r)) ?? UNPLACED, shift(at)), spin(radians(realAt(r, 50) ?? 0))),
    inner = after(stretch(factor(41), factor(42), factor(43)), shift(times(base, -1)));
  const number = Math.min(columns * rows, MOST_CELLS);
  return Array.from({ length: number }, (_, i) => {
    const cell: V3 = [(i % columns) * dx, Math.floor(i / columns) * dy, 0];
    return after(after(frame, shift(cell)), inner);
  });
}

/** Expands the entities of model or paper space: blocks inserted, hidden things counted. */
export function expanded(doc: DxfDocument, space: "model" | "paper"): Expanded {
  const out: Expanded = {
    curves: [],
    texts: [],
    hiddenLayers: new Map(),
    skipped: new Map(),
    missing: new Set(),
    recursive: new Set(),
    invisible: 0,
    broken: 0,
    elsewhere: 0,
    isFull: false,
  };
  let budget = MOST_PLACED;

  function insert(r: DxfRecord, layer: string, context: Context): void {
    const name = wordAt(r, 2),
      block = doc.blocks.get(keyOf(name));
    if (!block || (flagsAt(block.head, 70) & EXTERNAL && block.entities.length === 0))
      return void out.missing.add(name);
    const path = [...context.path, keyOf(name)];
    if (context.path.includes(keyOf(name)) || path.length > DEEPEST) return void out.recursive.add(name);
    const linetype = wordAt(r, 6);
    const inner = {
      layer,
      linetype: byBlock(linetype) ? context.linetype : byLayer(linetype) ? layerLinetype(layer) : linetype,
      weight: weightOf(doc, r, layer, context),
      path,
    };
    for (const cell of cellsOf(r, pointAt(block.head, 10) ?? [0, 0, 0])) {
      const placing = after(context.placing, cell);
      for (const e of block.entities) {
        if (out.isFull) return;
        show(e, { ...inner, placing });
      }
    }
  }
  const layerLinetype = (layer: string) => wordAt(doc.layers.get(keyOf(layer)) ?? NO_RECORD, 6);

  function show(r: DxfRecord, context: Context): void {
    if (budget <= 0) {
      out.isFull = true;
      return;
    }
    budget -= 1;
    const own = wordAt(r, 8) || "0",
      layer = own === "0" && context.layer !== null ? context.layer : own;
    if (flagsAt(r, 60) === 1) {
      out.invisible += 1;
      return;
    }
    const visibility = visibilityOf(doc, layer);
    if (visibility === "frozen" || (visibility === "off" && r.type !== "INSERT")) {
      count(out.hiddenLayers, layer);
      return;
    }
    if (r.type === "INSERT") return insert(r, layer, context);
    const text = hintOf(r);
    if (text !== undefined) {
      if (text) out.texts.push({ text: text.text, at: placed(context.placing, text.at) });
      return;
    }
    const made = curvesOf(r);
    if (made === undefined) {
      if (!SILENT.has(r.type)) count(out.skipped, r.type);
      return;
    }
    if (made === null) {
      out.broken += 1;
      return;
    }
    const linetype = byBlock(wordAt(r, 6)) ? context.linetype : wordAt(r, 6),
      role = roleOf(doc, linetype, layer),
      weight = weightOf(doc, r, layer, context);
    for (const curve of made)
      out.curves.push({ curve: placedCurve(context.placing, curve), layer, kind: r.type, role, weight });
  }

  const root: Context = { placing: UNPLACED, layer: null, linetype: "", weight: null, path: [] };
  for (const r of doc.entities) {
    const isPaper = flagsAt(r, 67) === 1;
    if (isPaper === (space === "paper")) show(r, root);
    else if (r.type !== "VIEWPORT") out.elsewhere += 1;
    if (out.isFull) break;
  }
  return out;
}
