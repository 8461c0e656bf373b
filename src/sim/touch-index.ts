import { insertOutline } from "../kernel/insert.ts";
import type { Step } from "../kernel/step.ts";
import { pathOf } from "../kernel/time.ts";
import { CHORD, SAME } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/tool.ts";
import { part, type Ring } from "../kernel/point.ts";
import { boxOf } from "../kernel/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { ConvexPiece } from "./piece.ts";
import type { PlayPosition } from "./simulation.ts";
import { sweptBy } from "./sweep.ts";

/** Finds which move has a place on the edge of what it swept. */
export interface TouchIndex {
  /** The latest cutting move after `after` that has begun at `now` and touches a place; −1 where there is none. */
  readonly latest: (z: number, r: number, now: PlayPosition, after: number) => number;
}

/** Columns along Z, and the most entries worth keeping in all of them. */
const COLUMNS = 256;
const ENTRIES = 2_000_000;
/** Sweeps that are remembered. */
const MOST = 2000;

const cuts = ({ move, from }: Step) => move.kind !== "rapid" && (move.to.z !== from.z || move.to.r !== from.r);

/** The box of the way of a step, wide enough for any of its arcs. */
function wayBox({ from, move }: Step): Box {
  const path = pathOf(from, move);
  if (path.kind === "arc") {
    const { z, r } = path.centre, { startRadius, endRadius } = part.polarOf(path), size = Math.max(startRadius, endRadius);
    return { left: z - size, right: z + size, low: r - size, high: r + size };
  }
  return {
    left: Math.min(from.z, move.to.z),
    right: Math.max(from.z, move.to.z),
    low: Math.min(from.r, move.to.r),
    high: Math.max(from.r, move.to.r),
  };
}

/** Whether a place lies in a piece or on its edge. */
function touches({ box, sides }: ConvexPiece, z: number, r: number): boolean {
  if (z < box.left - SAME || z > box.right + SAME || r < box.low - SAME || r > box.high + SAME) return false;
  for (let i = 0; i < sides.length; i += 3) {
    if ((sides[i] as number) * z + (sides[i + 1] as number) * r - (sides[i + 2] as number) > SAME) return false;
  }
  return sides.length > 0;
}

/** The boxes of all sweeps, in columns along Z; built when it is first asked. */
function columnsOf(steps: readonly Step[], outlineOf: (tool: Tool) => { readonly box: Box }) {
  const boxes = new Float64Array(4 * steps.length).fill(NaN);
  let [left, right] = [Infinity, -Infinity];
  steps.forEach((step, i) => {
    if (!cuts(step)) return;
    const way = wayBox(step), { box } = outlineOf(step.tool);
    const low = way.low + box.low;
    // What is swept beyond the axis is swept on this side.
    const near = low < 0 ? 0 : low;
    boxes.set([way.left + box.left - SAME, way.right + box.right + SAME, near - SAME, Math.max(way.high + box.high, -low) + SAME], 4 * i);
    left = Math.min(left, way.left + box.left - SAME);
    right = Math.max(right, way.right + box.right + SAME);
  });
  const count = Math.max(1, Math.min(COLUMNS, Math.floor(ENTRIES / Math.max(1, steps.length))));
  const perMm = right > left ? count / (right - left) : 0;
  const columnOf = (z: number) => Math.max(0, Math.min(count - 1, Math.floor((z - left) * perMm)));
  const lists: number[][] = Array.from({ length: count }, () => []);
  for (let i = 0; i < steps.length; i += 1) {
    const [from, to] = [boxes[4 * i] as number, boxes[4 * i + 1] as number];
    if (!(from <= to)) continue;
    for (let c = columnOf(from); c <= columnOf(to); c += 1) lists[c]?.push(i);
  }
  return {
    listAt: (z: number): readonly number[] => (z < left || z > right ? [] : lists[columnOf(z)] ?? []),
    holds: (i: number, z: number, r: number) =>
      z >= (boxes[4 * i] as number) && z <= (boxes[4 * i + 1] as number) && r >= (boxes[4 * i + 2] as number)
      && r <= (boxes[4 * i + 3] as number),
  };
}

/** How many entries of an ascending list are not greater than a number. */
function countUpTo(list: readonly number[], most: number): number {
  let [low, high] = [0, list.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((list[middle] as number) <= most) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Prepares the moves of a run to be asked which of them touches a place. */
export function touchIndex(steps: readonly Step[]): TouchIndex {
  const outlines = new Map<Tool, { readonly ring: Ring; readonly box: Box }>();
  const outlineOf = (tool: Tool) => {
    const ring = outlines.get(tool)?.ring ?? insertOutline(tool, CHORD);
    const made = outlines.get(tool) ?? { ring, box: boxOf(ring) };
    outlines.set(tool, made);
    return made;
  };
  let columns: ReturnType<typeof columnsOf> | null = null;
  const whole = new Map<number, readonly ConvexPiece[]>();
  let running: { readonly step: number; readonly fraction: number; readonly pieces: readonly ConvexPiece[] } | null = null;

  function piecesOf(i: number, now: PlayPosition): readonly ConvexPiece[] {
    const step = steps[i] as Step, { ring } = outlineOf(step.tool);
    if (i === now.step) {
      if (running?.step !== i || running.fraction !== now.fraction)
        running = { step: i, fraction: now.fraction, pieces: sweptBy(ring, step, now.fraction).pieces };
      return running.pieces;
    }
    const have = whole.get(i) ?? sweptBy(ring, step).pieces;
    if (whole.size > MOST) whole.clear();
    whole.set(i, have);
    return have;
  }

  return {
    latest(z, r, now, after) {
      columns ??= columnsOf(steps, outlineOf);
      const list = columns.listAt(z);
      for (let k = countUpTo(list, now.fraction > 0 ? now.step : now.step - 1) - 1; k >= 0; k -= 1) {
        const i = list[k] as number;
        if (i <= after) return -1;
        if (columns.holds(i, z, r) && piecesOf(i, now).some((piece) => touches(piece, z, r))) return i;
      }
      return -1;
    },
  };
}
