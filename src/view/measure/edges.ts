import type { MeasuredEdge } from "../../kernel/plan/measured.ts";
import { part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";

/** A contour as a chain of segments that follow each other. */
export type Chain = readonly Segment[];

/**
 * The measurable geometry of a picture, in its two axes: z to the right and r upwards. In a milled plane z is X, r is Y
 * (`partPoint` of `kernel/plane/plane.ts`), and nothing is turned. All of `view/measure` uses these names.
 */
export interface Measurable {
  /** r counts from a spindle axis: diameters can be measured, and there is nothing on the axis. */
  readonly isTurned: boolean;
  readonly contours: readonly Chain[];
  readonly blank: readonly Chain[];
  /** The stock at the moment that is shown. */
  readonly stock: readonly Chain[];
  /** Ends of moves. */
  readonly path: readonly Pt[];
}

/** Owners of edges, the preferred first. */
const OWNERS = ["contour", "blank", "stock"] as const;
const chainsOf = (drawing: Measurable, of: MeasuredEdge["of"]): readonly Chain[] =>
  of === "contour" ? drawing.contours : drawing[of];

/** Both ends on the spindle axis: where two halves meet there is no surface. */
const onAxis = ({ kind, from, to }: Segment): boolean =>
  kind === "line" && Math.abs(from.r) < SAME && Math.abs(to.r) < SAME;

/** The elements that measuring tools can snap to: of contours, blank, stock. */
export const measurableEdges = (drawing: Measurable): readonly MeasuredEdge[] =>
  OWNERS.flatMap((of) =>
    chainsOf(drawing, of).flatMap((segments, chain) => {
      const shape = shapeOf(drawing, { of, chain });
      return segments.flatMap((segment, element) =>
        (drawing.isTurned && onAxis(segment)) || part.lengthOf(segment) < SAME
          ? []
          : [{ of, chain, element, shape, segment }],
      );
    }),
  );

/** The current segment of a measured edge; undefined if its contour no longer consists of the same elements. */
export function segmentNow(drawing: Measurable, edge: MeasuredEdge): Segment | undefined {
  const segment = chainsOf(drawing, edge.of)[edge.chain]?.[edge.element];
  return segment?.kind === edge.segment.kind && shapeOf(drawing, edge) === edge.shape ? segment : undefined;
}

const PRIME = 31,
  MANY = 0x7fffffff;

/**
 * The elements of an owner's contours as a text: another number of contours, or of lines and arcs in this one, gives
 * another text.
 */
function shapeOf(drawing: Measurable, { of, chain }: Pick<MeasuredEdge, "of" | "chain">): string {
  const chains = chainsOf(drawing, of),
    own = chains[chain] ?? [];
  const kinds = own.reduce((sum, { kind }, i) => (sum * PRIME + (kind === "arc" ? i + 2 : 1)) % MANY, 0);
  return [chains.length, own.length, kinds].join("/");
}

/** Points of a flattened arc are this near to its circle, mm: the grid of the polygon engine, and a little more. */
const ON_ARC = 0.0004;
/** Fewer chords than this are separate corners. */
const FEWEST = 4;
/** Two chords of one arc turn by no more than this, radians. */
const BEND = 0.5;
/** Chords of one arc differ in length by no more than this, except the first and the last, which may be cut. */
const ALIKE = 1.6;

interface Circle {
  readonly centre: Pt;
  readonly size: number;
}

/** The circle through three points; null where they lie on a line. */
function circleThrough(a: Pt, b: Pt, c: Pt): Circle | null {
  const ab = part.difference(b, a),
    ac = part.difference(c, a),
    bend = part.cross(ab, ac) * 2;
  if (Math.abs(bend) < SAME * SAME) return null;
  const [p, q] = [part.dot(ab, ab), part.dot(ac, ac)];
  const centre = part.point(a.z + (ac.r * p - ab.r * q) / bend, a.r + (ab.z * q - ac.z * p) / bend);
  return { centre, size: part.apart(centre, a) };
}

const turnAt = (a: Pt, b: Pt, c: Pt): number => {
  const [u, v] = [part.difference(b, a), part.difference(c, b)];
  return Math.atan2(part.cross(u, v), part.dot(u, v));
};

interface Found extends Circle {
  readonly last: number;
  readonly turn: number;
}

/** The circle through the points from one to another, whose end chords may be cut; null if there is none. */
function circleOf(points: readonly Pt[], first: number, last: number): Circle | null {
  const [a, b, c] = [points[first + 1], points[(first + last) >> 1], points[last - 1]];
  const circle = a && b && c ? circleThrough(a, b, c) : null;
  if (!circle) return null;
  const isOn = (i: number) => {
    const p = points[i],
      allowed = i === first || i === last ? CHORD + ON_ARC : ON_ARC;
    return p !== undefined && Math.abs(part.apart(p, circle.centre) - circle.size) < allowed;
  };
  for (let i = first; i <= last; i += 1) if (!isOn(i)) return null;
  return circle;
}

/** The farthest point up to which the outline turns like the chords of one arc. */
function turningUntil(points: readonly Pt[], first: number): { readonly last: number; readonly turn: number } {
  const [a, b, c] = [points[first], points[first + 1], points[first + 2]];
  if (!a || !b || !c) return { last: first, turn: 0 };
  const turn = turnAt(a, b, c),
    long = part.apart(b, c);
  let last = first + 1;
  for (let i = first + 2; i < points.length; i += 1) {
    const [o, p, q] = [points[i - 2], points[i - 1], points[i]];
    const bent = o && p && q ? turnAt(o, p, q) : 0;
    if (!p || !q || Math.sign(bent) !== Math.sign(turn) || Math.abs(bent) > BEND || part.apart(p, q) > ALIKE * long)
      break;
    last = i;
  }
  return { last, turn };
}

/** The arc that begins at a point, as far as it goes; null where there are corners. */
function arcFrom(points: readonly Pt[], first: number): Found | null {
  const { last: farthest, turn } = turningUntil(points, first);
  for (let last = farthest; last - first >= FEWEST; last -= 1) {
    const circle = circleOf(points, first, last);
    if (circle) return { ...circle, last, turn };
  }
  return null;
}

/** Removes points in the middle of straight lines. */
function withoutFlat(ring: Ring): Pt[] {
  return ring.filter((p, i) => {
    const [a, c] = [ring[(i + ring.length - 1) % ring.length], ring[(i + 1) % ring.length]];
    return !a || !c || part.apart(part.nearestOn({ kind: "line", from: a, to: c }, p), p) > ROUNDED;
  });
}
/** A point nearer to the line between its neighbours is no corner, mm: what the polygon engine rounds. */
const ROUNDED = 0.00002;

/**
 * The outline of a polygon as lines and arcs: chords on one circle, which material removal makes from the arcs of tools
 * and contours, become that arc again. It begins at the sharpest corner, so that no arc is split.
 */
export function chainOfRing(ring: Ring): Chain {
  const clean = withoutFlat(ring);
  if (clean.length < 3) return [];
  const sharp = clean.map((p, i) =>
    Math.abs(turnAt(clean[(i + clean.length - 1) % clean.length] ?? p, p, clean[(i + 1) % clean.length] ?? p)),
  );
  const begin = sharp.indexOf(Math.max(...sharp));
  const points = [...clean.slice(begin), ...clean.slice(0, begin + 1)];
  const chain: Segment[] = [];
  for (let i = 0; i + 1 < points.length;) {
    const arc = arcFrom(points, i),
      from = points[i],
      to = points[arc?.last ?? i + 1];
    if (!from || !to) break;
    chain.push(
      arc
        ? { kind: "arc", from, to, centre: arc.centre, turn: arc.turn > 0 ? "ccw" : "cw" }
        : { kind: "line", from, to },
    );
    i = arc?.last ?? i + 1;
  }
  return chain;
}
