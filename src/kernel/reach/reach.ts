import { edgeEnd, edgeStart, normalEnd, normalStart, type Convex, type Edge, type Feature } from "./convex.ts";
import { linePiece, upperEnvelope, type Envelope, type Interval, type Origin, type EnvelopePiece } from "./envelope.ts";
import { flat, normalAt, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { FULL_TURN, positive, type ArcOf, type LineOf } from "../geometry/segments.ts";
import { JOINED, NOTHING, ROUND } from "../tolerance.ts";

const { angleOf, cross, dot, onCircle, polarOf, scaled, sum } = flat;

/** A contour element and its kind. */
export interface Bound {
  readonly segment: FlatSegment;
  readonly on: Origin["on"];
}

/**
 * The lowest tip positions over a chain of contour elements: the upper boundary of material ⊕ mirrored insert, exact in
 * lines and arcs (decision "Reach"). The chain runs with the material on its right; `insert` is relative to the tip, in
 * the same space. Each piece is a pair of a contour element and an insert element with the same normal, so every piece
 * is inside the sum, and the uppermost ones bound it.
 */
export function reachOver(bounds: readonly Bound[], insert: Convex): Envelope {
  const chain = bounds.flatMap(closedArc);
  const k = hullOf(insert);
  const pieces: EnvelopePiece[] = [];
  const add = (p: EnvelopePiece | null) => {
    if (p) pieces.push(p);
  };
  chain.forEach((b, i) => {
    const s = b.segment;
    if (s.kind === "line") alongLine(s, k, b.on, add);
    else alongArc(s, k, b.on, add);
    const next = chain[i + 1];
    if (i === 0) atCorner(s.from, { u: -1, v: 0 }, facingUp(normalAt(s, "from")), k, b.on, add);
    if (next)
      atCorner(s.to, normalAt(s, "to"), normalAt(next.segment, "from"), k, b.on === "contour" ? b.on : next.on, add);
    else atCorner(s.to, facingUp(normalAt(s, "to")), { u: 1, v: 0 }, k, b.on, add);
  });
  return upperEnvelope(pieces);
}

/**
 * An arc whose rounded end is off its circle, with the step from the circle to that end: a gap as wide as the step would
 * let the insert through.
 */
function closedArc(bound: Bound): readonly Bound[] {
  const { segment: s, on } = bound;
  if (s.kind === "line") return [bound];
  const { start, sweep, startRadius } = polarOf(s);
  const end = onCircle(s.centre, startRadius, start + sweep);
  if (flat.apart(end, s.to) <= ROUND) return [bound];
  return [
    { segment: { ...s, to: end }, on },
    { segment: { kind: "line", from: end, to: s.to }, on },
  ];
}

/** A normal at an end of the chain; for an overhanging element, the flattest normal that still faces up. */
const facingUp = (n: Flat): Flat => (n.v >= 0 ? n : { u: Math.sign(n.u), v: 0 });

/**
 * {−q} of the insert, reduced to the elements that can face up: normals in (0, π), split there. Edges run
 * counter-clockwise.
 */
function mirroredLowerHull(insert: Convex): Edge[] {
  return insert.flatMap((e): Edge[] => {
    if (e.kind === "line") {
      const m: Edge = { ...e, from: scaled(e.from, -1), to: scaled(e.to, -1) };
      return m.to.u < m.from.u - NOTHING ? [m] : [];
    }
    const start = positive(e.start + Math.PI);
    const parts: Edge[] = [];
    for (const turn of [0, -FULL_TURN]) {
      const from = Math.max(0, start + turn);
      const to = Math.min(Math.PI, start + turn + e.sweep);
      if (to >= from) parts.push({ ...e, centre: scaled(e.centre, -1), start: from, sweep: to - from });
    }
    return parts;
  });
}

/** The elements of the mirrored insert that can face up, and its corners with their cone of normals. */
interface Hull {
  readonly edges: readonly Edge[];
  readonly vertices: readonly Vertex[];
}
interface Vertex {
  readonly at: Flat;
  readonly from: number;
  readonly to: number;
  readonly feature: Feature;
}

/** Hulls of inserts without an oversize: they are the same for each contour. */
const hulls = new WeakMap<Convex, Hull>();

function hullOf(insert: Convex): Hull {
  const known = hulls.get(insert);
  if (known) return known;
  const edges = mirroredLowerHull(insert);
  const made = { edges, vertices: vertices(edges) };
  hulls.set(insert, made);
  return made;
}

/** Vertices of the hull with their cone of normals, and their feature. */
function vertices(k: readonly Edge[]): Vertex[] {
  // Order along the boundary: an edge and the arc that follows it share a normal, so the middle of their normals
  // decides.
  const middle = (e: Edge) => normalStart(e) + normalEnd(e);
  const ordered = [...k].sort((a, b) => middle(a) - middle(b));
  const first = ordered[0];
  const last = ordered[ordered.length - 1];
  if (!first || !last) return [];
  const out = [{ at: edgeStart(first), from: 0, to: Math.max(0, normalStart(first)), feature: first.feature }];
  ordered.forEach((e, i) => {
    const next = ordered[i + 1];
    out.push({
      at: edgeEnd(e),
      from: normalEnd(e),
      to: next ? normalStart(next) : Math.PI,
      feature: e.feature === "nose" && next ? next.feature : e.feature,
    });
  });
  return out.filter((v) => v.to - v.from > ROUND);
}

function alongLine(s: LineOf<Flat>, k: Hull, on: Origin["on"], add: (p: EnvelopePiece | null) => void) {
  if (s.to.u - s.from.u <= 0) return;
  const a = angleOf(normalAt(s, "from"));
  const shift = (by: Flat, feature: Feature) =>
    add(linePiece(sum(s.from, by), sum(s.to, by), { feature, on, corner: false }));
  let parallel = false;
  for (const e of k.edges)
    if (e.kind === "line" && Math.abs(a - normalStart(e)) <= ROUND) {
      // Two parallel lines sum to one: from the left end of the edge at the start to its right end at the end.
      add(linePiece(sum(s.from, e.to), sum(s.to, e.from), { feature: e.feature, on, corner: false }));
      parallel = true;
    }
  if (parallel) return;
  for (const e of k.edges)
    if (e.kind === "arc" && a >= e.start - ROUND && a <= e.start + e.sweep + ROUND)
      return shift(onCircle(e.centre, e.radius, a), e.feature);
  for (const v of k.vertices) if (a >= v.from - ROUND && a <= v.to + ROUND) return shift(v.at, v.feature);
}

/** The material is on the right, so an arc that turns left is concave. */
const isValley = (s: ArcOf<Flat>) => s.turn === "ccw";

/** An arc of the contour: its outward normals, and the insert elements with the same normal. */
function alongArc(s: ArcOf<Flat>, k: Hull, on: Origin["on"], add: (p: EnvelopePiece | null) => void) {
  const { start, sweep, startRadius: radius } = polarOf(s);
  const valley = isValley(s);
  // Normals, counter-clockwise from `low`: the polar angle for a convex arc, the opposite angle for a concave one.
  const low = positive(valley ? start + Math.PI : start + sweep);
  for (const turn of [0, -FULL_TURN]) {
    const from = Math.max(0, low + turn);
    const to = Math.min(Math.PI, low + turn + Math.abs(sweep));
    if (to - from <= ROUND) continue;
    for (const e of k.edges) {
      if (e.kind === "arc") {
        const r = valley ? radius - e.radius : radius + e.radius;
        const normals = { from: Math.max(from, e.start), to: Math.min(to, e.start + e.sweep) };
        add(halfArc(s, e.centre, r, normals, { feature: e.feature, on, corner: false }));
      } else {
        const n = normalStart(e);
        if (n < from - ROUND || n > to + ROUND) continue;
        const at = onCircle(s.centre, valley ? -radius : radius, n);
        add(linePiece(sum(at, e.from), sum(at, e.to), { feature: e.feature, on, corner: true }));
      }
    }
    for (const v of k.vertices)
      add(
        halfArc(
          s,
          v.at,
          radius,
          { from: Math.max(from, v.from), to: Math.min(to, v.to) },
          { feature: v.feature, on, corner: false },
        ),
      );
  }
}

/**
 * The part of an offset arc with given normals: upper half for a convex arc, lower half for a concave one. Null if
 * there is none.
 */
function halfArc(s: ArcOf<Flat>, by: Flat, r: number, { from, to }: Interval, origin: Origin): EnvelopePiece | null {
  if (to - from <= ROUND || r <= ROUND) return null;
  const { u: cu, v: cv } = sum(s.centre, by);
  const [u0, u1] = isValley(s)
    ? [cu - r * Math.cos(from), cu - r * Math.cos(to)]
    : [cu + r * Math.cos(to), cu + r * Math.cos(from)];
  return u1 - u0 > ROUND ? { arc: isValley(s) ? -1 : 1, u0, u1, cu, cv, radius: r, origin } : null;
}

/** A convex corner has all normals between those of its two elements (clockwise from `before` to `after`). */
function atCorner(
  p: Flat,
  before: Flat,
  after: Flat,
  k: Hull,
  on: Origin["on"],
  add: (p: EnvelopePiece | null) => void,
) {
  const bend = cross(before, after);
  if (bend > -NOTHING && dot(before, after) > 0) return; // smooth or reflex
  if (bend > NOTHING) return;
  const high = angleOf(before);
  const width = positive(high - angleOf(after));
  for (const turn of [0, FULL_TURN, -FULL_TURN]) {
    const to = Math.min(Math.PI, high + turn);
    const from = Math.max(0, high + turn - width);
    if (to < from - ROUND) continue;
    for (const e of k.edges) {
      if (e.kind === "line") {
        const n = normalStart(e);
        if (n >= from - JOINED && n <= to + JOINED)
          add(linePiece(sum(p, e.from), sum(p, e.to), { feature: e.feature, on, corner: true }));
        continue;
      }
      const a = Math.max(from, e.start);
      const b = Math.min(to, e.start + e.sweep);
      if (b - a <= ROUND || e.radius <= ROUND) continue;
      const { u: cu, v: cv } = sum(p, e.centre);
      add({
        arc: 1,
        u0: cu + e.radius * Math.cos(b),
        u1: cu + e.radius * Math.cos(a),
        cu,
        cv,
        radius: e.radius,
        origin: { feature: e.feature, on, corner: false },
      });
    }
  }
}
