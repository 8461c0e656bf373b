import { radiusOf } from "../../kernel/units.ts";
import { fillingOf, isWholeCode, nameOfCodes } from "../iso-codes/code-cells.ts";
import type { Hand } from "../iso-codes/code-part.ts";
import { edgeOf, INSERT_SHAPES } from "../iso-codes/insert-facts.ts";
import { readToolCodes, type ToolCodes } from "../iso-codes/tool-code.ts";
import { HOLDER_CELLS, MILL, type CellName } from "../tools/tool-columns.ts";
import type { ToolEntry } from "../tools/tool-entry.ts";
import {
  onGrid,
  type Fact,
  type Facts,
  type FileTool,
  type FileToolKind,
  type ProposalReason,
  type WorkSide,
} from "./facts.ts";
import { controlName, kindOfWords, saysFinishing, sideOfWords } from "./tool-words.ts";

/** Where the text of a cell comes from; a proposal names its reasons. */
export interface CellOrigin {
  readonly from: string;
  readonly why: readonly ProposalReason[];
}

/** A tool of another system as a row of the table, each cell with its origin. */
export interface ForeignTool {
  readonly label: string;
  readonly cells: ToolEntry["cells"];
  readonly origins: Readonly<Partial<Record<CellName, CellOrigin>>>;
  readonly unused: readonly string[];
}

const proposed = <T>(value: T, why: ProposalReason, from = ""): Fact<T> => ({ value, from, why });

/** Kind by the properties that are there; null where they fit more than one. */
function kindOfFacts(facts: Facts): FileToolKind | null {
  if (facts.width) return "grooving";
  if (facts.pitch ?? facts.profile) return facts.cutter ? "tap" : "threading";
  if (facts.cutter) return facts.drillPoint ? "drill" : null;
  return (facts.nose ?? facts.setting ?? facts.shape ?? facts.point) ? "turning" : null;
}

function kindOf({ facts, label, texts }: FileTool): Fact<FileToolKind> | null {
  if (facts.kind) return facts.kind;
  const [worded, seen] = [kindOfWords([label, ...texts].join(" ")), kindOfFacts(facts)];
  if (worded) return proposed(worded, "kindFromName", label);
  return seen ? proposed(seen, "kindFromProperties") : null;
}

function sideOf({ facts, label }: FileTool): Fact<WorkSide> {
  if (facts.side) return facts.side;
  const worded = sideOfWords(label);
  return worded ? proposed(worded, "sideFromName", label) : proposed("outside", "outsideAssumed");
}

const OUTSIDE: Readonly<Record<Hand, number>> = { R: 1, N: 2, L: 3 };
const MIDDLE: Readonly<Record<WorkSide, number>> = { outside: 2, inside: 6, face: 8 };

const joined = (facts: readonly (Fact<unknown> | undefined)[], ...more: readonly ProposalReason[]): CellOrigin => ({
  from: [...new Set(facts.map((fact) => fact?.from ?? "").filter((from) => from !== ""))].join(", "),
  why: [...new Set([...facts.flatMap((fact) => (fact?.why ? [fact.why] : [])), ...more])],
});

/** TO, with its origin: the file rarely has it. */
function orientationOf(tool: FileTool, kind: FileToolKind, round: boolean): readonly [number, CellOrigin] {
  const { orientation, hand } = tool.facts;
  if (orientation) return [orientation.value, joined([orientation])];
  const side = sideOf(tool);
  if (kind === "threading") return [MIDDLE[side.value], joined([side])];
  if (kind !== "turning" || (round && !hand)) return [MIDDLE[side.value], joined([side], "middleAssumed")];
  const held = hand ?? proposed<Hand>("R", "handAssumed");
  if (side.value !== "inside") return [OUTSIDE[held.value], joined([side, held])];
  if (held.value === "N") return [MIDDLE.inside, joined([side, held])];
  return [7, joined([side, held], ...(held.value === "L" ? (["leftBar"] as const) : []))];
}

const LIMITS = [
  ["CDX", "depth"],
  ["DAXN", "axialFrom"],
  ["DAXX", "axialTo"],
  ["CUTDIA", "partOff"],
] as const;

class Row {
  readonly cells: Partial<Record<CellName, string>> = {};
  readonly origins: Partial<Record<CellName, CellOrigin>> = {};

  set(cell: CellName, text: string | number, origin: CellOrigin): void {
    this.cells[cell] = typeof text === "number" ? String(onGrid(text)) : text;
    this.origins[cell] = origin;
  }

  put(cell: CellName, fact: Fact<string | number> | undefined): void {
    if (fact) this.set(cell, fact.value, joined([fact]));
  }
}

const sizesOfHolder = ({ shank, reach, head, overall }: Facts): readonly string[] =>
  [shank, reach, head, overall].flatMap((fact) => (fact ? [fact.from] : []));

/**
 * Shank from its sizes: `reach` is measured from the back of a shank, and from the axis of a bar (WF of ISO 13399), to
 * the tip, of a blade to the middle of its edge. Properties that do not place it are returned.
 */
function putHolder(row: Row, facts: Facts, isBlade: boolean): readonly string[] {
  const { shank, reach, head, overall, hand } = facts;
  const to = Number(row.cells.TO);
  const left = sizesOfHolder(facts);
  if (!shank || !reach || !head || !overall || overall.value <= head.value) return left;
  const place = placeOf(to, shank.value, reach.value, hand?.value);
  if (!place) return left;
  const origin = joined([shank, reach, head, overall], ...(isBlade ? (["middleAssumed"] as const) : []));
  row.set("width", shank.value, origin);
  row.set("length", overall.value - head.value, origin);
  const [z, x] = place;
  row.set("offsetZ", z ?? head.value, origin);
  row.set("offsetX", x ?? head.value, origin);
  return [];
}

/** Near corner of the shank beside the head, along Z for a shank and along X for a bar; null where it is unknown. */
function placeOf(
  to: number,
  shank: number,
  reach: number,
  hand?: Hand,
): readonly [number | null, number | null] | null {
  const near = reach - shank;
  if (to === 1) return [near, null];
  if (to === 3) return [-near, null];
  if (to === 2 && hand) return [{ N: -radiusOf(shank), R: near, L: -reach }[hand], null];
  return to === 6 || to === 7 ? [null, radiusOf(shank) - reach] : null;
}

function putTurning(row: Row, tool: FileTool, kind: Fact<FileToolKind>): readonly string[] {
  const { facts, label } = tool;
  const { shape, circle, edge, point, finishing, nose, width, profile, setting } = facts;
  const round = kind.value === "turning" && shape?.value === "R";
  if (round) row.set("TYPE", "BUTTON", joined([kind, shape]));
  else if (kind.value === "turning") {
    const isFinish = finishing?.value ?? saysFinishing(label);
    row.set("TYPE", isFinish ? "FINISH" : "ROUGH", isFinish ? joined([kind], "kindFromName") : joined([kind]));
  } else if (kind.value === "threading") row.set("TYPE", "THREAD", joined([kind]));
  else row.set("TYPE", "RECESS", joined([kind], ...(kind.value === "parting" ? [] : (["recessAssumed"] as const))));
  row.set("TO", ...orientationOf(tool, kind.value, round));
  row.put("RS", nose);
  if (round) {
    const across = circle ?? edge;
    if (!nose && across) row.set("RS", radiusOf(across.value), joined([across]));
    return putHolder(row, facts, false);
  }
  if (kind.value === "threading") row.put("P-ANGLE", profile);
  if (Number(row.cells.TO) > 3) row.put("DMIN", facts.bore);
  const isBlade = kind.value === "grooving" || kind.value === "parting";
  if (isBlade) {
    row.put("CUTWIDTH", width);
    for (const [cell, name] of LIMITS) row.put(cell, facts[name]);
  }
  if (kind.value !== "turning") return putHolder(row, facts, isBlade);
  row.put("T-ANGLE", setting);
  const angle = INSERT_SHAPES[shape?.value ?? ""]?.angle;
  if (point) row.put("P-ANGLE", point);
  else if (angle) row.set("P-ANGLE", angle, joined([shape]));
  const length = circle && shape ? edgeOf(shape.value, circle.value) : null;
  if (edge) row.put("CUTLENGTH", edge);
  else if (length !== null) row.set("CUTLENGTH", Math.round(length * 100) / 100, joined([circle, shape]));
  return putHolder(row, facts, false);
}

const AXIAL: Partial<Record<FileToolKind, string>> = {
  drill: "DRILL",
  center: "CENTER",
  tap: "TAP",
  reamer: "REAM",
  mill: MILL,
};

function putAxial(
  row: Row,
  { cutter, drillPoint, flute, pitch, lengthZ, pointLength }: Facts,
  kind: Fact<FileToolKind>,
): void {
  row.set("TYPE", AXIAL[kind.value] ?? MILL, joined([kind]));
  if (cutter) row.set("R", radiusOf(cutter.value), joined([cutter]));
  if (lengthZ) row.put("L", lengthZ);
  if (kind.value === "drill" || kind.value === "center") row.put("T-ANGLE", drillPoint);
  if (kind.value !== "mill") row.put("LCUTS", flute);
  if (kind.value === "drill") row.put("PL", pointLength);
  if (kind.value === "tap") row.put("PITCH", pitch);
}

/** Most words at which a code may begin. */
const MOST_WORDS = 12;

/** The first complete code of an insert, a holder or both within a text, or that of a maker. */
function codesIn(text: string): ToolCodes | null {
  const starts = [...text.slice(0, 200).matchAll(/(?:^|[\s,;:(+])(?=[A-Za-z\d])/g)].slice(0, MOST_WORDS);
  for (const { index, 0: gap } of starts) {
    const codes = readToolCodes(text.slice(index + gap.length, 200));
    if (isWholeCode(codes) || codes.maker) return codes;
  }
  return null;
}

const ASSUMED: readonly ProposalReason[] = ["outsideAssumed", "handAssumed", "kindFromProperties"];

/** Cells that codes in the texts of a tool state, where the file itself does not. */
function putCodes(row: Row, texts: readonly string[], kind: FileToolKind | undefined): void {
  for (const text of texts) {
    const codes = codesIn(text);
    // Codes of makers are those of blades and thread inserts, codes of ISO those of turning inserts and holders.
    if (!codes || (kind !== undefined && (kind === "turning") === (codes.maker !== undefined))) continue;
    const held = row.cells.width !== undefined;
    const filled = fillingOf(codes, { id: "", cells: { ...row.cells } }).cells;
    for (const { cell, to } of filled) {
      const isOpen = row.cells[cell] === undefined || row.origins[cell]?.why.some((why) => ASSUMED.includes(why));
      const ofHolder = HOLDER_CELLS.some((each) => each === cell);
      if (cell === "NAME" || to === "" || !isOpen || (held && ofHolder)) continue;
      row.set(cell, to, { from: nameOfCodes(codes) || text, why: ["fromCode"] });
    }
  }
}

/** A tool of a file as a row of the table. A cell that the file does not give is proposed with a reason, or stays empty. */
export function foreignTool(tool: FileTool): ForeignTool {
  const { facts, label, texts } = tool;
  const row = new Row();
  row.put("T", facts.number);
  const name = controlName(facts.name?.value ?? label);
  if (name !== "") row.set("NAME", name, facts.name ? joined([facts.name]) : { from: label, why: [] });
  const kind = kindOf(tool);
  let left: readonly string[] = [];
  if (kind && AXIAL[kind.value]) putAxial(row, facts, kind);
  else if (kind) left = putTurning(row, tool, kind);
  row.put("ZL", kind && AXIAL[kind.value] ? undefined : facts.lengthZ);
  row.put("XL", facts.lengthX);
  if (!kind || !AXIAL[kind.value]) putCodes(row, texts, kind?.value);
  return { label, cells: row.cells, origins: row.origins, unused: [...tool.unused, ...left] };
}
