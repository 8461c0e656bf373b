import { insertOutline } from "../kernel/cutter/insert.ts";
import type { Step } from "../kernel/time/step.ts";
import { pathOf } from "../kernel/time/time.ts";
import { CHORD, SAME } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { at, part, type Pt, type Ring } from "../kernel/geometry/point.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import { boxOf } from "../kernel/area/box.ts";
import { convexPieceOf, type ConvexPiece } from "./piece.ts";
import type { PlayPosition } from "./simulation.ts";
import { sweptBy } from "./sweep.ts";

/** Finds the move whose sweep has a point on its edge. */
export interface TouchIndex {
  /** The latest cutting move after `after`, begun at `now` or before, that touches a point; −1 without one. */
  readonly latest: (z: number, r: number, now: PlayPosition, after: number) => number;
  /** The index of another run; leading steps in common are not indexed again. */
  readonly of: (steps: readonly Step[]) => TouchIndex;
}

/** Most cached sweeps. */
const MOST = 2000;
/** Steps per block and blocks per group, as powers of two. */
const BLOCK = 5,
  GROUP = 10;

const cuts = ({ move, from }: Step) => move.kind !== "rapid" && (move.to.z !== from.z || move.to.r !== from.r);

/** The bounding box of a step's path, wide enough for any arc. */
function wayBox({ from, move }: Step): Box {
  const path = pathOf(from, move);
  if (path.kind === "arc") {
    // An arc whose ends are on two circles reaches farther than the circle through its start.
    const { startRadius, endRadius } = part.polarOf(path),
      { left, right, low, high } = part.boxOf(path);
    const by = SAME + Math.abs(startRadius - endRadius);
    return { left: left - by, right: right + by, low: low - by, high: high + by };
  }
  return {
    left: Math.min(from.z, move.to.z),
    right: Math.max(from.z, move.to.z),
    low: Math.min(from.r, move.to.r),
    high: Math.max(from.r, move.to.r),
  };
}

/** Whether a point is in a piece or on its edge. */
function touches({ box, sides }: ConvexPiece, z: number, r: number): boolean {
  if (z < box.left - SAME || z > box.right + SAME || r < box.low - SAME || r > box.high + SAME) return false;
  for (let i = 0; i < sides.length; i += 3) {
    if ((sides[i] as number) * z + (sides[i + 1] as number) * r - (sides[i + 2] as number) > SAME) return false;
  }
  return sides.length > 0;
}

/**
 * Whether a convex outline may touch a point with its tip anywhere in a box: no side has the whole box beyond it. The
 * sides of a piece are slightly inside those of its ring, so SAME beyond a side of the ring is enough.
 */
function mayTouch({ sides, box }: ConvexPiece, way: Box, z: number, r: number): boolean {
  const left = z - way.right,
    right = z - way.left,
    low = r - way.high,
    high = r - way.low;
  if (!(left <= box.right + SAME && right >= box.left - SAME && low <= box.high + SAME && high >= box.low - SAME))
    return false;
  for (let i = 0; i < sides.length; i += 3) {
    const nz = sides[i] as number,
      nr = sides[i + 1] as number;
    if (nz * (nz > 0 ? left : right) + nr * (nr > 0 ? low : high) - (sides[i + 2] as number) > 2 * SAME) return false;
  }
  return true;
}

/** The same for a straight path: at some moment the point is beyond none of the sides. */
function mayTouchAlong({ sides, box }: ConvexPiece, from: Pt, to: Pt, z: number, r: number): boolean {
  if (z < Math.min(from.z, to.z) + box.left - SAME || z > Math.max(from.z, to.z) + box.right + SAME) return false;
  if (r < Math.min(from.r, to.r) + box.low - SAME || r > Math.max(from.r, to.r) + box.high + SAME) return false;
  let [begin, end] = [0, 1];
  for (let i = 0; i < sides.length; i += 3) {
    const nz = sides[i] as number,
      nr = sides[i + 1] as number;
    const first = nz * (z - from.z) + nr * (r - from.r) - (sides[i + 2] as number) - 2 * SAME;
    const last = nz * (z - to.z) + nr * (r - to.r) - (sides[i + 2] as number) - 2 * SAME;
    if (first > 0 && last > 0) return false;
    if (first > 0) begin = Math.max(begin, first / (first - last));
    else if (last > 0) end = Math.min(end, first / (first - last));
    if (begin > end) return false;
  }
  return true;
}

/** The tip paths of some cuts: their box and tool; null for several tools. */
interface Ways extends Box {
  readonly tool: Tool | null;
}

/** The union of some path boxes; null without any. */
function around(all: Iterable<Ways | null>): Ways | null {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity],
    tool: Tool | null | undefined;
  for (const way of all) {
    if (!way) continue;
    left = Math.min(left, way.left);
    right = Math.max(right, way.right);
    low = Math.min(low, way.low);
    high = Math.max(high, way.high);
    tool = tool === undefined || tool === way.tool ? way.tool : null;
  }
  return tool === undefined ? null : { left, right, low, high, tool };
}

/** The path box of a cutting step; null for non-finite moves. */
function wayOf(step: Step): Ways | null {
  if (!cuts(step)) return null;
  const way = wayBox(step);
  return Number.isFinite(way.left + way.right + way.low + way.high) ? { ...way, tool: step.tool } : null;
}

/** The steps of a run with the path boxes of its blocks and groups. */
interface Blocks {
  readonly steps: readonly Step[];
  readonly blocks: readonly (Ways | null)[];
  readonly groups: readonly (Ways | null)[];
}

/** The number of lists of 2^power entries. */
const counted = (count: number, power: number) => Math.ceil(count / 2 ** power);

/** Cached tool outlines and path boxes, shared by successive runs. */
interface Shapes {
  readonly outlines: WeakMap<Tool, ConvexPiece>;
  readonly ways: WeakMap<Step, Ways | null>;
}

/** The path box of a step; cached for arcs. */
function knownWay(step: Step, { ways }: Shapes): Ways | null {
  if (step.move.kind !== "arc") return wayOf(step);
  const known = ways.get(step);
  if (known !== undefined) return known;
  const made = wayOf(step);
  ways.set(step, made);
  return made;
}

/** `before`: another run, whose blocks are reused where the steps are identical. */
function blocksOf(steps: readonly Step[], shapes: Shapes, before: Blocks | null): Blocks {
  const isSame = (from: number, to: number): boolean => {
    if (!before || to > before.steps.length) return false;
    for (let i = from; i < to; i += 1) if (steps[i] !== before.steps[i]) return false;
    return true;
  };
  const blocks = Array.from({ length: counted(steps.length, BLOCK) }, (_, i) => {
    const from = i << BLOCK,
      to = Math.min(steps.length, from + (1 << BLOCK));
    return isSame(from, to)
      ? (before?.blocks[i] ?? null)
      : around(steps.slice(from, to).map((step) => knownWay(step, shapes)));
  });
  const each = GROUP - BLOCK;
  const groups = Array.from({ length: counted(blocks.length, each) }, (_, i) =>
    around(blocks.slice(i << each, (i + 1) << each)),
  );
  return { steps, blocks, groups };
}

/** A convex outline of a tool: itself, or the box around a centre drill. */
function aroundTool(outline: Ring, { centre }: Tool): Ring {
  if (!centre) return outline;
  const { left, right, low, high } = boxOf(outline);
  return [at(left, low), at(right, low), at(right, high), at(left, high)];
}

/** Builds the index of a run. */
export const touchIndex = (steps: readonly Step[]): TouchIndex =>
  indexOf(steps, null, { outlines: new WeakMap(), ways: new WeakMap() });

function indexOf(steps: readonly Step[], before: Blocks | null, shapes: Shapes): TouchIndex {
  const { outlines } = shapes;
  const outlineOf = (tool: Tool): ConvexPiece => {
    const made = outlines.get(tool) ?? convexPieceOf(aroundTool(insertOutline(tool, CHORD), tool));
    outlines.set(tool, made);
    return made;
  };
  let made: Blocks | null = null;
  const whole = new Map<number, readonly ConvexPiece[]>();
  let running: { readonly step: number; readonly fraction: number; readonly pieces: readonly ConvexPiece[] } | null =
    null;

  function piecesOf(i: number, now: PlayPosition): readonly ConvexPiece[] {
    const step = steps[i] as Step,
      { ring } = outlineOf(step.tool);
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

  /** Sweeps beyond the axis are mirrored to this side, so both sides are searched. */
  function mayBeAt(ways: Ways | null, z: number, r: number): boolean {
    if (!ways?.tool) return ways !== null;
    const outline = outlineOf(ways.tool);
    return mayTouch(outline, ways, z, r) || (ways.low + outline.box.low < SAME && mayTouch(outline, ways, z, -r));
  }

  function mayCut(step: Step, z: number, r: number): boolean {
    if (!cuts(step)) return false;
    const { from, move, tool } = step;
    if (move.kind !== "feed") return mayBeAt(knownWay(step, shapes), z, r);
    const outline = outlineOf(tool),
      low = Math.min(from.r, move.to.r) + outline.box.low;
    return mayTouchAlong(outline, from, move.to, z, r) || (low < SAME && mayTouchAlong(outline, from, move.to, z, -r));
  }

  return {
    latest(z, r, now, after) {
      const { blocks, groups } = (made ??= blocksOf(steps, shapes, before));
      let i = Math.min(steps.length - 1, now.fraction > 0 ? now.step : now.step - 1),
        block = -1,
        group = -1;
      for (; i > after; i -= 1) {
        if (group !== i >> GROUP) {
          group = i >> GROUP;
          if (!mayBeAt(groups[group] ?? null, z, r)) i = group << GROUP;
        }
        if (block !== i >> BLOCK) {
          block = i >> BLOCK;
          if (!mayBeAt(blocks[block] ?? null, z, r)) i = block << BLOCK;
        }
        const step = steps[i];
        if (step && mayCut(step, z, r) && piecesOf(i, now).some((piece) => touches(piece, z, r))) return i;
      }
      return -1;
    },
    of: (next) => indexOf(next, made ?? before, shapes),
  };
}
