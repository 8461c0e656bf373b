import type { Curve, FreeElement } from "../../kernel/free/element.ts";
import { solveFreeContour, type FreeSolved } from "../../kernel/free/solve.ts";
import { plane as flat, planeSegment, type PlanePoint, type PlaneSegment } from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { inDegrees, radius, toDiameter } from "../../kernel/units.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { AxisWord, FreeForm, Words } from "../../nc/words.ts";
import {
  AXES,
  freeElement,
  freePoint,
  type FreeElementRead,
  type FreePlane,
  type FreeSetting,
} from "./free-element.ts";

type Free = StatementOf<"free">;
type Path = StatementOf<"path">;

/** An element of a free contour as a path block with all coordinates. */
export interface FreeBlock {
  readonly path: Path;
  /**
   * First element with another possible solution. FSELECT picks one, but the numbering is known to the control only.
   */
  readonly isChosen: boolean;
}

/** Elements of a free contour that are solved together, by their blocks; null where one can not be solved. */
export interface FreeRun {
  readonly blocks: ReadonlyMap<number, FreeBlock | null>;
  /** The block that comes next. */
  readonly expected: number | null;
}

/** A block of a free contour with its number. */
export interface FreeWritten {
  readonly s: Free;
  readonly block: number;
}

const IS_ELEMENT: ReadonlySet<FreeForm> = new Set(["FL", "FLT", "FC", "FCT"]);
export const isFreeElement = (s: Free): boolean => IS_ELEMENT.has(s.form);

/** Cached contours: one in a loop, or unchanged by an edit elsewhere, is solved once. */
const REMEMBERED = 64;
const remembered = new Map<string, readonly (FreeSolved | null)[]>();

function solvedOnce(
  elements: readonly FreeElement[],
  start: PlanePoint,
  before: Curve | null,
): readonly (FreeSolved | null)[] {
  const key = JSON.stringify([elements, start, before]);
  const solved = remembered.get(key) ?? solveFreeContour(elements, start, before);
  remembered.delete(key);
  remembered.set(key, solved);
  for (const [oldest] of remembered) if (remembered.size > REMEMBERED) remembered.delete(oldest);
  return solved;
}

/** Solves a run of free elements from a known point. One result for each of its elements, in order. */
export function solveFree(run: readonly FreeWritten[], setting: FreeSetting): (FreeBlock | null)[] {
  const read = readRun(run, setting);
  const unreadable = read.findIndex((r) => r.element === null);
  const elements = (unreadable < 0 ? read : read.slice(0, unreadable)).flatMap((r) => r.element ?? []);
  if (!setting.from || elements.length === 0) return read.map(() => null);
  const solved = solvedOnce(elements, setting.from, setting.before && curveOf(planeSegment(setting.before)));
  return read.map(({ s }, i): FreeBlock | null => {
    const found = solved[i];
    const path = found && pathOf(s, found.segment, setting.plane);
    return path ? { path, isChosen: !found.certain && (solved[i - 1]?.certain ?? true) } : null;
  });
}

/** Line or circle of the previous segment. */
function curveOf(s: PlaneSegment): Curve | null {
  if (flat.apart(s.from, s.to) <= SAME && s.kind === "line") return null;
  if (s.kind === "arc") return { kind: "arc", centre: s.centre, radius: flat.radiusOf(s), turn: s.turn };
  const angle = flat.angleOf(flat.difference(s.to, s.from));
  return { kind: "line", angle, offset: flat.dot(flat.leftOf(flat.heading(angle)), s.to) };
}

function readRun(run: readonly FreeWritten[], setting: FreeSetting): FreeElementRead[] {
  const read: FreeElementRead[] = [];
  const byBlock = new Map<number, number>();
  let [pole, opened]: [PlanePoint | null, number] = [null, 0];
  for (const { s, block } of run) {
    if (s.form === "FPOL") pole = freePoint(s.words.axes, setting);
    else if (s.form !== "FSELECT") {
      const index = read.length + 1;
      byBlock.set(block, index);
      if (s.given.some((w) => w.name === "CLSD" && w.value === 1)) opened = index - 1;
      read.push({ s, element: freeElement(s, { setting, pole, byBlock, index, opened }) });
    }
  }
  return read;
}

/**
 * The element as a block with its end point; an arc beyond half a turn has a negative radius. Null for a full circle.
 */
function pathOf(s: Free, segment: PlaneSegment, plane: FreePlane): Path | null {
  const [first, second] = AXES[plane];
  const { from, to } = segment;
  const axes: AxisWord[] = [
    ...s.words.axes.filter((w) => w.axis !== first && w.axis !== second),
    {
      axis: first,
      value: to.x,
      incremental: false,
    },
    { axis: second, value: plane === "lathe" ? toDiameter(radius(to.y)) : to.y, incremental: false },
  ];
  const { polarRadius: _p, polarAngle: _a, length: _l, radius: _r, turn: _t, centreAngle: _c, ...plain } = s.words;
  const words: Words = { ...plain, axes };
  if (segment.kind === "line") return { kind: "path", path: "L", words };
  if (flat.apart(from, to) <= SAME) return null;
  const { startRadius, endRadius, sweep } = flat.polarOf(segment);
  const size = Math.max((startRadius + endRadius) / 2, flat.apart(from, to) / 2);
  const isLong = Math.abs(inDegrees(sweep)) > 180;
  return { kind: "path", path: "CR", words: { ...words, radius: isLong ? -size : size, turn: segment.turn } };
}
