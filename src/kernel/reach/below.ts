import {
  crossings,
  firstSpan,
  valueAt,
  type Envelope,
  type EnvelopePiece,
  type Interval,
  type Span,
} from "./envelope.ts";
import { JOINED, ROUND } from "../tolerance.ts";

/** Lowest and highest v of a piece between two of its places. */
function rangeOf(p: EnvelopePiece, a: number, b: number): readonly [low: number, high: number] {
  const va = valueAt(p, a),
    vb = valueAt(p, b),
    low = Math.min(va, vb),
    high = Math.max(va, vb);
  if (p.arc === 0 || p.cu <= a || p.cu >= b) return [low, high];
  return p.arc === 1 ? [low, p.cv + p.radius] : [p.cv - p.radius, high];
}

/** Maximal intervals within [u0, u1] where the envelope is at or below `level`, from left to right. */
export function intervalsBelow(e: Envelope, level: number, u0: number, u1: number): Interval[] {
  const out: Interval[] = [];
  const add = (from: number, to: number) => {
    if (to < from) return;
    const last = out[out.length - 1];
    if (last && from - last.to <= JOINED) out[out.length - 1] = { from: last.from, to: Math.max(last.to, to) };
    else out.push({ from, to });
  };
  const top = level + JOINED;
  let covered = u0;
  for (let i = firstSpan(e, u0); i < e.length; i++) {
    const s = e[i] as Span;
    if (s.u0 > u1) break;
    if (s.u0 > covered + ROUND) add(covered, Math.min(s.u0, u1));
    const a = Math.max(u0, s.u0);
    const b = Math.min(u1, s.u1);
    covered = Math.max(covered, s.u1);
    if (b < a) continue;
    // Most pieces are wholly on one side and need no crossings.
    const [low, high] = rangeOf(s.piece, a, b);
    if (low > top + ROUND) continue;
    if (high < top - ROUND) {
      add(a, b);
      continue;
    }
    const flat: EnvelopePiece = { arc: 0, u0: a, u1: b, v0: top, slope: 0, origin: s.piece.origin };
    let from = a;
    if (valueAt(s.piece, a) <= top) add(a, a);
    for (const cut of [...crossings(s.piece, flat, a, b), b]) {
      if (valueAt(s.piece, (from + cut) / 2) <= top) add(from, cut);
      from = cut;
    }
    if (valueAt(s.piece, b) <= top) add(b, b);
  }
  if (covered < u1) add(covered, u1);
  return out;
}
