import { edgeEnd, edgeStart, normalEnd, normalStart, positive, type Convex, type Edge, type Feature } from "./convex.ts";
import { linePiece, upperEnvelope, type Envelope, type Origin, type Piece } from "./envelope.ts";
import { normalAt, type Flat, type FlatSegment } from "./flat.ts";

/** A contour element with what it stands for. */
export interface Bound {
  readonly segment: FlatSegment;
  readonly on: Origin["on"];
}

/**
 * The lowest positions of the tip over a chain of contour elements: the upper boundary of material ⊕ mirrored insert,
 * exact in lines and arcs (decision "Reach"). The chain runs with the material on its right; `insert` is relative to the
 * tip, in the same space. Each piece is a pair of a contour element and an insert element with the same normal, so every
 * piece lies in the sum, and the uppermost ones bound it.
 */
export function reachOver(chain: readonly Bound[], insert: Convex): Envelope {
  const edges = mirroredLowerHull(insert);
  const k: Hull = { edges, vertices: vertices(edges) };
  const pieces: Piece[] = [];
  const add = (p: Piece | null) => { if (p) pieces.push(p); };
  chain.forEach((b, i) => {
    const s = b.segment;
    if (s.kind === "line") alongLine(s, k, b.on, add);
    else alongArc(s, k, b.on, add);
    const next = chain[i + 1];
    if (i === 0) atCorner(s.from, { u: -1, v: 0 }, facingUp(normalAt(s, "from")), k, b.on, add);
    if (next) atCorner(s.to, normalAt(s, "to"), normalAt(next.segment, "from"), k, b.on === "contour" ? b.on : next.on, add);
    else atCorner(s.to, facingUp(normalAt(s, "to")), { u: 1, v: 0 }, k, b.on, add);
  });
  return upperEnvelope(pieces);
}

/** A normal at an end of the chain; of an element that hangs over there, as flat as one that faces up can be. */
const facingUp = (n: Flat): Flat => (n.v >= 0 ? n : { u: Math.sign(n.u), v: 0 });

/** {−q} of the insert, only the elements that can face up: normals in (0, π), split there. Edges run counter-clockwise. */
function mirroredLowerHull(insert: Convex): Edge[] {
  return insert.flatMap((e): Edge[] => {
    if (e.kind === "line") {
      const m: Edge = { ...e, from: { u: -e.from.u, v: -e.from.v }, to: { u: -e.to.u, v: -e.to.v } };
      return m.to.u < m.from.u - 1e-12 ? [m] : [];
    }
    const start = positive(e.start + Math.PI);
    const parts: Edge[] = [];
    for (const turn of [0, -2 * Math.PI]) {
      const from = Math.max(0, start + turn);
      const to = Math.min(Math.PI, start + turn + e.sweep);
      if (to >= from) parts.push({ ...e, centre: { u: -e.centre.u, v: -e.centre.v }, start: from, sweep: to - from });
    }
    return parts;
  });
}

/** What can face up on the mirrored insert: its elements, and its corners with the cone of normals they carry. */
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

const ANGLE = 1e-9;
const angleOf = (n: Flat) => Math.atan2(n.v, n.u);

/** Vertices of the hull with the cone of normals they carry, and what they belong to. */
function vertices(k: readonly Edge[]): Vertex[] {
  // Along the boundary: an edge and the arc it runs into share a normal, so the middle of what each carries decides.
  const middle = (e: Edge) => normalStart(e) + normalEnd(e);
  const ordered = [...k].sort((a, b) => middle(a) - middle(b));
  const first = ordered[0];
  const last = ordered[ordered.length - 1];
  if (!first || !last) return [];
  const out = [{ at: edgeStart(first), from: 0, to: Math.max(0, normalStart(first)), feature: first.feature }];
  ordered.forEach((e, i) => {
    const next = ordered[i + 1];
    out.push({ at: edgeEnd(e), from: normalEnd(e), to: next ? normalStart(next) : Math.PI, feature: e.feature === "nose" && next ? next.feature : e.feature });
  });
  return out.filter((v) => v.to - v.from > ANGLE);
}

function alongLine(s: Extract<FlatSegment, { kind: "line" }>, k: Hull, on: Origin["on"], add: (p: Piece | null) => void) {
  if (s.to.u - s.from.u <= 0) return;
  const a = angleOf(normalAt(s, "from"));
  const shift = (by: Flat, feature: Feature) =>
    add(linePiece({ u: s.from.u + by.u, v: s.from.v + by.v }, { u: s.to.u + by.u, v: s.to.v + by.v }, { feature, on, corner: false }));
  let parallel = false;
  for (const e of k.edges)
    if (e.kind === "line" && Math.abs(a - normalStart(e)) <= ANGLE) {
      // Two parallel straights sum to one: from the left end of the edge at the start to its right end at the end.
      add(linePiece({ u: s.from.u + e.to.u, v: s.from.v + e.to.v }, { u: s.to.u + e.from.u, v: s.to.v + e.from.v }, { feature: e.feature, on, corner: false }));
      parallel = true;
    }
  if (parallel) return;
  for (const e of k.edges)
    if (e.kind === "arc" && a >= e.start - ANGLE && a <= e.start + e.sweep + ANGLE)
      return shift({ u: e.centre.u + e.radius * Math.cos(a), v: e.centre.v + e.radius * Math.sin(a) }, e.feature);
  for (const v of k.vertices) if (a >= v.from - ANGLE && a <= v.to + ANGLE) return shift(v.at, v.feature);
}

/** An arc of the contour: its outward normals, and the insert elements with the same normal. */
function alongArc(s: Extract<FlatSegment, { kind: "arc" }>, k: Hull, on: Origin["on"], add: (p: Piece | null) => void) {
  const radius = Math.hypot(s.from.u - s.centre.u, s.from.v - s.centre.v);
  const a0 = Math.atan2(s.from.v - s.centre.v, s.from.u - s.centre.u);
  const a1 = Math.atan2(s.to.v - s.centre.v, s.to.u - s.centre.u);
  let sweep = positive(s.ccw ? a1 - a0 : a0 - a1);
  if (sweep < 1e-12) sweep = 2 * Math.PI;
  // Normals, counter-clockwise from `low`: of a hill (cw) the polar angle itself, of a valley (ccw) the opposite one.
  const low = positive((s.ccw ? a0 + Math.PI : a1));
  for (const turn of [0, -2 * Math.PI]) {
    const from = Math.max(0, low + turn);
    const to = Math.min(Math.PI, low + turn + sweep);
    if (to - from <= ANGLE) continue;
    for (const e of k.edges) {
      if (e.kind === "arc") {
        const r = s.ccw ? radius - e.radius : radius + e.radius;
        halfArc(s, e.centre, r, Math.max(from, e.start), Math.min(to, e.start + e.sweep), { feature: e.feature, on, corner: false }, add);
      } else {
        const n = normalStart(e);
        if (n < from - ANGLE || n > to + ANGLE) continue;
        const d = s.ccw ? -radius : radius;
        const at = { u: s.centre.u + d * Math.cos(n), v: s.centre.v + d * Math.sin(n) };
        add(linePiece({ u: at.u + e.from.u, v: at.v + e.from.v }, { u: at.u + e.to.u, v: at.v + e.to.v }, { feature: e.feature, on, corner: true }));
      }
    }
    for (const v of k.vertices)
      halfArc(s, v.at, radius, Math.max(from, v.from), Math.min(to, v.to), { feature: v.feature, on, corner: false }, add);
  }
}

/** The part of an offset arc whose normals lie in [from, to]: upper half for a hill, lower half for a valley. */
function halfArc(s: Extract<FlatSegment, { kind: "arc" }>, by: Flat, r: number, from: number, to: number, origin: Origin, add: (p: Piece | null) => void) {
  if (to - from <= ANGLE || r <= 1e-9) return;
  const cu = s.centre.u + by.u;
  const cv = s.centre.v + by.v;
  const x0 = s.ccw ? cu - r * Math.cos(from) : cu + r * Math.cos(to);
  const x1 = s.ccw ? cu - r * Math.cos(to) : cu + r * Math.cos(from);
  if (x1 - x0 > 1e-9) add({ arc: s.ccw ? -1 : 1, u0: x0, u1: x1, cu, cv, radius: r, origin });
}

/** A convex corner carries the normals between its two elements (clockwise from `before` to `after`). */
function atCorner(p: Flat, before: Flat, after: Flat, k: Hull, on: Origin["on"], add: (p: Piece | null) => void) {
  const cross = before.u * after.v - before.v * after.u;
  const dot = before.u * after.u + before.v * after.v;
  if (cross > -1e-12 && dot > 0) return; // smooth or reflex
  if (cross > 1e-12) return;
  const high = angleOf(before);
  const width = positive(high - angleOf(after));
  for (const turn of [0, 2 * Math.PI, -2 * Math.PI]) {
    const to = Math.min(Math.PI, high + turn);
    const from = Math.max(0, high + turn - width);
    if (to < from - ANGLE) continue;
    for (const e of k.edges) {
      if (e.kind === "line") {
        const n = normalStart(e);
        if (n >= from - 1e-7 && n <= to + 1e-7)
          add(linePiece({ u: p.u + e.from.u, v: p.v + e.from.v }, { u: p.u + e.to.u, v: p.v + e.to.v }, { feature: e.feature, on, corner: true }));
        continue;
      }
      const a = Math.max(from, e.start);
      const b = Math.min(to, e.start + e.sweep);
      if (b - a <= ANGLE || e.radius <= 1e-9) continue;
      const cu = p.u + e.centre.u;
      const cv = p.v + e.centre.v;
      add({ arc: 1, u0: cu + e.radius * Math.cos(b), u1: cu + e.radius * Math.cos(a), cu, cv, radius: e.radius, origin: { feature: e.feature, on, corner: false } });
    }
  }
}
