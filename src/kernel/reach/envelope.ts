import type { Feature } from "./convex.ts";
import { flat, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { hypotenuse } from "../geometry/vectors.ts";
import { JOINED, NOTHING, ROUND } from "../tolerance.ts";

/** Origin of a piece of the envelope: the insert feature that touches, and the kind of contour element it touches. */
export interface Origin {
  readonly feature: Feature;
  /** "contour": the drawn contour; the others bound the area and do not belong to the part. */
  readonly on: "contour" | "bridge" | "limit" | "cutLength" | "edge";
  /** True when a straight insert edge touches a corner of the contour instead of the nose touching its surface. */
  readonly corner: boolean;
}

/** A graph over u: a straight line, or the upper (1) or lower (−1) half of a circle. */
export type EnvelopePiece = { readonly u0: number; readonly u1: number; readonly origin: Origin } & (Sloping | Round);
type Sloping = { readonly arc: 0; readonly v0: number; readonly slope: number };
type Round = { readonly arc: 1 | -1; readonly cu: number; readonly cv: number; readonly radius: number };

/** A section of the envelope: one piece, between u0 and u1. */
export interface Span {
  readonly piece: EnvelopePiece;
  readonly u0: number;
  readonly u1: number;
}

/** The uppermost pieces, from left to right; there may be gaps between them (nothing there: −∞). */
export type Envelope = readonly Span[];

export function valueAt(p: EnvelopePiece, u: number): number {
  if (p.arc === 0) return p.v0 + p.slope * (u - p.u0);
  const d = p.radius * p.radius - (u - p.cu) * (u - p.cu);
  return p.cv + p.arc * (d > 0 ? Math.sqrt(d) : 0);
}

/** A straight piece between two points, in either order; null when it is vertical. */
export function linePiece(a: Flat, b: Flat, origin: Origin): EnvelopePiece | null {
  const [p, q] = a.u <= b.u ? [a, b] : [b, a];
  if (q.u - p.u < ROUND) return null;
  return { arc: 0, u0: p.u, u1: q.u, v0: p.v, slope: (q.v - p.v) / (q.u - p.u), origin };
}

/** The upper envelope of any number of pieces; exact up to rounding, in O(n log n) for n pieces with few crossings. */
export function upperEnvelope(pieces: readonly EnvelopePiece[]): Envelope {
  let level: Span[][] = pieces
    .filter((p) => p.u1 - p.u0 > ROUND)
    .map((piece) => [{ piece, u0: piece.u0, u1: piece.u1 }]);
  level.sort((a, b) => (a[0] as Span).u0 - (b[0] as Span).u0);
  while (level.length > 1) {
    const next: Span[][] = [];
    for (let i = 0; i < level.length; i += 2) {
      const a = level[i] as Span[];
      const b = level[i + 1];
      next.push(b ? merge(a, b) : a);
    }
    level = next;
  }
  return level[0] ?? [];
}

/** The higher of two envelopes at every u. */
export const higherOf = (a: Envelope, b: Envelope): Envelope => merge(a, b);

function merge(a: readonly Span[], b: readonly Span[]): Span[] {
  const out: Span[] = [];
  let i = 0;
  let j = 0;
  let at = Math.min(a[0]?.u0 ?? Infinity, b[0]?.u0 ?? Infinity);
  while (i < a.length || j < b.length) {
    const f = a[i];
    const g = b[j];
    if (f && f.u1 <= at + ROUND) {
      i++;
      continue;
    }
    if (g && g.u1 <= at + ROUND) {
      j++;
      continue;
    }
    const inF = f !== undefined && f.u0 <= at + ROUND;
    const inG = g !== undefined && g.u0 <= at + ROUND;
    const end = Math.min(inF ? f.u1 : (f?.u0 ?? Infinity), inG ? g.u1 : (g?.u0 ?? Infinity));
    if (inF && inG) higher(out, f.piece, g.piece, at, end);
    else if (inF) push(out, f.piece, at, end);
    else if (inG) push(out, g.piece, at, end);
    at = end;
  }
  return out;
}

/** Adds a section to an envelope under construction, joined to the last one if it continues it. */
export function push(out: Span[], piece: EnvelopePiece, u0: number, u1: number) {
  if (u1 - u0 <= 0) return;
  const last = out.at(-1);
  if (last && sameLine(last.piece, piece) && u0 - last.u1 <= ROUND)
    out[out.length - 1] = { piece: last.piece, u0: last.u0, u1 };
  else out.push({ piece, u0, u1 });
}

/**
 * Whether one piece continues another: the same piece, or one at the same level, as on the floors of plunges side by
 * side.
 */
const sameLine = (p: EnvelopePiece, q: EnvelopePiece): boolean =>
  p === q || (p.arc === 0 && q.arc === 0 && p.slope === 0 && q.slope === 0 && p.v0 === q.v0 && p.origin === q.origin);

/** Both pieces cover [u0, u1]: the higher one wins between their crossings. */
function higher(out: Span[], f: EnvelopePiece, g: EnvelopePiece, u0: number, u1: number) {
  const cuts = crossings(f, g, u0, u1);
  let from = u0;
  for (let i = 0; i <= cuts.length; i += 1) {
    const cut = cuts[i] ?? u1,
      middle = (from + cut) / 2;
    push(out, valueAt(f, middle) >= valueAt(g, middle) ? f : g, from, cut);
    from = cut;
  }
}

/** Shared empty result: most pairs of pieces do not cross. */
const NOWHERE: readonly number[] = [];

/** Places u, strictly inside (lo, hi), where two pieces have the same v; ascending. */
export function crossings(f: EnvelopePiece, g: EnvelopePiece, lo: number, hi: number): readonly number[] {
  const isWithin = (u: number): boolean => u > lo + ROUND && u < hi - ROUND;
  if (f.arc === 0 && g.arc === 0) {
    const u = lineLine(f, g);
    return isWithin(u) ? [u] : NOWHERE;
  }
  const [one, other] = f.arc === 0 ? lineArc(f, g as Arc) : g.arc === 0 ? lineArc(g, f) : arcArc(f, g);
  const first = Math.min(one, other),
    second = Math.max(one, other),
    isFirst = isWithin(first),
    isSecond = isWithin(second);
  if (isFirst) return isSecond ? [first, second] : [first];
  return isSecond ? [second] : NOWHERE;
}

type Line = Extract<EnvelopePiece, { arc: 0 }>;
type Arc = Extract<EnvelopePiece, { arc: 1 | -1 }>;
/** Two places u of a crossing, infinite where there is none. */
type Crossed = readonly [number, number];
const APART: Crossed = [Infinity, Infinity];

function lineLine(f: Line, g: Line): number {
  const k = f.slope - g.slope;
  return Math.abs(k) > NOTHING ? (g.v0 - g.slope * g.u0 - (f.v0 - f.slope * f.u0)) / k : Infinity;
}

function lineArc(l: Line, c: Arc): Crossed {
  const k = l.v0 - l.slope * (l.u0 - c.cu) - c.cv; // v of the line above the centre, at u = cu
  const a = 1 + l.slope * l.slope;
  const d = c.radius * c.radius * a - k * k;
  if (d < -ROUND) return APART;
  const root = Math.sqrt(Math.max(0, d));
  const on = (s: number): number => {
    const x = (-l.slope * k + s) / a;
    return (k + l.slope * x) * c.arc >= -ROUND ? c.cu + x : Infinity;
  };
  return [on(-root), on(root)];
}

function arcArc(f: Arc, g: Arc): Crossed {
  const du = g.cu - f.cu;
  const dv = g.cv - f.cv;
  const d = hypotenuse(du, dv);
  if (d < NOTHING) return APART;
  const along = (d * d + f.radius * f.radius - g.radius * g.radius) / (2 * d);
  const h2 = f.radius * f.radius - along * along;
  if (h2 < -ROUND) return APART;
  const h = Math.sqrt(Math.max(0, h2));
  const on = (s: number): number => {
    const u = (along * du - s * dv) / d;
    const v = (along * dv + s * du) / d;
    return v * f.arc >= -ROUND && (v - dv) * g.arc >= -ROUND ? f.cu + u : Infinity;
  };
  return [on(-h), on(h)];
}

/** v of the envelope at u: the higher side at a jump, −∞ in a gap. */
export function heightAt(e: Envelope, u: number): number {
  let best = -Infinity;
  for (let i = firstSpan(e, u); i < e.length; i++) {
    const s = e[i] as Span;
    if (s.u0 > u + ROUND) break;
    if (s.u1 >= u - ROUND) best = Math.max(best, valueAt(s.piece, Math.min(Math.max(u, s.u0), s.u1)));
  }
  return best;
}

/** Index of the first span that ends at or after u. */
export function firstSpan(e: Envelope, u: number): number {
  let lo = 0;
  let hi = e.length;
  while (lo < hi) {
    const m = (lo + hi) >> 1;
    if ((e[m] as Span).u1 < u - ROUND) lo = m + 1;
    else hi = m;
  }
  return lo;
}

/** Lowest v of the envelope over [u0, u1]; a gap inside counts as −∞. */
export function lowest(e: Envelope, u0: number, u1: number): number {
  let low = Infinity;
  let covered = u0;
  for (let i = firstSpan(e, u0); i < e.length; i++) {
    const s = e[i] as Span;
    if (s.u0 >= u1) break;
    if (s.u0 > covered + ROUND) return -Infinity;
    const [a, b] = [Math.max(u0, s.u0), Math.min(u1, s.u1)];
    if (b < a) continue;
    low = Math.min(low, valueAt(s.piece, a), valueAt(s.piece, b));
    if (s.piece.arc === -1 && s.piece.cu > a && s.piece.cu < b) low = Math.min(low, s.piece.cv - s.piece.radius);
    covered = Math.max(covered, s.u1);
  }
  return covered < u1 - ROUND ? -Infinity : low;
}

/** Highest v of the envelope over [u0, u1], and where; gaps do not count. */
export function highest(e: Envelope, u0: number, u1: number): { u: number; v: number } {
  let u = u0,
    v = -Infinity;
  for (let i = firstSpan(e, u0); i < e.length; i++) {
    const s = e[i] as Span,
      { piece } = s;
    if (s.u0 > u1) break;
    const a = Math.max(u0, s.u0),
      b = Math.min(u1, s.u1);
    if (b < a) continue;
    const va = valueAt(piece, a),
      vb = valueAt(piece, b);
    if (va > v) [u, v] = [a, va];
    if (vb > v) [u, v] = [b, vb];
    if (piece.arc === 1 && piece.cu > a && piece.cu < b && piece.cv + piece.radius > v)
      [u, v] = [piece.cu, piece.cv + piece.radius];
  }
  return { u, v };
}

/** An interval of u. */
export interface Interval {
  readonly from: number;
  readonly to: number;
}

/** Whether the straight line between two points (not one above the other) stays on or above the envelope. */
export function staysAbove(e: Envelope, a: Flat, b: Flat): boolean {
  const way = linePiece(a, b, { feature: "nose", on: "edge", corner: false });
  if (!way) return heightAt(e, a.u) <= Math.min(a.v, b.v) + JOINED;
  for (let i = firstSpan(e, way.u0); i < e.length; i++) {
    const s = e[i] as Span;
    if (s.u0 >= way.u1 - ROUND) break;
    let from = Math.max(way.u0, s.u0);
    const end = Math.min(way.u1, s.u1);
    if (end - from <= ROUND) continue;
    for (const cut of [...crossings(s.piece, way, from, end), end]) {
      const middle = (from + cut) / 2;
      if (valueAt(s.piece, middle) > valueAt(way, middle) + JOINED) return false;
      from = cut;
    }
  }
  return true;
}

/**
 * A section of the path along the envelope, with the origin of its piece (null: a vertical step between two pieces).
 */
export interface Stretch {
  readonly segment: FlatSegment;
  readonly origin: Origin | null;
}

/** The envelope as a path from u0 to u1 > u0, vertical steps included; gaps become straight lines. */
export function pathAlong(e: Envelope, u0: number, u1: number): Stretch[] {
  const out: Stretch[] = [];
  let at: Flat | null = null;
  for (let i = firstSpan(e, u0); i < e.length; i++) {
    const s = e[i] as Span;
    if (s.u0 > u1 - ROUND) break;
    const a = Math.max(u0, s.u0);
    const b = Math.min(u1, s.u1);
    if (b - a <= ROUND) continue;
    const from: Flat = { u: a, v: valueAt(s.piece, a) };
    const to: Flat = { u: b, v: valueAt(s.piece, b) };
    if (at && flat.apart(at, from) > JOINED) out.push({ segment: { kind: "line", from: at, to: from }, origin: null });
    const start = at && flat.apart(at, from) <= JOINED ? at : from;
    const p = s.piece;
    out.push({
      segment:
        p.arc === 0
          ? { kind: "line", from: start, to }
          : { kind: "arc", from: start, to, centre: { u: p.cu, v: p.cv }, turn: p.arc === -1 ? "ccw" : "cw" },
      origin: p.origin,
    });
    at = to;
  }
  return out;
}
