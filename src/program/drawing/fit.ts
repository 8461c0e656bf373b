import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { FULL_TURN } from "../../kernel/geometry/segments.ts";
import { NOTHING, ROUND, SAME } from "../../kernel/tolerance.ts";
import { smoothParts, splinePoint } from "./splines.ts";
import type { Curve3, V3 } from "./space.ts";

/** Greatest distance of splines and ellipses from the lines and arcs that stand for them, mm. */
export const FIT = 0.005;
/** Axes of an ellipse that differ by less than this share make a circle. */
const ROUND_SHARE = 1e-6;
/** An arc flatter than this is a line, mm of radius. */
const FLATTEST = 1e5;
/** Steps for the direction at an end, as shares of the range; the longer one where the curve hardly moves. */
const STEPS_INSIDE = [1e-5, 1e-2];
/** The shortest part of a curve that is fitted, as a share of the whole. */
const SHORTEST = 1 / 4096;

/** A smooth plane curve over a range of its parameter; `detail`: a count that grows with its bends. */
export interface SmoothCurve {
  readonly point: (t: number) => Pt;
  readonly from: number;
  readonly to: number;
  readonly detail: number;
}

/** Direction of travel at an end of a range, from points inside it only: a corner may lie behind the end. */
function heading(c: SmoothCurve, a: number, b: number): Pt {
  for (const share of STEPS_INSIDE) {
    const h = (b - a) * share,
      [p, q, r] = [c.point(a), c.point(a + h), c.point(a + 2 * h)];
    const way = at(4 * q.z - 3 * p.z - r.z, 4 * q.r - 3 * p.r - r.r);
    if (part.sizeOf(way) > NOTHING) return part.scaled(part.unit(way), Math.sign(b - a) || 1);
  }
  return part.unit(part.difference(c.point(b), c.point(a)));
}

/** The arc from a point in a direction to another point; a line where it is flat. */
function arcInto(from: Pt, way: Pt, to: Pt): Segment {
  const left = part.leftOf(way),
    chord = part.difference(to, from),
    off = part.dot(left, chord),
    size = part.dot(chord, chord) / (2 * off);
  if (Math.abs(off) < NOTHING || !(Math.abs(size) < FLATTEST)) return part.line(from, to);
  return { kind: "arc", from, to, centre: part.beyond(from, left, size), turn: size > 0 ? "ccw" : "cw" };
}

/** Two arcs that leave one point in a direction and arrive in another in a direction, with a common tangent. */
function biarc(p: Pt, way: Pt, q: Pt, wayIn: Pt): Segment[] {
  const chord = part.difference(q, p),
    both = part.dot(chord, part.sum(way, wayIn)),
    bend = 2 * (1 - part.dot(way, wayIn)),
    square = part.dot(chord, chord);
  const reach = bend < ROUND ? square / (2 * both) : (Math.sqrt(both * both + bend * square) - both) / bend;
  if (!Number.isFinite(reach) || reach <= 0) return [part.line(p, q)];
  const joint = part.scaled(part.sum(part.beyond(p, way, reach), part.beyond(q, wayIn, -reach)), 1 / 2);
  const back = arcInto(q, part.scaled(wayIn, -1), joint);
  return [arcInto(p, way, joint), part.reversed(back)];
}

const isFinitePoint = ({ z, r }: Pt): boolean => Number.isFinite(z) && Number.isFinite(r);

/** The numbers from 1 to below an end, those far apart first: a misfit shows at one of the first. */
function* coarseFirst(end: number): Generator<number> {
  for (let step = 2 ** Math.floor(Math.log2(end)); step >= 1; step /= 2)
    for (let i = step; i < end; i += 2 * step) yield i;
}

/** The lines or arcs of a range, or null where they are farther from it than the tolerance. */
function tried(c: SmoothCurve, a: number, b: number, tolerance: number): Segment[] | null {
  const count = Math.min(400, 8 + Math.ceil((3 * c.detail * (b - a)) / (c.to - c.from)));
  const [first, last] = [c.point(a), c.point(b)];
  if (!isFinitePoint(first) || !isFinitePoint(last)) return [];
  const straight = [part.line(first, last)],
    arcs = biarc(first, heading(c, a, b), last, heading(c, b, a));
  let isStraight = part.apart(first, last) > NOTHING,
    isArcs = arcs.every((s) => s.kind === "line" || part.sweepOf(s) < 1.1 * Math.PI);
  const reaches = (made: readonly Segment[], p: Pt, within: number) =>
    made.some((s) => part.distanceTo(s, p) <= within);
  for (const i of coarseFirst(count)) {
    const p = c.point(a + ((b - a) * i) / count);
    if (!isFinitePoint(p)) return [];
    isStraight &&= reaches(straight, p, Math.min(SAME, tolerance));
    isArcs &&= reaches(arcs, p, tolerance);
    if (!isStraight && !isArcs) return null;
  }
  return isStraight ? straight : arcs;
}

/** Joins consecutive arcs of one circle. */
function rejoined(all: readonly Segment[]): Segment[] {
  const out: Segment[] = [];
  for (const s of all) {
    const last = out.at(-1);
    const isSame =
      last?.kind === "arc" &&
      s.kind === "arc" &&
      last.turn === s.turn &&
      part.apart(last.centre, s.centre) < SAME &&
      part.sweepOf(last) + part.sweepOf(s) < FULL_TURN - SAME;
    if (isSame) out[out.length - 1] = { ...last, to: s.to };
    else if (part.apart(s.from, s.to) > NOTHING) out.push(s);
  }
  return out;
}

/** Lines and arcs within the tolerance (mm) of a smooth curve, tangent to each other, the ends exact. */
export function fitted(c: SmoothCurve, tolerance: number = FIT): Segment[] {
  const out: Segment[] = [],
    whole = c.to - c.from;
  for (let a = c.from; a < c.to;) {
    let b = c.to,
      made = tried(c, a, b, tolerance);
    while (!made && b - a > whole * SHORTEST) {
      b = a + (b - a) / 2;
      made = tried(c, a, b, tolerance);
    }
    out.push(...(made ?? [part.line(c.point(a), c.point(b))]));
    a = b;
  }
  return rejoined(out);
}

const flat = (p: V3): Pt => at(p[0], p[1]);

/** The arc of a circle seen from the front, the line of one seen from its edge, or an elliptical curve. */
function conic(c: Extract<Curve3, { kind: "conic" }>): Segment[] | SmoothCurve {
  const [centre, u, v] = [flat(c.centre), flat(c.u), flat(c.v)],
    area = part.cross(u, v),
    [long, wide] = [part.sizeOf(u), part.sizeOf(v)];
  const point = (t: number) => part.beyond(part.beyond(centre, u, Math.cos(t)), v, Math.sin(t));
  const isFull = c.end - c.start > FULL_TURN - ROUND_SHARE;
  if (Math.abs(area) <= ROUND_SHARE * Math.max(long, wide) ** 2) {
    const far = Math.atan2(part.dot(v, long > wide ? u : v), part.dot(u, long > wide ? u : v));
    return [isFull ? part.line(point(far), point(far + Math.PI)) : part.line(point(c.start), point(c.end))];
  }
  const isRound = Math.abs(long - wide) <= ROUND_SHARE * long && Math.abs(part.dot(u, v)) <= ROUND_SHARE * long * wide;
  if (!isRound) return { point, from: c.start, to: c.end, detail: 8 };
  const from = point(c.start);
  return [{ kind: "arc", from, to: isFull ? from : point(c.end), centre, turn: area > 0 ? "ccw" : "cw" }];
}

/** A curve seen along z as lines and arcs; `isFitted` where they stand for it within FIT. */
export function plainCurve(c: Curve3): { readonly segments: readonly Segment[]; readonly isFitted: boolean } {
  if (c.kind === "line") return { segments: [part.line(flat(c.from), flat(c.to))], isFitted: false };
  if (c.kind === "conic") {
    const made = conic(c);
    return Array.isArray(made) ? { segments: made, isFitted: false } : { segments: fitted(made), isFitted: true };
  }
  if (c.degree === 1)
    return {
      segments: c.points.slice(1).map((p, i) => part.line(flat(c.points[i] ?? p), flat(p))),
      isFitted: false,
    };
  const ends = smoothParts(c);
  const segments = ends.slice(1).flatMap((to, i) => {
    const from = ends[i] ?? to;
    const detail = (c.points.length * (to - from)) / ((ends.at(-1) ?? to) - (ends[0] ?? from) || 1);
    return fitted({ point: (t) => flat(splinePoint(c, t)), from, to, detail });
  });
  return { segments, isFitted: true };
}
