import { edgeEnd, edgeStart, extent, type Convex } from "../../kernel/convex.ts";
import { flat, type Flat } from "../../kernel/flat.ts";
import { insertShape, shiftOf } from "../../kernel/insert.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/point.ts";
import type { Step } from "../../kernel/step.ts";
import { pathOf } from "../../kernel/time.ts";
import { SAME, SLIVER } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/tool.ts";
import { moved, support } from "../../kernel/convex.ts";
import type { Box } from "../../kernel/geometry/segments.ts";

/** A surface is looked at in pieces of this length, mm, or longer ones where it is so long that there would be more than MOST. */
const PIECE = 0.5;
const MOST = 4000;
/** Stock and path are chords: a tool this near to a surface has made it, mm. */
const TOUCH = SLIVER;
/** A move goes along a surface when their directions differ by less, as a sine. */
const ALONG = 0.1;

/** A short straight piece of the surface of a stock, the work on its left as the outline runs. */
export interface SurfacePiece {
  readonly from: Pt;
  readonly to: Pt;
  /** Out of the work, length 1. */
  readonly out: Flat;
}

/** What made a piece of a surface. */
export interface Made extends SurfacePiece {
  /** Index of the last feed that touched it, or null where none did: as it was put into the chuck. */
  readonly step: number | null;
  /** Where the tip stood over the middle of the piece. */
  readonly tip: Pt;
  /** The tool went along it; else it stood there at the beginning or the end of its move, and left its shape. */
  readonly along: boolean;
}

/** The outlines of a stock in short pieces; what lies on the axis is no surface. */
export function surfaceOf(stock: readonly Ring[]): SurfacePiece[] {
  const edges = stock.flatMap((ring) => ring.map((to, i) => ({ from: ring[(i + ring.length - 1) % ring.length] as Pt, to }))).filter(
    ({ from, to }) => from.r > SAME || to.r > SAME
  );
  const size = Math.max(PIECE, edges.reduce((sum, { from, to }) => sum + part.apart(from, to), 0) / MOST);
  return edges.flatMap(({ from, to }) => {
    const long = part.apart(from, to), count = Math.ceil(long / size);
    if (!(long > 0)) return [];
    const out: Flat = { u: (to.r - from.r) / long, v: (from.z - to.z) / long };
    const point = (i: number) => part.pointOn({ kind: "line", from, to }, i / count);
    return Array.from({ length: count }, (_, i) => ({ from: point(i), to: point(i + 1), out }));
  });
}

/** The points of an insert that lie farthest in a direction: one, or the two ends of a straight edge. */
function farthest(shape: Convex, out: Flat): readonly Flat[] {
  const { at: best } = support(shape, out), most = flat.dot(best, out) - TOUCH / 2;
  const edge = shape.find((e) => e.kind === "line" && flat.dot(e.from, out) > most && flat.dot(e.to, out) > most);
  return edge ? [edgeStart(edge), edgeEnd(edge)] : [best];
}

const cross = (a: Pt, b: Pt, p: Pt) => (b.z - a.z) * (p.r - a.r) - (b.r - a.r) * (p.z - a.z);
/** Places on an edge that are tried against an arc. */
const TRIED = [0, 0.25, 0.5, 0.75, 1] as const;

/** The place on a path nearest to one of the places that a tip may have, where that is near enough; null where it never is. */
function tipOn(path: Segment, tips: readonly Pt[]): Pt | null {
  const [first, last] = [tips[0] as Pt, tips.at(-1) as Pt];
  const span: Segment = { kind: "line", from: first, to: last };
  const places = tips.length === 1 || path.kind === "line" ? tips : TRIED.map((k) => part.pointOn(span, k));
  for (const tip of places) if (part.distanceTo(path, tip) <= TOUCH) return part.nearestOn(path, tip);
  if (tips.length === 1) return null;
  for (const end of [path.to, path.from]) if (part.distanceTo(span, end) <= TOUCH) return end;
  if (path.kind === "arc") return null;
  const [a, b] = [cross(first, last, path.from), cross(first, last, path.to)];
  const apart = cross(path.from, path.to, first) * cross(path.from, path.to, last) < 0 && a * b < 0;
  return apart ? part.pointOn(path, a / (a - b)) : null;
}

interface Touching {
  readonly box: Box;
  /** For each piece the points of the insert that touch it, once they were asked for. */
  readonly ends: (readonly Flat[] | undefined)[];
  readonly shape: Convex;
}

const touchingOf = (tool: Tool): Touching => {
  const shape = moved(insertShape(tool, true), shiftOf(tool)), { minU, maxU, minV, maxV } = extent(shape);
  return { shape, ends: [], box: { left: minU - TOUCH, right: maxU + TOUCH, low: minV - TOUCH, high: maxV + TOUCH } };
};

/** Whether a surface may be the work of a move. Feeds of a program without cycles are cuts like any. */
const makesSurface = ({ move }: Step) => move.kind !== "rapid";

/** Pieces in the order of Z that nobody has claimed yet. */
function unclaimed(pieces: readonly SurfacePiece[]) {
  const middles = pieces.map(({ from, to }, piece) => ({ piece, at: at((from.z + to.z) / 2, (from.r + to.r) / 2) })).sort((a, b) =>
    a.at.z - b.at.z
  );
  const next = Int32Array.from({ length: middles.length + 1 }, (_, i) => i);
  const free = (i: number): number => {
    let to = i;
    while ((next[to] ?? to) !== to) to = next[to] ?? to;
    for (let k = i; (next[k] ?? k) !== k;) [k, next[k]] = [next[k] ?? k, to];
    return to;
  };
  const firstFrom = (z: number) => {
    let [low, high] = [0, middles.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((middles[middle]?.at.z ?? 0) < z) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  /** Asks for each free piece in a box whether it is claimed. */
  return (box: Box, claims: (piece: number, middle: Pt) => boolean): void => {
    for (let i = free(firstFrom(box.left)); i < middles.length; i = free(i + 1)) {
      const each = middles[i] as (typeof middles)[number];
      if (each.at.z > box.right) return;
      if (each.at.r >= box.low && each.at.r <= box.high && claims(each.piece, each.at)) next[i] = i + 1;
    }
  };
}

/**
 * Which move made which piece of a surface: the last feed whose tool touched it. `steps` are the moves since the stock was put into
 * the chuck as it is, `first` the index of the first of them. Time grows with pieces and moves, not with their product: a piece that
 * has its move is not asked again.
 */
export function madeBy(pieces: readonly SurfacePiece[], steps: readonly Step[], first = 0): Made[] {
  const made = pieces.map((piece): Made => ({ ...piece, step: null, tip: piece.from, along: false }));
  const tools = new Map<Tool, Touching>();
  const each = unclaimed(pieces);
  for (let index = steps.length - 1; index >= first; index -= 1) {
    const step = steps[index] as Step;
    if (!makesSurface(step)) continue;
    const tool = tools.get(step.tool) ?? touchingOf(step.tool);
    tools.set(step.tool, tool);
    const path = pathOf(step.from, step.move), box = part.boxOf(path), long = part.lengthOf(path) > SAME;
    const reached = {
      left: box.left + tool.box.left,
      right: box.right + tool.box.right,
      low: box.low + tool.box.low,
      high: box.high + tool.box.high,
    };
    each(reached, (number, middle) => {
      const piece = pieces[number] as SurfacePiece, { out } = piece;
      const ends = tool.ends[number] ??= farthest(tool.shape, flat.scaled(out, -1));
      const tip = tipOn(path, ends.map((end) => at(middle.z - end.u, middle.r - end.v)));
      if (!tip) return false;
      const way = part.direction(path, tip);
      made[number] = { ...piece, step: index, tip, along: long && Math.abs(way.z * out.u + way.r * out.v) < ALONG };
      return true;
    });
  }
  return made;
}
