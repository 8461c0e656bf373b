import { crossings, firstSpan, heightAt, LEVEL, linePiece, push, valueAt, type Envelope, type Origin, type Piece } from "./envelope.ts";
import type { FlatSegment } from "./flat.ts";
import { ROUND } from "./tolerance.ts";

/**
 * The envelope cut down to a piece wherever that is lower by no more than `most` mm: deeper down material stays above it. Where
 * the envelope has a gap it keeps it.
 */
export function loweredBy(e: Envelope, cut: Piece, most: number): Envelope {
  const roof = lifted(cut, most);
  const first = firstSpan(e, cut.u0);
  const out = e.slice(0, first);
  let i = first;
  for (let s = e[i]; s && s.u0 < cut.u1 - ROUND; s = e[++i]) {
    const a = Math.max(s.u0, cut.u0);
    const b = Math.min(s.u1, cut.u1);
    if (b - a <= ROUND) {
      push(out, s.piece, s.u0, s.u1);
      continue;
    }
    push(out, s.piece, s.u0, a);
    let from = a;
    for (const to of [...crossings(s.piece, cut, a, b), ...crossings(s.piece, roof, a, b), b].sort((x, y) => x - y)) {
      const middle = (from + to) / 2;
      const [stands, reached] = [valueAt(s.piece, middle), valueAt(cut, middle)];
      push(out, stands <= reached || stands > reached + most + LEVEL ? s.piece : cut, from, to);
      from = to;
    }
    push(out, s.piece, b, s.u1);
  }
  return [...out, ...e.slice(i)];
}

/** The stretch of an envelope between two places, moved up by `by` mm. */
export const raised = (e: Envelope, u0: number, u1: number, by: number): Envelope =>
  e.filter((s) => s.u1 > u0 && s.u0 < u1).map((s) => ({ piece: lifted(s.piece, by), u0: Math.max(s.u0, u0), u1: Math.min(s.u1, u1) }));

const lifted = (p: Piece, by: number): Piece => (p.arc === 0 ? { ...p, v0: p.v0 + by } : { ...p, cv: p.cv + by });

/** A path element as a piece over u; null when it is vertical. Its arcs only rise or only fall in u. */
export function pieceOf(s: FlatSegment, origin: Origin): Piece | null {
  if (s.kind === "line") return linePiece(s.from, s.to, origin);
  const [u0, u1] = [Math.min(s.from.u, s.to.u), Math.max(s.from.u, s.to.u)];
  if (u1 - u0 < ROUND) return null;
  const radius = Math.hypot(s.from.u - s.centre.u, s.from.v - s.centre.v);
  return { arc: s.to.u > s.from.u === s.ccw ? -1 : 1, u0, u1, cu: s.centre.u, cv: s.centre.v, radius, origin };
}

/** v of the envelope at u: the lower side at a jump, −∞ beside a gap. What only touches there is not in the way. */
export function besideAt(e: Envelope, u: number): number {
  const side = (from: number, to: number) => {
    const v = heightAt(e, u);
    const s = e[firstSpan(e, from + 2 * ROUND)];
    if (!s || s.u0 > to - 2 * ROUND) return -Infinity;
    return Math.min(v, valueAt(s.piece, Math.min(Math.max(u, s.u0), s.u1)));
  };
  return Math.min(side(u - 4 * ROUND, u), side(u, u + 4 * ROUND));
}
