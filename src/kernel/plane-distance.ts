import { meet, track } from "./curve.ts";
import {
  alongSegment, apart, beyond, difference, dot, leftOf, lengthOfSegment, partSegment, unit, type PlanePoint, type PlaneSegment,
} from "./plane.ts";
import { ROUND } from "./tolerance.ts";

/** A point of one segment and how far it is from another, mm. */
export interface Gap {
  readonly distance: number;
  /** The nearest point of the second segment. */
  readonly on: PlanePoint;
}

/** The point of a segment nearest to `p`. */
export function nearestOn(s: PlaneSegment, p: PlanePoint): PlanePoint {
  const ends = apart(p, s.from) <= apart(p, s.to) ? s.from : s.to;
  if (s.kind === "line") {
    const long = lengthOfSegment(s);
    if (long <= ROUND) return s.from;
    const k = alongSegment(s, p) / long;
    return k <= 0 || k >= 1 ? ends : beyond(s.from, difference(s.to, s.from), k);
  }
  const way = unit(difference(p, s.centre));
  if (way.x === 0 && way.y === 0) return s.from;
  return alongSegment(s, p) <= lengthOfSegment(s) ? beyond(s.centre, way, apart(s.from, s.centre)) : ends;
}

/** Points of `a` that can be nearest to `b`: its ends, crossings, and where both run parallel. */
function candidates(a: PlaneSegment, b: PlaneSegment): PlanePoint[] {
  const found = [a.from, a.to, nearestOn(a, b.from), nearestOn(a, b.to)];
  const [one, two] = [track(partSegment(a), 0, "ccw"), track(partSegment(b), 0, "ccw")];
  if (one && two) for (const v of meet(one, two)) found.push(nearestOn(a, { x: v.z, y: v.r }));
  if (b.kind === "arc") found.push(nearestOn(a, b.centre));
  if (a.kind === "arc") {
    const towards = b.kind === "arc" ? difference(b.centre, a.centre) : leftOf(difference(b.to, b.from));
    const way = unit(towards);
    const size = apart(a.from, a.centre);
    if (dot(way, way) > 0) for (const k of [size, -size]) found.push(nearestOn(a, beyond(a.centre, way, k)));
  }
  return found;
}

/** How near two segments come to each other. */
export function gapBetween(a: PlaneSegment, b: PlaneSegment): Gap {
  let best: Gap = { distance: Infinity, on: b.from };
  for (const p of candidates(a, b)) {
    const on = nearestOn(b, p);
    const distance = apart(p, on);
    if (distance < best.distance) best = { distance, on };
  }
  return best;
}
