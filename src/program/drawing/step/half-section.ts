import { at, part, type Pt, type Segment } from "../../../kernel/geometry/point.ts";
import { SAME_STEP } from "../../../kernel/tolerance.ts";
import { fitted } from "../fit.ts";
import { crossingOf, type Crossing } from "./beside.ts";
import {
  ALIKE,
  ROUGH,
  isSameMeridian,
  meridianDirection,
  meridianNormal,
  meridianParameter,
  meridianPoint,
  sectionPoint,
  type Axis3,
  type Meridian,
} from "./meridian.ts";
import { pointsOfFace, type StepBody, type StepEdge, type StepFace } from "./step-body.ts";
import type { StepSurface } from "./step-surface.ts";
import { add, minus, times, dot3, cross3, unit3, type V3 } from "../space.ts";

/** A face with its surface. */
export interface SurfacedFace {
  readonly face: StepFace;
  readonly surface: StepSurface;
}

/** A line or arc of a half section, and the kind of surface it is of. */
export interface SectionCurve {
  readonly segment: Segment;
  readonly kind: StepSurface["kind"];
  readonly isFitted: boolean;
}

/** Half section of a body: r above the axis. */
export interface HalfSection {
  readonly curves: readonly SectionCurve[];
  /** Faces that are not of revolution about the axis. */
  readonly others: readonly SurfacedFace[];
}

/** Part of a meridian on which faces lie. */
interface Run {
  readonly meridian: Meridian;
  readonly kind: StepSurface["kind"];
  /** The normal leaves the solid on the side of `meridianNormal`. */
  readonly outward: boolean;
  spans: readonly (readonly [number, number])[];
}

const TURN = 2 * Math.PI;
/** Parameters of a line nearer than this meet, mm; also for angles, times the radius. */
const MEET = 1e-3;
/** How far beside a face is looked for material, mm: farther than chords of round edges lie off them. */
const BESIDE = 0.05;
/** Places at which a run is looked at. */
const LOOKS = 32;

/** Whether an edge is a circle, or part of one, about the axis. */
function isAbout(axis: Axis3, { points, isCurved }: StepEdge): boolean {
  const [first] = points;
  if (!first || !isCurved) return false;
  const a = sectionPoint(axis, first);
  return a.r > ROUGH && points.every((p) => part.apart(sectionPoint(axis, p), a) < ROUGH);
}

/** Whether the axis passes through a face that lies across it: an odd number of its bounds goes round the axis. */
function isPierced(axis: Axis3, face: StepFace): boolean {
  const around = face.bounds.filter((bound) => {
    let sum = 0;
    for (const edge of bound)
      for (let i = 0; i + 1 < edge.points.length; i += 1) {
        const [p, q] = [edge.points[i], edge.points[i + 1]];
        if (!p || !q) continue;
        const [a, b] = [minus(p, axis.origin), minus(q, axis.origin)],
          flat = (v: V3) => minus(v, times(axis.direction, dot3(v, axis.direction)));
        const [u, v] = [flat(a), flat(b)];
        sum += Math.atan2(dot3(cross3(u, v), axis.direction), dot3(u, v));
      }
    return Math.abs(sum) > Math.PI;
  });
  return around.length % 2 === 1;
}

/** Sign of the way into the face along the meridian, at the first edge about the axis that shows one; 0 where none does. */
function wayInto({ face }: SurfacedFace, m: Meridian, axis: Axis3): number {
  for (const edge of face.bounds.flat()) {
    const [p, q] = edge.points;
    if (!p || !q || !isAbout(axis, edge)) continue;
    const place = sectionPoint(axis, p),
      t = meridianParameter(m, place),
      n = meridianNormal(m, t),
      d = minus(p, axis.origin);
    const radial = unit3(minus(d, times(axis.direction, dot3(d, axis.direction)))),
      ahead = unit3(minus(q, p));
    if (!radial || !ahead) continue;
    const sign = face.sense ? 1 : -1,
      normal = add(times(axis.direction, n.z * sign), times(radial, n.r * sign)),
      inside = cross3(normal, ahead);
    const way = meridianDirection(m, t),
      along = dot3(inside, axis.direction) * way.z + dot3(inside, radial) * way.r;
    if (Math.abs(along) > 0.5) return Math.sign(along);
  }
  return 0;
}

/** Numbers in order, without those that differ by less than `near`. */
const distinct = (all: readonly number[], near: number) =>
  all.toSorted((a, b) => a - b).filter((n, i, sorted) => i === 0 || n - (sorted[i - 1] ?? n) > near);

/** Radii between which a face across the axis lies; null for a floor of something beside the axis. */
function acrossSpan(face: StepFace, axis: Axis3): readonly [number, number] | null {
  const edges = face.bounds.flat(),
    radii = edges.filter((e) => isAbout(axis, e)).map((e) => sectionPoint(axis, e.points[0] ?? axis.origin).r);
  if (radii.length === 0) return null;
  const most = Math.max(...radii);
  if (isPierced(axis, face)) return [0, most];
  const least = Math.min(...radii);
  if (most - least > MEET) return [least, most];
  const all = pointsOfFace(face).map((p) => sectionPoint(axis, p).r);
  return [Math.min(...all), Math.max(...all)];
}

/** Part of an arc on which a face lies. */
function arcSpan(f: SurfacedFace, m: Extract<Meridian, { kind: "arc" }>, axis: Axis3): readonly [number, number] {
  const near = MEET / m.size;
  const angles = distinct(
    pointsOfFace(f.face).map((p) => meridianParameter(m, sectionPoint(axis, p))),
    near,
  );
  const [first, last] = [angles[0], angles.at(-1)];
  if (Math.abs(m.centre.r) < ALIKE) {
    // A sphere: from pole to pole at most. One circle alone bounds a cap.
    if (first === undefined || last === undefined) return [0, Math.PI];
    if (last - first > near) return [first, last];
    return wayInto(f, m, axis) > 0 ? [first, Math.PI] : [0, first];
  }
  if (first === undefined || last === undefined || last - first <= near) return [-Math.PI, Math.PI];
  // The largest gap between the points of its edges is what the face leaves free.
  let widest = first + TURN - last,
    from = first;
  for (let i = 0; i + 1 < angles.length; i += 1) {
    const gap = (angles[i + 1] ?? 0) - (angles[i] ?? 0);
    if (gap > widest) [widest, from] = [gap, angles[i + 1] ?? from];
  }
  if (angles.length > 2) return [from, from + TURN - widest];
  const edge = f.face.bounds.flat().find((e) => isAbout(axis, e)),
    [corner] = edge?.points ?? [],
    start = corner && meridianParameter(m, sectionPoint(axis, corner)),
    way = wayInto(f, m, axis);
  if (start === undefined || way === 0) return [from, from + TURN - widest];
  const isFirst = Math.abs(start - first) < Math.abs(start - last);
  return isFirst === way > 0 ? [first, last] : [last, first + TURN];
}

/** Part of the meridian on which a face lies; null when it has no length. */
function spanOf(f: SurfacedFace, m: Meridian, axis: Axis3): readonly [number, number] | null {
  if (f.surface.kind === "plane") return acrossSpan(f.face, axis);
  if (m.kind === "arc") return arcSpan(f, m, axis);
  const all = pointsOfFace(f.face).map((p) => meridianParameter(m, sectionPoint(axis, p)));
  if (all.length === 0) return m.kind === "profile" ? [m.profile.from, m.profile.to] : null;
  const [from, to] = [Math.min(...all), Math.max(...all)];
  if (m.kind === "line" && to - from <= MEET && Math.abs(m.direction.r) > ALIKE) {
    // A single circle bounds a cone that ends in its tip.
    const tip = -m.origin.r / m.direction.r;
    return [Math.min(from, tip), Math.max(to, tip)];
  }
  return to > from ? [from, to] : null;
}

/** Spans in order, those that meet joined. */
function union(spans: readonly (readonly [number, number])[], near: number, isRound: boolean) {
  const out: [number, number][] = [];
  for (const [from, to] of spans.toSorted((a, b) => a[0] - b[0])) {
    const last = out.at(-1);
    if (last && from <= last[1] + near) last[1] = Math.max(last[1], to);
    else out.push([from, to]);
  }
  const [first, last] = [out[0], out.at(-1)];
  if (isRound && first && last && first !== last && last[1] >= first[0] + TURN - near) {
    out.shift();
    last[1] = Math.max(last[1], first[1] + TURN);
  }
  return out;
}

const nearOf = (m: Meridian) =>
  m.kind === "arc" ? MEET / m.size : m.kind === "line" ? MEET : (m.profile.to - m.profile.from) * SAME_STEP;

/** Segments of a part of a meridian. */
function segmentsOf(m: Meridian, from: number, to: number): readonly Segment[] {
  if (m.kind === "line") return [{ kind: "line", from: meridianPoint(m, from), to: meridianPoint(m, to) }];
  if (m.kind === "profile") return fitted({ point: m.profile.point, from, to, detail: 24 });
  const ends: Pt[] = [meridianPoint(m, from), meridianPoint(m, (from + to) / 2), meridianPoint(m, to)];
  const arc = (a: Pt, b: Pt): Segment => ({ kind: "arc", from: a, to: b, centre: m.centre, turn: "ccw" });
  const [a, b, c] = ends;
  if (!a || !b || !c) return [];
  return to - from > 0.99 * TURN ? [arc(a, b), arc(b, c)] : [arc(a, c)];
}

/** Parts of a span that bound what the part fills when it turns: beside them nothing else of it comes by. */
function freeParts(run: Run, [from, to]: readonly [number, number], crossings: readonly Crossing[]) {
  const isFree = (t: number) => {
    const n = meridianNormal(run.meridian, t),
      p = meridianPoint(run.meridian, t),
      side = run.outward ? BESIDE : -BESIDE;
    return !crossings.some((meets) => meets(at(p.z + n.z * side, p.r + n.r * side)));
  };
  const places = Array.from({ length: LOOKS }, (_, i) => from + ((to - from) * (i + 0.5)) / LOOKS),
    free = places.map(isFree);
  if (free.every(Boolean)) return [[from, to] as const];
  const between = (a: number, b: number) => {
    let [good, bad] = [a, b];
    for (let i = 0; i < 24; i += 1) {
      const middle = (good + bad) / 2;
      if (isFree(middle)) good = middle;
      else bad = middle;
    }
    return good;
  };
  const out: (readonly [number, number])[] = [];
  for (let i = 0; i < LOOKS; i += 1) {
    if (!free[i] || free[i - 1]) continue;
    let end = i;
    while (free[end + 1]) end += 1;
    const [first, last] = [places[i] ?? from, places[end] ?? to];
    out.push([
      i === 0 ? from : between(first, places[i - 1] ?? from),
      end === LOOKS - 1 ? to : between(last, places[end + 1] ?? to),
    ]);
  }
  // The floor of a slot through the axis is no face of its own: it ends at none of its circles.
  return run.kind === "plane" ? out.filter(([a, b]) => b === to || (a === from && a > ALIKE)) : out;
}

/**
 * Half section of a body about an axis: of all faces of revolution those that bound what the turning body fills. Flats,
 * slots, cross holes and bolt circles therefore leave the turned outline as it was before they were milled.
 */
export function halfSection(body: StepBody, faces: readonly SurfacedFace[], axis: Axis3): HalfSection {
  const runs: Run[] = [],
    others: SurfacedFace[] = [];
  for (const f of faces) {
    const m = f.surface.meridian(axis),
      span = m && spanOf(f, m, axis);
    if (!m || !span) {
      others.push(f);
      continue;
    }
    const { outward } = f.face,
      normal = meridianNormal(m, span[0]);
    const run = runs.find(
      (r) =>
        isSameMeridian(r.meridian, m) &&
        part.dot(meridianNormal(r.meridian, moved(r.meridian, m, span[0])), normal) > 0 === (r.outward === outward),
    );
    if (!run) runs.push({ meridian: m, kind: f.surface.kind, outward, spans: [span] });
    else if (m.kind === "arc") run.spans = [...run.spans, span];
    else {
      const ends = span.map((t) => moved(run.meridian, m, t));
      run.spans = [...run.spans, [Math.min(...ends), Math.max(...ends)]];
    }
  }
  const crossings = body.isSolid ? others.flatMap((f) => crossingOf(f, axis) ?? []) : [];
  const curves = runs.flatMap((run) =>
    union(run.spans, nearOf(run.meridian), run.meridian.kind === "arc" && Math.abs(run.meridian.centre.r) >= ALIKE)
      .flatMap((span) => freeParts(run, span, crossings))
      .flatMap(([from, to]) => segmentsOf(run.meridian, from, to))
      .filter((s) => part.lengthOf(s) > ALIKE)
      .map((segment) => ({ segment, kind: run.kind, isFitted: run.meridian.kind === "profile" })),
  );
  return { curves, others };
}

/** Parameter on one meridian of a point given on another that is the same curve. */
const moved = (on: Meridian, m: Meridian, t: number) => meridianParameter(on, meridianPoint(m, t));
