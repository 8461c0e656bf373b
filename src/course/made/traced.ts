import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { elementsThrough } from "../../kernel/contour/elements-through.ts";

/**
 * A chord within this of an element is on it, mm: the first chord of a rounding that leaves the element is not. Nearer
 * ends are one end.
 */
const NEAR = { chord: 0.003, end: 0.012 } as const;
/** Two elements meet within this of the polygon's corner, mm. */
const MEET = 0.08;
/** Shorter segments between two elements that meet are left over from the polygon, mm. */
const DUST = 0.06;

/** Greatest deviation of lines and arcs from points that are on no element, mm. */
const LEFT_OVER = 0.004;

interface Piece {
  readonly source: Segment | null;
  readonly points: readonly Pt[];
}

/** The distance of a chord from an element, mm. */
function apartFrom(source: Segment, a: Pt, b: Pt): number {
  const middle = part.pointOn(part.line(a, b), 1 / 2);
  return Math.max(...[a, middle, b].map((p) => part.distanceTo(source, p)));
}

/** A chain as pieces, each on one element or on none. */
function piecesOf(chain: readonly Pt[], sources: readonly Segment[]): readonly Piece[] {
  const pieces: { source: Segment | null; points: Pt[] }[] = [];
  for (const [i, a] of chain.entries()) {
    const b = chain[i + 1],
      last = pieces.at(-1);
    if (!b) break;
    const goesOn = last?.source && apartFrom(last.source, a, b) < NEAR.chord;
    let best: Segment | null = goesOn ? last.source : null,
      near: number = NEAR.chord;
    if (!goesOn) {
      for (const source of sources) {
        const apart = apartFrom(source, a, b);
        if (apart < near) [best, near] = [source, apart];
      }
    }
    if (last && last.source === best) last.points.push(b);
    else pieces.push({ source: best, points: [a, b] });
  }
  return pieces;
}

const lengthOf = ({ points }: Piece): number =>
  points.slice(1).reduce((sum, p, i) => sum + part.apart(points[i] ?? p, p), 0);

/** The point where two elements meet near a corner of the polygon; otherwise the corner, on the element that it ends. */
function joint(before: Segment | null, corner: Pt, after: Segment | null): Pt {
  const only = before ?? after;
  if (!only) return corner;
  if (!before || !after) return part.nearestOn(only, corner);
  const ends = [before.from, before.to].filter((p) => [after.from, after.to].some((q) => part.apart(p, q) < NEAR.end));
  const found = [...ends, ...part.meetings(before, after)]
    .map((p) => ({ p, by: part.apart(p, corner) }))
    .sort((a, b) => a.by - b.by)[0];
  return found && found.by < MEET ? found.p : corner;
}

/** An element between two points on it, in the direction of the chain. */
function along(source: Segment, from: Pt, to: Pt, middle: Pt): Segment {
  if (source.kind === "line") return part.line(from, to);
  const whole: Segment = { kind: "arc", from, to, centre: source.centre, turn: "ccw" };
  const other: Segment = { ...whole, turn: "cw" };
  return part.distanceTo(whole, middle) <= part.distanceTo(other, middle) ? whole : other;
}

/**
 * A chain of points as elements of the contours that it came from, with their exact ends; the rest as few lines and
 * arcs. Part space, mm.
 */
export function traced(chain: readonly Pt[], sources: readonly Segment[]): readonly Segment[] {
  const all = piecesOf(chain, sources);
  const isDust = (piece: Piece, i: number) => lengthOf(piece) < DUST && i > 0 && i < all.length - 1;
  const pieces = all.filter((piece, i) => !isDust(piece, i));
  const joints = pieces.slice(1).map((next, i) => {
    const last = pieces[i],
      a = last?.points.at(-1),
      b = next.points[0];
    if (!last || !a || !b) return b ?? a;
    return joint(last.source, part.pointOn(part.line(a, b), 1 / 2), next.source);
  });
  return pieces.flatMap(({ source, points }, i): readonly Segment[] => {
    const [from, to] = [joints[i - 1] ?? points[0], joints[i] ?? points.at(-1)];
    if (!from || !to || part.apart(from, to) < NEAR.end) return [];
    if (!source) return elementsThrough([from, ...points.slice(1, -1), to], { line: LEFT_OVER, arc: LEFT_OVER });
    // The middle of a chord, since a single chord has only the ends that both arcs share.
    const half = Math.floor(points.length / 2),
      [a, b] = [points[half - 1] ?? from, points[half] ?? to];
    return [along(source, from, to, part.pointOn(part.line(a, b), 1 / 2))];
  });
}
