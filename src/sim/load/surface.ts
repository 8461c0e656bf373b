import { edgeEnd, edgeStart, type Convex } from "../../kernel/reach/convex.ts";
import { flat, type Flat } from "../../kernel/geometry/flat.ts";
import { insertShape, correctionShift } from "../../kernel/cutter/insert.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { SAME, SLIVER } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { moved, support } from "../../kernel/reach/convex.ts";
import { touchIndex } from "../touch-index.ts";

/** Length of surface pieces, mm, and their greatest number; longer surfaces get longer pieces. */
const PIECE = 0.5;
const MOST = 4000;
/** Tolerance for a tool to have made a surface, mm: stock and path are chords. */
const TOUCH = SLIVER;
/** A move runs along a surface when the sine of their angle is below this. */
const ALONG = 0.1;

/** A short straight piece of a stock's surface, with the work on its left. */
export interface SurfacePiece {
  readonly from: Pt;
  readonly to: Pt;
  /** Out of the work, length 1. */
  readonly out: Flat;
}

/** A surface piece with the move that made it. */
export interface SurfaceOrigin extends SurfacePiece {
  /** Index of the last feed that touched it; null: unmachined in this clamping. */
  readonly step: number | null;
  /** Tip position at the middle of the piece. */
  readonly tip: Pt;
  /** True when the tool moved along the piece; else it left its shape at the start or end of its move. */
  readonly along: boolean;
}

/** The outlines of a stock in short pieces, without the axis. */
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
/** Sample points of an edge tested against an arc, as fractions. */
const TRIED = [0, 0.25, 0.5, 0.75, 1] as const;

/** The path point nearest to one of the possible tip positions, within tolerance; null where there is none. */
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

/** The tip position on a move's path where it touched a piece; null where only the tool's shape can have touched it. */
function tipOver({ out, from, to }: SurfacePiece, path: Segment, shape: Convex): Pt | null {
  const middle = at((from.z + to.z) / 2, (from.r + to.r) / 2);
  return tipOn(
    path,
    farthest(shape, flat.scaled(out, -1)).map((end) => at(middle.z - end.u, middle.r - end.v)),
  );
}

/**
 * The move that made each piece of a surface: the last feed that has the piece on the edge of its sweep, as in the
 * picture. `first`: index of the first step in the present clamping.
 */
export function surfaceOrigins(pieces: readonly SurfacePiece[], steps: readonly Step[], first = 0): SurfaceOrigin[] {
  const touched = touchIndex(steps),
    shapes = new Map<Tool, Convex>(),
    end = { step: steps.length, fraction: 0 };
  return pieces.map((piece): SurfaceOrigin => {
    const { from, to, out } = piece;
    const index = touched.latest((from.z + to.z) / 2, (from.r + to.r) / 2, end, first - 1),
      step = steps[index];
    if (!step) return { ...piece, step: null, tip: from, along: false };
    const shape = shapes.get(step.tool) ?? moved(insertShape(step.tool, true), correctionShift(step.tool));
    shapes.set(step.tool, shape);
    const path = pathOf(step.from, step.move),
      tip = tipOver(piece, path, shape);
    if (!tip) return { ...piece, step: index, tip: path.to, along: false };
    const way = part.direction(path, tip);
    return { ...piece, step: index, tip, along: Math.abs(way.z * out.u + way.r * out.v) < ALONG };
  });
}
