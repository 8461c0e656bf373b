import { edgeEnd, edgeStart, type Convex } from "../../kernel/reach/convex.ts";
import { flat, type Flat } from "../../kernel/geometry/flat.ts";
import { insertShape, shiftOf } from "../../kernel/cutter/insert.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { SAME, SLIVER } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { moved, support } from "../../kernel/reach/convex.ts";
import { touchIndex } from "../touch-index.ts";

/**
 * A surface is looked at in pieces of this length, mm, or longer ones where it is so long that there would be more than
 * MOST.
 */
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
  const edges = stock
    .flatMap((ring) => ring.map((to, i) => ({ from: ring[(i + ring.length - 1) % ring.length] as Pt, to })))
    .filter(({ from, to }) => from.r > SAME || to.r > SAME);
  const size = Math.max(PIECE, edges.reduce((sum, { from, to }) => sum + part.apart(from, to), 0) / MOST);
  return edges.flatMap(({ from, to }) => {
    const long = part.apart(from, to),
      count = Math.ceil(long / size);
    if (!(long > 0)) return [];
    const out: Flat = { u: (to.r - from.r) / long, v: (from.z - to.z) / long };
    const point = (i: number) => part.pointOn({ kind: "line", from, to }, i / count);
    return Array.from({ length: count }, (_, i) => ({ from: point(i), to: point(i + 1), out }));
  });
}

/** The points of an insert that lie farthest in a direction: one, or the two ends of a straight edge. */
function farthest(shape: Convex, out: Flat): readonly Flat[] {
  const { at: best } = support(shape, out),
    most = flat.dot(best, out) - TOUCH / 2;
  const edge = shape.find((e) => e.kind === "line" && flat.dot(e.from, out) > most && flat.dot(e.to, out) > most);
  return edge ? [edgeStart(edge), edgeEnd(edge)] : [best];
}

const cross = (a: Pt, b: Pt, p: Pt) => (b.z - a.z) * (p.r - a.r) - (b.r - a.r) * (p.z - a.z);
/** Places on an edge that are tried against an arc. */
const TRIED = [0, 0.25, 0.5, 0.75, 1] as const;

/**
 * The place on a path nearest to one of the places that a tip may have, where that is near enough; null where it never
 * is.
 */
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

/** Where a tip stood on the path of a move while it touched a piece; null where nothing but its shape can say so. */
function tipOver({ out, from, to }: SurfacePiece, path: Segment, shape: Convex): Pt | null {
  const middle = at((from.z + to.z) / 2, (from.r + to.r) / 2);
  return tipOn(
    path,
    farthest(shape, flat.scaled(out, -1)).map((end) => at(middle.z - end.u, middle.r - end.v)),
  );
}

/**
 * Which move made which piece of a surface: the same one that the picture shows it with, the last feed that has it on
 * the edge of what it swept. `first` is the index of the first step since the stock was put into the chuck as it is.
 */
export function madeBy(pieces: readonly SurfacePiece[], steps: readonly Step[], first = 0): Made[] {
  const touched = touchIndex(steps),
    shapes = new Map<Tool, Convex>(),
    end = { step: steps.length, fraction: 0 };
  return pieces.map((piece): Made => {
    const { from, to, out } = piece;
    const index = touched.latest((from.z + to.z) / 2, (from.r + to.r) / 2, end, first - 1),
      step = steps[index];
    if (!step) return { ...piece, step: null, tip: from, along: false };
    const shape = shapes.get(step.tool) ?? moved(insertShape(step.tool, true), shiftOf(step.tool));
    shapes.set(step.tool, shape);
    const path = pathOf(step.from, step.move),
      tip = tipOver(piece, path, shape);
    if (!tip) return { ...piece, step: index, tip: path.to, along: false };
    const way = part.direction(path, tip);
    return { ...piece, step: index, tip, along: Math.abs(way.z * out.u + way.r * out.v) < ALONG };
  });
}
