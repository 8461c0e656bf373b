import { ROUND } from "../tolerance.ts";
import { hypotenuse, type Axes, type Vectors } from "./vectors.ts";

/** Turning direction as seen with the first axis to the right and the second upwards; DR+ is "ccw". */
export type Turn = "cw" | "ccw";

export interface LineOf<P> {
  readonly kind: "line";
  readonly from: P;
  readonly to: P;
}
/** An arc keeps its centre and is never flattened here. An arc that ends where it starts is a full circle. */
export interface ArcOf<P> {
  readonly kind: "arc";
  readonly from: P;
  readonly to: P;
  readonly centre: P;
  readonly turn: Turn;
}
/** One element of a contour or path in a space. */
export type SegmentOf<P> = LineOf<P> | ArcOf<P>;

/** An arc in polar form about its centre, angles in radians; `sweep` is signed, counter-clockwise positive. */
export interface Polar {
  readonly start: number;
  readonly sweep: number;
  readonly startRadius: number;
  readonly endRadius: number;
}

/** A rectangle along the axes, mm. */
export interface Box {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}
export const overlap = (a: Box, b: Box) => a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;

export const FULL_TURN = 2 * Math.PI;
const QUARTER = Math.PI / 2;
/** An angle normalized to [0, 2π). */
export const positive = (angle: number) => ((angle % FULL_TURN) + FULL_TURN) % FULL_TURN;
/** An angle normalized to [−π, π). */
export const shortest = (angle: number) => positive(angle + Math.PI) - Math.PI;
export const opposite = (turn: Turn): Turn => (turn === "ccw" ? "cw" : "ccw");
/** 1 counter-clockwise, −1 clockwise. */
export const signOf = (turn: Turn) => (turn === "ccw" ? 1 : -1);

/** The finest step of a chord, radians, which limits the number of chords of a full circle. */
const FINEST = 1 / 1000;

/** Number of chords of an arc of radius `size` mm and `sweep` radians that stay within `chord` mm. */
export function chordsOf(size: number, sweep: number, chord: number): number {
  const step = 2 * Math.acos(Math.max(0, 1 - chord / Math.max(size, chord)));
  const count = Math.ceil(Math.abs(sweep) / Math.max(step, FINEST) - ROUND);
  return Number.isFinite(count) ? Math.max(1, count) : 1;
}

export type Segments<P> = ReturnType<typeof segmentsOf<P>>;

/** Lines and arcs of a space. */
export function segmentsOf<P>({ x, y, point }: Axes<P>, v: Vectors<P>) {
  const { apart, beyond, difference, dot, sum, unit } = v;

  const line = (from: P, to: P): LineOf<P> => ({ kind: "line", from, to });

  /**
   * Angle from the start of an arc to the ray of a point, radians in its turn, 0 … 2π; an angle minimally before the
   * start counts as the start.
   */
  const turnTo = (s: ArcOf<P>, p: P): number => {
    const cx = x(s.centre),
      cy = y(s.centre),
      ax = x(s.from) - cx,
      ay = y(s.from) - cy,
      bx = x(p) - cx,
      by = y(p) - cy;
    const angle = Math.atan2(ax * by - ay * bx, ax * bx + ay * by) * signOf(s.turn);
    return angle < -ROUND ? angle + FULL_TURN : Math.max(0, angle);
  };
  /** Centre angle of an arc, radians, more than 0. */
  const sweepOf = (s: ArcOf<P>): number => (apart(s.from, s.to) <= ROUND ? FULL_TURN : turnTo(s, s.to) || FULL_TURN);
  const radiusOf = (s: ArcOf<P>): number => apart(s.from, s.centre);

  /** An end point slightly off the circle makes a spiral, so that the path still ends in its programmed point. */
  const polarOf = (s: ArcOf<P>): Polar => ({
    start: Math.atan2(y(s.from) - y(s.centre), x(s.from) - x(s.centre)),
    sweep: signOf(s.turn) * sweepOf(s),
    startRadius: radiusOf(s),
    endRadius: apart(s.to, s.centre),
  });

  /** Direction of travel in a point of a segment, length 1. */
  const direction = (s: SegmentOf<P>, p: P): P => {
    if (s.kind === "line") return unit(difference(s.to, s.from));
    const dx = x(p) - x(s.centre),
      dy = y(p) - y(s.centre),
      k = signOf(s.turn) / (hypotenuse(dx, dy) || 1);
    return point(-dy * k, dx * k);
  };

  /** Position of a point along its segment, mm; negative before the start of a line. */
  const along = (s: SegmentOf<P>, p: P): number =>
    s.kind === "line" ? dot(difference(p, s.from), unit(difference(s.to, s.from))) : turnTo(s, p) * radiusOf(s);

  /** Length of a segment, mm. */
  const lengthOf = (s: SegmentOf<P>): number => (s.kind === "line" ? apart(s.from, s.to) : sweepOf(s) * radiusOf(s));

  /** The same segment in the opposite direction. */
  const reversed = (s: SegmentOf<P>): SegmentOf<P> =>
    s.kind === "line"
      ? line(s.to, s.from)
      : { kind: "arc", from: s.to, to: s.from, centre: s.centre, turn: opposite(s.turn) };

  /** The same segment, shifted. */
  const shifted = (s: SegmentOf<P>, by: P): SegmentOf<P> =>
    s.kind === "line"
      ? line(sum(s.from, by), sum(s.to, by))
      : { kind: "arc", from: sum(s.from, by), to: sum(s.to, by), centre: sum(s.centre, by), turn: s.turn };

  /** Returns the function from a fraction 0 … 1 of the length to the point of a segment. */
  const pointsOn = (s: SegmentOf<P>): ((fraction: number) => P) => {
    const inside =
      s.kind === "line"
        ? (k: number) => beyond(s.from, difference(s.to, s.from), k)
        : alongSpiral(s.centre, polarOf(s));
    return (fraction) => (fraction <= 0 ? s.from : fraction >= 1 ? s.to : inside(fraction));
  };
  const alongSpiral = (centre: P, p: Polar) => (k: number) =>
    v.onCircle(centre, p.startRadius + (p.endRadius - p.startRadius) * k, p.start + p.sweep * k);
  /** The point of a segment at a fraction 0 … 1 of its length. */
  const pointOn = (s: SegmentOf<P>, fraction: number): P => pointsOn(s)(fraction);

  /**
   * Points along a segment, both ends included; an arc becomes chords within `chord` mm of it, whose points lie on it.
   */
  const flattened = (s: SegmentOf<P>, chord: number): P[] => {
    if (s.kind === "line") return [s.from, s.to];
    const p = polarOf(s);
    const count = chordsOf(Math.max(p.startRadius, p.endRadius), p.sweep, chord);
    const at = alongSpiral(s.centre, p);
    return Array.from({ length: count + 1 }, (_, i) => (i === 0 ? s.from : i === count ? s.to : at(i / count)));
  };

  /** Points along a chain of segments, with each joint only once. */
  const flattenedChain = (chain: readonly SegmentOf<P>[], chord: number): P[] => {
    const out: P[] = [];
    for (const s of chain) {
      const points = flattened(s, chord);
      const [last, first] = [out.at(-1), points[0]];
      const joined = last !== undefined && first !== undefined && apart(last, first) < ROUND;
      for (const p of joined ? points.slice(1) : points) out.push(p);
    }
    return out;
  };

  /** The point of a segment nearest to `p`. */
  const nearestOn = (s: SegmentOf<P>, p: P): P => {
    const ends = apart(p, s.from) <= apart(p, s.to) ? s.from : s.to;
    if (s.kind === "line") {
      const long = lengthOf(s);
      if (long <= ROUND) return s.from;
      const k = along(s, p) / long;
      return k <= 0 || k >= 1 ? ends : beyond(s.from, difference(s.to, s.from), k);
    }
    const way = unit(difference(p, s.centre));
    if (dot(way, way) === 0) return s.from;
    return along(s, p) <= lengthOf(s) ? beyond(s.centre, way, radiusOf(s)) : ends;
  };

  /** Distance of a point from a segment, mm. */
  const distanceTo = (s: SegmentOf<P>, p: P): number => apart(p, nearestOn(s, p));

  /** Point where a circle with centre `c` touches the line or circle of a segment. */
  const footOn = (s: SegmentOf<P>, c: P): P => {
    if (s.kind === "arc") return beyond(s.centre, unit(difference(c, s.centre)), radiusOf(s));
    const way = unit(difference(s.to, s.from));
    return beyond(s.from, way, dot(difference(c, s.from), way));
  };

  /** The smallest box around a segment. */
  const boxOf = (s: SegmentOf<P>): Box => {
    const ax = x(s.from),
      ay = y(s.from),
      bx = x(s.to),
      by = y(s.to);
    const left = Math.min(ax, bx),
      right = Math.max(ax, bx),
      low = Math.min(ay, by),
      high = Math.max(ay, by);
    if (s.kind === "line") return { left, right, low, high };
    const cx = x(s.centre),
      cy = y(s.centre),
      size = hypotenuse(ax - cx, ay - cy),
      sweep = sweepOf(s),
      k = signOf(s.turn);
    const start = Math.atan2(ay - cy, ax - cx);
    /** Whether the arc passes the extreme point of its circle at this angle, radians. */
    const passes = (end: number): boolean => {
      const way = positive((end - start) * k);
      return way <= sweep || way > FULL_TURN - ROUND;
    };
    return {
      left: passes(Math.PI) ? Math.min(left, cx - size) : left,
      right: passes(0) ? Math.max(right, cx + size) : right,
      low: passes(-QUARTER) ? Math.min(low, cy - size) : low,
      high: passes(QUARTER) ? Math.max(high, cy + size) : high,
    };
  };

  return {
    line,
    sweepOf,
    radiusOf,
    polarOf,
    direction,
    along,
    lengthOf,
    reversed,
    shifted,
    pointsOn,
    pointOn,
    flattened,
    flattenedChain,
    nearestOn,
    distanceTo,
    footOn,
    boxOf,
  };
}
