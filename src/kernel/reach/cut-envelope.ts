import {
  crossings,
  firstSpan,
  heightAt,
  linePiece,
  push,
  valueAt,
  type Envelope,
  type Origin,
  type EnvelopePiece,
  type Interval,
  type Span,
} from "./envelope.ts";
import { flat, type FlatSegment } from "../geometry/flat.ts";
import { JOINED, ROUND } from "../tolerance.ts";

/**
 * The envelope lowered to the cuts (from left to right, without overlap) wherever they are lower by no more than `most`
 * mm: under a deeper cut, material remains above the insert. Gaps of the envelope stay.
 */
export function withCuts(e: Envelope, cuts: readonly EnvelopePiece[], most: number): Envelope {
  const first = cuts[0];
  if (!first) return e;
  let i = firstSpan(e, first.u0);
  const out = e.slice(0, i);
  let rest = e[i++];
  for (const cut of cuts) {
    const roof = lifted(cut, most);
    for (; rest && rest.u1 <= cut.u0 + ROUND; rest = e[i++]) push(out, rest.piece, rest.u0, rest.u1);
    while (rest && rest.u0 < cut.u1 - ROUND) {
      const { piece, u1 }: Span = rest;
      let from = Math.max(rest.u0, cut.u0);
      const end = Math.min(u1, cut.u1);
      push(out, piece, rest.u0, from);
      const cuts = inOrder(crossings(piece, cut, from, end), crossings(piece, roof, from, end));
      for (let k = 0; k <= cuts.length; k += 1) {
        const to = cuts[k] ?? end;
        const middle = (from + to) / 2;
        const stands = valueAt(piece, middle),
          reached = valueAt(cut, middle);
        push(out, stands <= reached || stands > reached + most + JOINED ? piece : cut, from, to);
        from = to;
      }
      rest = u1 > end + ROUND ? { piece, u0: end, u1 } : e[i++];
    }
  }
  if (rest) push(out, rest.piece, rest.u0, rest.u1);
  return out.concat(e.slice(i));
}

/** Merges two lists of places, ascending. */
const inOrder = (a: readonly number[], b: readonly number[]): readonly number[] =>
  b.length === 0 ? a : a.length === 0 ? b : [...a, ...b].sort((x, y) => x - y);

/** The section of an envelope between two places, moved up by `by` mm. */
export const raisedSection = (e: Envelope, u0: number, u1: number, by: number): Envelope =>
  e
    .filter((s) => s.u1 > u0 && s.u0 < u1)
    .map((s) => ({ piece: lifted(s.piece, by), u0: Math.max(s.u0, u0), u1: Math.min(s.u1, u1) }));

const lifted = (p: EnvelopePiece, by: number): EnvelopePiece =>
  p.arc === 0 ? { ...p, v0: p.v0 + by } : { ...p, cv: p.cv + by };

/**
 * Intervals where one envelope is more than `by` mm above another, from left to right: checked at the ends of the
 * common pieces and in their middle.
 */
export function intervalsAbove(e: Envelope, other: Envelope, from: number, to: number, by: number): Interval[] {
  const found: Interval[] = [];
  let j = firstSpan(other, from);
  for (let i = firstSpan(e, from); i < e.length && (e[i] as Span).u0 < to; i++) {
    const s = e[i] as Span;
    while (j > 0 && (other[j]?.u0 ?? Infinity) > s.u0) j -= 1;
    for (; j < other.length && (other[j] as Span).u0 < Math.min(s.u1, to); j++) {
      const o = other[j] as Span;
      const [a, b] = [Math.max(from, s.u0, o.u0), Math.min(to, s.u1, o.u1)];
      if (b - a <= ROUND) continue;
      if ([a, (a + b) / 2, b].some((u) => valueAt(s.piece, u) > valueAt(o.piece, u) + by))
        found.push({ from: a, to: b });
    }
  }
  return found;
}

/** A path element as a piece over u; null when it is vertical. Its arcs must only rise or only fall in u. */
export function pieceOf(s: FlatSegment, origin: Origin): EnvelopePiece | null {
  if (s.kind === "line") return linePiece(s.from, s.to, origin);
  const [u0, u1] = [Math.min(s.from.u, s.to.u), Math.max(s.from.u, s.to.u)];
  if (u1 - u0 < ROUND) return null;
  return {
    arc: s.to.u > s.from.u === (s.turn === "ccw") ? -1 : 1,
    u0,
    u1,
    cu: s.centre.u,
    cv: s.centre.v,
    radius: flat.radiusOf(s),
    origin,
  };
}

/** v of the envelope at u: the lower side at a jump, −∞ next to a gap. Pieces that only touch at u are no obstacle. */
export function lowerSideAt(e: Envelope, u: number): number {
  const side = (from: number, to: number) => {
    const v = heightAt(e, u);
    const s = e[firstSpan(e, from + 2 * ROUND)];
    if (!s || s.u0 > to - 2 * ROUND) return -Infinity;
    return Math.min(v, valueAt(s.piece, Math.min(Math.max(u, s.u0), s.u1)));
  };
  return Math.min(side(u - 4 * ROUND, u), side(u, u + 4 * ROUND));
}
