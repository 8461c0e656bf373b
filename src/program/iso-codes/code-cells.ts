import { HOLDER_CELLS, type CellName } from "../tools/tool-columns.ts";
import { cellOf, type ToolEntry } from "../tools/tool-entry.ts";
import { anyNumber, readText } from "../values/field.ts";
import type { HolderCode } from "./holder-code.ts";
import { holderCellsOf, type HeldInsert, type NoShank } from "./holder-shape.ts";
import type { InsertCode } from "./insert-code.ts";
import type { MakerCode, MakerNote } from "./maker-code-shape.ts";
import { circleOf, edgeOf, INSERT_SHAPES } from "./insert-facts.ts";
import { readToolCodes, type ToolCodes } from "./tool-code.ts";

/** A cell filled by a code: its old and new text. */
export interface Filling {
  readonly cell: CellName;
  readonly from: string;
  readonly to: string;
}

/** Notes about a code besides its parts. mm and degrees. */
export type CodeNote =
  | {
      readonly is: "shapesDiffer" | "sizesDiffer" | "clearancesDiffer";
      readonly insert: string;
      readonly holder: string;
    }
  | { readonly is: "rowAngle" | "rowEdge"; readonly row: number; readonly code: number }
  | {
      readonly is:
        | "inch"
        | "inchHolder"
        | "sizeUnsure"
        | "onlyCorner"
        | "endCutting"
        | "leftBar"
        | "headDrawn"
        | "special";
    }
  | MakerNote
  | { readonly is: "unsure"; readonly letter: string; readonly angle: number }
  | { readonly is: "noShank"; readonly why: Exclude<NoShank, "incomplete"> };

export interface CodeFilling {
  readonly cells: readonly Filling[];
  readonly notes: readonly CodeNote[];
}

/** Tolerance for equal angles and lengths. */
const SAME_ANGLE = 1;
const SAME_EDGE = 1;
/** Default corner radius of an insert, mm. */
const USUAL_CORNER = 0.8;

type Cells = Partial<Record<CellName, string>>;

const numberIn = (entry: ToolEntry, cell: CellName) => readText(anyNumber, cellOf(entry, cell)).value;
const upToThousandth = (n: number) => String(Math.round(n * 1000) / 1000);

/** Cells given by an insert. */
function insertCells(insert: InsertCode, entry: ToolEntry): Cells {
  const type = cellOf(entry, "TYPE");
  const corner = insert.corner === null ? {} : { RS: upToThousandth(insert.corner) };
  if (insert.angle === null) return { TYPE: "BUTTON", ...corner };
  return {
    ...(type !== "ROUGH" && type !== "FINISH" && { TYPE: "ROUGH" }),
    "P-ANGLE": String(insert.angle),
    ...(insert.edge !== null && { CUTLENGTH: upToThousandth(insert.edge) }),
    ...corner,
  };
}

/** Cells given by the code of a maker: a row of a fitting type keeps it. */
function makerCells({ cells: { TYPE, ...others }, types }: MakerCode, entry: ToolEntry): Cells {
  return types.includes(cellOf(entry, "TYPE")) || TYPE === undefined ? others : { TYPE, ...others };
}

/** Edge length from the size of a holder, mm. */
function edgeOfHolder({ shape, size }: HolderCode): number | null {
  if (size === null) return null;
  const circle = circleOf(shape, Number(size));
  const edge = circle === null ? null : edgeOf(shape, circle);
  return edge === null ? Number(size) : Math.round(edge * 100) / 100;
}

/** Insert of a holder: the typed one, else from the letters of the holder and the row. */
function heldInsert({ insert, holder }: ToolCodes, entry: ToolEntry, setting: number | null): HeldInsert | null {
  if (!holder || setting === null) return null;
  const angle = insert?.angle ?? INSERT_SHAPES[holder.shape]?.angle ?? null;
  const edge = insert?.edge ?? edgeOfHolder(holder) ?? numberIn(entry, "CUTLENGTH");
  if (!angle || !edge || setting + angle >= 180) return null;
  return { setting, angle, edge, corner: insert?.corner ?? numberIn(entry, "RS") ?? USUAL_CORNER };
}

/** Setting angle from −Z to the main edge; null where the holder cuts with another side. */
function settingOf({ kind, style, hand, shape }: HolderCode): number | null {
  if (!style || (kind === "bar" ? style.cuts === "side" : style.cuts === "end")) return null;
  const point = INSERT_SHAPES[shape]?.angle ?? 0;
  // A neutral holder holds its insert upright: both edges have the same angle.
  const upright = (180 - point) / 2;
  return hand === "N" && point > 0 && Math.abs(upright - style.angle) < SAME_ANGLE ? upright : style.angle;
}

const ORIENTATIONS = { R: "1", L: "3", N: "2" } as const;

function holderFacts(codes: ToolCodes, holder: HolderCode, entry: ToolEntry): CodeFilling & { readonly found: Cells } {
  const notes: CodeNote[] = [];
  const found: Cells = {};
  const round = holder.shape === "R";
  const setting = settingOf(holder);
  const letter = holder.parts.find((each) => each.name === "style");
  if (letter && !letter.sure && holder.style)
    notes.push({ is: "unsure", letter: letter.text, angle: holder.style.angle });
  if (holder.style && setting === null && !round) notes.push({ is: "endCutting" });
  if (setting !== null && !round) found["T-ANGLE"] = String(setting);
  if (holder.hand && (setting !== null || round)) found.TO = holder.kind === "bar" ? "7" : ORIENTATIONS[holder.hand];
  if (holder.kind === "bar" && holder.hand === "L") notes.push({ is: "leftBar" });
  if (holder.inch) notes.push({ is: "inchHolder" });
  const shank = holderCellsOf(holder, heldInsert(codes, entry, setting), codes.insert?.edge ?? edgeOfHolder(holder));
  if (typeof shank === "object") {
    Object.assign(found, shank);
    notes.push({ is: "headDrawn" });
  } else if (shank !== "incomplete" && !(shank === "seat" && setting === null))
    notes.push({ is: "noShank", why: shank });
  return { cells: [], notes, found };
}

/** Insert data from a holder alone, where the row has none yet; and contradictions with the row. */
function holderInsert(holder: HolderCode, entry: ToolEntry): CodeFilling & { readonly found: Cells } {
  const notes: CodeNote[] = [];
  const found: Cells = {};
  const [angle, edge] = [INSERT_SHAPES[holder.shape]?.angle ?? null, edgeOfHolder(holder)];
  const [rowAngle, rowEdge] = [numberIn(entry, "P-ANGLE"), numberIn(entry, "CUTLENGTH")];
  if (holder.shape === "R")
    return { cells: [], notes, found: cellOf(entry, "TYPE") === "BUTTON" ? found : { TYPE: "BUTTON" } };
  if (angle !== null && rowAngle === null) found["P-ANGLE"] = String(angle);
  else if (angle !== null && rowAngle !== null && Math.abs(rowAngle - angle) >= SAME_ANGLE)
    notes.push({ is: "rowAngle", row: rowAngle, code: angle });
  if (edge !== null && rowEdge === null) found.CUTLENGTH = String(edge);
  else if (edge !== null && rowEdge !== null && Math.abs(rowEdge - edge) >= SAME_EDGE)
    notes.push({ is: "rowEdge", row: rowEdge, code: edge });
  return { cells: [], notes, found };
}

function differences({ insert, holder }: ToolCodes): CodeNote[] {
  if (!insert || !holder) return [];
  const differ = (
    is: "shapesDiffer" | "sizesDiffer" | "clearancesDiffer",
    a: string | null,
    b: string | null,
  ): CodeNote[] => (a && b && a !== b ? [{ is, insert: a, holder: b }] : []);
  return [
    ...differ("shapesDiffer", insert.shape, holder.shape),
    ...(insert.shape === holder.shape ? differ("sizesDiffer", insert.size, holder.size) : []),
    ...differ("clearancesDiffer", insert.clearance, holder.clearance),
  ];
}

function insertNotes(insert: InsertCode): CodeNote[] {
  const form = INSERT_SHAPES[insert.shape]?.form;
  const edge = insert.parts.find((each) => each.name === "edge");
  return [
    ...(insert.inch && insert.edge !== null ? [{ is: "inch" } as const] : []),
    ...(insert.edge !== null && insert.corner === null ? [{ is: "cornerMissing" } as const] : []),
    ...(edge?.meaning && !edge.sure ? [{ is: "sizeUnsure" } as const] : []),
    ...(form === "triangle" || form === "trigon" || form === "polygon" ? [{ is: "onlyCorner" } as const] : []),
  ];
}

/** Code used as tool name: of its insert, else of its holder. */
export const nameOfCodes = ({ insert, holder, maker }: ToolCodes): string =>
  insert?.code ?? holder?.code ?? maker?.code ?? "";

/** Whether codes rename a row: one without a name, or one that has its name from an earlier code. */
function renames(codes: ToolCodes, entry: ToolEntry): boolean {
  const name = cellOf(entry, "NAME").trim();
  if (name === "" || nameOfCodes(codes) === "") return nameOfCodes(codes) !== "";
  const earlier = readToolCodes(name);
  // The insert names a tool rather than its holder.
  const isOther = isWholeCode(earlier) && nameOfCodes(earlier) !== nameOfCodes(codes);
  return isOther && (codes.insert !== null || codes.maker !== undefined || earlier.insert === null);
}

/**
 * Cells that codes fill into a row, with notes. Only stated cells are filled; the name only where no operator wrote
 * one.
 */
export function fillingOf(codes: ToolCodes, entry: ToolEntry): CodeFilling {
  const { insert, holder, maker } = codes;
  const ofHolder = holder ? holderFacts(codes, holder, entry) : null;
  const asked = holder && !insert ? holderInsert(holder, entry) : null;
  const name: Cells = renames(codes, entry) ? { NAME: nameOfCodes(codes) } : {};
  const wanted: Cells = {
    ...name,
    ...(insert && insertCells(insert, entry)),
    ...asked?.found,
    ...ofHolder?.found,
    ...(maker && makerCells(maker, entry)),
  };
  const isSpecial = [...(insert?.parts ?? []), ...(holder?.parts ?? [])].some((each) => each.meaning?.is === "special");
  const cells = Object.entries(wanted)
    .map(([cell, to]) => ({ cell: cell as CellName, from: cellOf(entry, cell as CellName), to }))
    .filter(({ from, to }) => from.trim() !== to);
  return {
    cells,
    notes: [
      ...differences(codes),
      ...(asked?.notes ?? []),
      ...(insert ? insertNotes(insert) : []),
      ...(ofHolder?.notes ?? []),
      ...(maker?.notes ?? []),
      ...(isSpecial ? [{ is: "special" } as const] : []),
    ],
  };
}

/** Whether a text is a complete code with known letters only. */
export function isWholeCode({ insert, holder, maker, notCovered }: ToolCodes): boolean {
  if (notCovered !== null) return false;
  if (maker) return true;
  const parts = [...(insert?.parts ?? []), ...(holder?.parts ?? [])];
  const whole = insert
    ? parts.some((each) => each.name === "corner")
    : Boolean(holder?.across) && Boolean(holder?.style);
  return whole && parts.every((each) => each.meaning !== null);
}

/** Whether a filling is of the holder, whose cells are shown as one. */
export const isHolderFilling = ({ cell }: Filling): boolean => HOLDER_CELLS.some((each) => each === cell);
