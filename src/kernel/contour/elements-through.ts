import { chordsOf } from "../geometry/segments.ts";
import { part, type Pt, type Segment } from "../geometry/point.ts";
import { CHORD, ROUND } from "../tolerance.ts";

/** Greatest distance of lines and arcs from the points they replace, mm. */
export interface Nearness {
  readonly line: number;
  readonly arc: number;
}

type Arc = Extract<Segment, { kind: "arc" }>;

/** Fewest points of an arc's chords, and its largest radius, mm. */
const ARC_POINTS = 4,
  LARGEST_ARC = 2000;
/** Three points that enclose less count as a line, mm². */
const NO_AREA = 0.000036;
/** From this angle on, the chord of an arc does not determine it well enough, radians. */
const WIDE = 1.2 * Math.PI;
/** Halvings after which an angle has the precision of a double. */
const HALVINGS = 60;

/** The circle through three points; null where they lie on a line. */
function circle(a: Pt, b: Pt, c: Pt): { readonly centre: Pt; readonly radius: number } | null {
  const [bz, br, cz, cr] = [b.z - a.z, b.r - a.r, c.z - a.z, c.r - a.r],
    d = 2 * (bz * cr - br * cz);
  if (Math.abs(d) < NO_AREA) return null;
  const [bb, cc] = [bz * bz + br * br, cz * cz + cr * cr];
  const z = (cr * bb - br * cc) / d,
    r = (bz * cc - cz * bb) / d,
    radius = Math.hypot(z, r);
  return radius > LARGEST_ARC ? null : { centre: part.point(a.z + z, a.r + r), radius };
}

const between = (points: readonly Pt[], from: number, to: number): readonly Pt[] => points.slice(from + 1, to);

/** The line from one point to another, if all points in between are near it. */
function lineOf(points: readonly Pt[], from: number, to: number, near: number): Segment | null {
  const [a, b] = [points[from], points[to]];
  if (!a || !b) return null;
  const line = part.line(a, b);
  return between(points, from, to).every((p) => part.distanceTo(line, p) < near) ? line : null;
}

/**
 * Whether a run of points and its chords lie near a circle: a chord that sinks farther from the arc is a separate line.
 */
function isNear(
  run: readonly Pt[],
  { centre, radius }: { readonly centre: Pt; readonly radius: number },
  near: number,
): boolean {
  const lies = (p: Pt) => Math.abs(part.apart(p, centre) - radius) < near;
  return run.every((p, i) => {
    const q = run[i + 1];
    return lies(p) && (!q || lies(part.pointOn(part.line(p, q), 1 / 2)));
  });
}

/** The arc through a run of points. */
function arcOf(points: readonly Pt[], from: number, to: number, near: number): Arc | null {
  const [a, m, b] = [points[from], points[Math.floor((from + to) / 2)], points[to]];
  if (!a || !m || !b || to - from < ARC_POINTS) return null;
  const found = circle(a, m, b);
  if (!found || !isNear(points.slice(from, to + 1), found, near)) return null;
  const turn = (m.z - a.z) * (b.r - a.r) - (m.r - a.r) * (b.z - a.z) > 0 ? "ccw" : "cw";
  return { kind: "arc", from: a, to: b, centre: found.centre, turn };
}

/** Area between the chords of an arc and the line from end to end, mm². */
const areaOverLine = (line: number, angle: number, chords: number): number =>
  ((line ** 2 / 8) * (chords * Math.sin(angle / chords) - Math.sin(angle))) / Math.sin(angle / 2) ** 2;

/**
 * Area between an arc of less than half a turn, flattened to the chords of the stock, and the line from end to end,
 * mm².
 */
export function areaOfArc(line: number, radius: number): number {
  const half = Math.asin(Math.min(1, line / 2 / radius)),
    angle = half + half;
  return areaOverLine(line, angle, chordsOf(radius, angle, CHORD));
}

/**
 * The arc between the same ends that encloses the same area as its points. The circle through three of them depends on
 * the rounding of those three; the area depends on all.
 */
function equalAreaArc(arc: Arc, run: readonly Pt[], near: number): Arc {
  const sweep = part.sweepOf(arc);
  if (sweep > WIDE) return arc;
  const line = part.apart(arc.from, arc.to),
    chords = chordsOf(part.radiusOf(arc), sweep, CHORD);
  const enclosed = run
    .slice(1)
    .reduce((sum, q, i) => sum + part.cross(part.difference(run[i] ?? q, arc.from), part.difference(q, arc.from)), 0);
  const way = arc.turn === "ccw" ? 1 : -1,
    area = (way * enclosed) / 2;
  let [low, high] = [ROUND, 2 * Math.PI - ROUND];
  for (let i = 0; i < HALVINGS; i += 1) {
    const middle = (low + high) / 2;
    if (areaOverLine(line, middle, chords) < area) low = middle;
    else high = middle;
  }
  const radius = line / (2 * Math.sin(low / 2)),
    side = way * radius * Math.cos(low / 2);
  if (!(area > 0) || radius > LARGEST_ARC) return arc;
  const across = part.leftOf(part.unit(part.difference(arc.to, arc.from)));
  const centre = part.beyond(part.pointOn(part.line(arc.from, arc.to), 1 / 2), across, side);
  return isNear(run, { centre, radius }, near) ? { ...arc, centre } : arc;
}

/** Replaces a chain of points by few lines and arcs: each continues as long as it stays near the points. */
export function elementsThrough(points: readonly Pt[], near: Nearness): Segment[] {
  const out: Segment[] = [];
  let from = 0;
  while (from < points.length - 1) {
    let best: { to: number; segment: Segment } | null = null;
    for (const [make, least, by] of [
      [lineOf, 1, near.line],
      [arcOf, ARC_POINTS, near.arc],
    ] as const) {
      let to = from + least,
        made = make(points, from, to, by);
      while (made) {
        if (!best || to > best.to) best = { to, segment: made };
        to += 1;
        made = to < points.length ? make(points, from, to, by) : null;
      }
    }
    if (!best) break;
    const { to, segment } = best;
    out.push(segment.kind === "arc" ? equalAreaArc(segment, points.slice(from, to + 1), near.arc) : segment);
    from = to;
  }
  return out;
}
