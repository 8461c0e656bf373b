import { intervalsBelow } from "../reach/below.ts";
import { firstSpan, valueAt, type Envelope, type Interval, type Span } from "../reach/envelope.ts";
import type { Flat } from "../geometry/flat.ts";
import { ROUND, SAME } from "../tolerance.ts";

/** A section of an envelope that falls to one floor and rises again: one section of a contour for a plunging tool. */
export interface Basin extends Interval {
  /** The deepest interval; empty for a single place. */
  readonly floor: Interval;
  readonly bottom: number;
  /** Plunging positions next to a wall or at an end of a level section: from left to right, each with its depth. */
  readonly stops: readonly Flat[];
}

/** A lower ridge between two deeper places does not separate sections, mm. */
const RIDGE = 0.01;

/**
 * The parts of an envelope below `top` within an interval of u, in sections from left to right. A level part between
 * two sections belongs to the left one.
 */
export function basinsOf(e: Envelope, span: Interval, top: number): Basin[] {
  const open = top < Infinity ? intervalsBelow(e, top - SAME, span.from, span.to) : [span];
  return open.flatMap((stretch) => parted(profile(e, stretch)).map((points) => basinOf(points, top - 3 * SAME)));
}

/** Every place where a piece of the envelope begins, jumps or turns, from left to right; both sides of a jump. */
function profile(e: Envelope, { from, to }: Interval): Flat[] {
  const points: Flat[] = [];
  const add = (u: number, v: number) => {
    const last = points.at(-1);
    if (!last || u > last.u + ROUND || Math.abs(v - last.v) > SAME) points.push({ u, v });
  };
  for (let i = firstSpan(e, from); i < e.length; i++) {
    const { piece, u0, u1 } = e[i] as Span;
    if (u0 >= to) break;
    const [a, b] = [Math.max(from, u0), Math.min(to, u1)];
    if (b - a <= ROUND) continue;
    add(a, valueAt(piece, a));
    if (piece.arc !== 0 && piece.cu > a + SAME && piece.cu < b - SAME) add(piece.cu, valueAt(piece, piece.cu));
    add(b, valueAt(piece, b));
  }
  return points;
}

/** Splits a profile at the end of every ridge between two deeper places. */
function parted(points: readonly Flat[]): Flat[][] {
  const parts: Flat[][] = [];
  let [begin, crest] = [0, 0];
  let [low, high] = [Infinity, -Infinity];
  points.forEach((p, i) => {
    if (p.v > low + RIDGE && p.v > high - SAME) {
      high = Math.max(high, p.v);
      crest = i;
    } else if (p.v < high - RIDGE) {
      parts.push(points.slice(begin, crest + 1));
      begin = crest;
      [low, high] = [p.v, -Infinity];
    } else low = Math.min(low, p.v);
  });
  return points.length > 0 ? [...parts, points.slice(begin)] : [];
}

function basinOf(points: readonly Flat[], deepEnough: number): Basin {
  const bottom = Math.min(...points.map((p) => p.v));
  const deepest = points.filter((p) => p.v < bottom + SAME).map((p) => p.u);
  const stops: Flat[] = [];
  points.forEach((p, i) => {
    const beside = [points[i - 1], points[i + 1]];
    const stands = beside.some((q) => q === undefined || Math.abs(q.u - p.u) < SAME || Math.abs(q.v - p.v) < SAME);
    if (p.v >= deepEnough || !(stands || p.v < bottom + SAME)) return;
    const last = stops.at(-1);
    if (!last || p.u > last.u + SAME) stops.push(p);
    else if (p.v < last.v) stops[stops.length - 1] = p;
  });
  const [from, to] = [(points[0] as Flat).u, (points.at(-1) as Flat).u];
  return { from, to, floor: { from: Math.min(...deepest), to: Math.max(...deepest) }, bottom, stops };
}
