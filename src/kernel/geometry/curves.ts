import { ROUND } from "../tolerance.ts";
import type { SegmentOf, Segments, Turn } from "./segments.ts";
import type { Vectors } from "./vectors.ts";

/** A straight line or a circle without ends. */
export type CurveOf<P> = { readonly point: P; readonly along: P } | { readonly centre: P; readonly radius: number };

/** Curves of a space: the lines and circles of segments, their intersections, and the distance of segments. */
export function curvesOf<P>(v: Vectors<P>, s: Segments<P>) {
  const { apart, beyond, cross, difference, dot, leftOf, sizeOf, unit } = v;

  /** The curve of the centres of circles of radius `r` that touch a segment on one side; null when there is none. */
  function curveBeside(e: SegmentOf<P>, r: number, side: Turn): CurveOf<P> | null {
    if (e.kind === "line") {
      const way = unit(difference(e.to, e.from));
      return sizeOf(way) < ROUND ? null : { point: beyond(e.from, leftOf(way), side === "ccw" ? r : -r), along: way };
    }
    const grown = e.turn === side ? s.radiusOf(e) - r : s.radiusOf(e) + r;
    return grown > ROUND ? { centre: e.centre, radius: grown } : null;
  }

  /** Intersections of two curves: none, one or two points. */
  function meet(a: CurveOf<P>, b: CurveOf<P>): P[] {
    if ("point" in a)
      return "point" in b
        ? meetLines(a.point, a.along, b.point, b.along)
        : meetLine(a.point, a.along, b.centre, b.radius);
    if ("point" in b) return meetLine(b.point, b.along, a.centre, a.radius);
    const gap = apart(a.centre, b.centre);
    if (gap < ROUND) return [];
    const way = unit(difference(b.centre, a.centre));
    const k = (gap * gap + a.radius ** 2 - b.radius ** 2) / (2 * gap);
    return halves(a.radius ** 2 - k * k).map((h) => beyond(beyond(a.centre, way, k), leftOf(way), h));
  }
  function meetLines(p: P, way: P, q: P, other: P): P[] {
    const bend = cross(way, other);
    return Math.abs(bend) < ROUND ? [] : [beyond(p, way, cross(difference(q, p), other) / bend)];
  }
  function meetLine(p: P, way: P, centre: P, radius: number): P[] {
    const foot = beyond(p, way, dot(difference(centre, p), way));
    const off = difference(centre, foot);
    return halves(radius ** 2 - dot(off, off)).map((h) => beyond(foot, way, h));
  }
  /** The two roots of a square, or none of a negative one. */
  const halves = (square: number) => (square < 0 ? [] : [Math.sqrt(square), -Math.sqrt(square)]);

  /** Intersections of two segments, both extended without end. */
  function meetings(a: SegmentOf<P>, b: SegmentOf<P>): P[] {
    const [one, two] = [curveBeside(a, 0, "ccw"), curveBeside(b, 0, "ccw")];
    return one && two ? meet(one, two) : [];
  }

  /** Candidates for the point of `a` nearest to `b`: its ends, crossings, and points where both run parallel. */
  function candidates(a: SegmentOf<P>, b: SegmentOf<P>): P[] {
    const found = [
      a.from,
      a.to,
      s.nearestOn(a, b.from),
      s.nearestOn(a, b.to),
      ...meetings(a, b).map((p) => s.nearestOn(a, p)),
    ];
    if (b.kind === "arc") found.push(s.nearestOn(a, b.centre));
    if (a.kind === "arc") {
      const way = unit(b.kind === "arc" ? difference(b.centre, a.centre) : leftOf(difference(b.to, b.from)));
      const size = s.radiusOf(a);
      if (dot(way, way) > 0) {
        for (const k of [size, -size]) found.push(s.nearestOn(a, beyond(a.centre, way, k)));
      }
    }
    return found;
  }

  /** Distance of two segments, mm, and the nearest point of the second. */
  function gapBetween(a: SegmentOf<P>, b: SegmentOf<P>): { readonly distance: number; readonly on: P } {
    let best = { distance: Infinity, on: b.from };
    for (const p of candidates(a, b)) {
      const on = s.nearestOn(b, p);
      const distance = apart(p, on);
      if (distance < best.distance) best = { distance, on };
    }
    return best;
  }

  return { curveBeside, meet, meetings, gapBetween };
}
