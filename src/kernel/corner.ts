import type { Pt, Segment, Turn } from "./point.ts";
import { ROUND, SAME } from "./tolerance.ts";
import { axial, radius } from "./units.ts";

/** What stands on a corner of a contour: a chamfer with equal legs along both lines, or a tangential arc. Size in mm. */
export interface CornerElement {
  readonly kind: "chamfer" | "round";
  readonly size: number;
}

/** Both neighbours shortened, and the element between them. */
export interface Cut {
  readonly before: Segment;
  readonly between: Segment;
  readonly after: Segment;
}

interface Vector {
  readonly z: number;
  readonly r: number;
}

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const minus = (a: Vector, b: Vector): Vector => ({ z: a.z - b.z, r: a.r - b.r });
const dot = (a: Vector, b: Vector) => a.z * b.z + a.r * b.r;
const cross = (a: Vector, b: Vector) => a.z * b.r - a.r * b.z;
const size = (a: Vector) => Math.hypot(a.z, a.r);
const unit = (a: Vector): Vector => {
  const length = size(a) || 1;
  return { z: a.z / length, r: a.r / length };
};
/** A quarter turn counter-clockwise. */
const left = (a: Vector): Vector => ({ z: -a.r, r: a.z });

/** Direction of travel in a point of a segment, as a unit vector. */
export function direction(s: Segment, point: Pt): { readonly z: number; readonly r: number } {
  if (s.kind === "line") return unit(minus(s.to, s.from));
  const out = left(unit(minus(point, s.centre)));
  return s.turn === "ccw" ? out : { z: -out.z, r: -out.r };
}

/** How far along its segment a point lies, mm, negative before its beginning. */
function along(s: Segment, point: Pt): number {
  if (s.kind === "line") return dot(minus(point, s.from), unit(minus(s.to, s.from)));
  const spoke = minus(s.from, s.centre);
  const other = minus(point, s.centre);
  const angle = Math.atan2(cross(spoke, other), dot(spoke, other)) * (s.turn === "ccw" ? 1 : -1);
  return (angle < -ROUND ? angle + 2 * Math.PI : angle) * size(spoke);
}

/** Length of a segment, mm. An arc that ends where it starts is a full circle. */
export function lengthOf(s: Segment): number {
  if (s.kind === "line") return size(minus(s.to, s.from));
  const far = along(s, s.to);
  return far <= SAME ? 2 * Math.PI * size(minus(s.from, s.centre)) : far;
}

/** The curve on which centres of circles of radius `r` lie that touch a segment on one side. */
type Track = { readonly point: Vector; readonly along: Vector } | { readonly centre: Vector; readonly radius: number };

function track(s: Segment, r: number, side: Turn): Track | null {
  if (s.kind === "line") {
    const way = unit(minus(s.to, s.from));
    if (size(way) < ROUND) return null;
    const k = side === "ccw" ? r : -r;
    return { point: { z: s.from.z - way.r * k, r: s.from.r + way.z * k }, along: way };
  }
  const own = size(minus(s.from, s.centre));
  const grown = s.turn === side ? own - r : own + r;
  return grown > ROUND ? { centre: s.centre, radius: grown } : null;
}

function meet(a: Track, b: Track): Vector[] {
  if ("point" in a && "point" in b) {
    const bend = cross(a.along, b.along);
    if (Math.abs(bend) < ROUND) return [];
    const k = cross(minus(b.point, a.point), b.along) / bend;
    return [{ z: a.point.z + a.along.z * k, r: a.point.r + a.along.r * k }];
  }
  if ("point" in a) {
    if ("point" in b) return [];
    const k = dot(minus(b.centre, a.point), a.along);
    const foot = { z: a.point.z + a.along.z * k, r: a.point.r + a.along.r * k };
    const rest = b.radius ** 2 - dot(minus(b.centre, foot), minus(b.centre, foot));
    if (rest < 0) return [];
    const half = Math.sqrt(rest);
    return [half, -half].map((h) => ({ z: foot.z + a.along.z * h, r: foot.r + a.along.r * h }));
  }
  if ("point" in b) return meet(b, a);
  const between = minus(b.centre, a.centre);
  const gap = size(between);
  if (gap < ROUND) return [];
  const way = unit(between);
  const k = (gap * gap + a.radius ** 2 - b.radius ** 2) / (2 * gap);
  const rest = a.radius ** 2 - k * k;
  if (rest < 0) return [];
  const half = Math.sqrt(rest);
  return [half, -half].map((h) => ({ z: a.centre.z + way.z * k - way.r * h, r: a.centre.r + way.r * k + way.z * h }));
}

/** Where a circle with centre `c` touches a segment. */
function touch(s: Segment, c: Vector): Pt {
  if (s.kind === "line") {
    const way = unit(minus(s.to, s.from));
    const k = dot(minus(c, s.from), way);
    return at(s.from.z + way.z * k, s.from.r + way.r * k);
  }
  const own = size(minus(s.from, s.centre));
  const way = unit(minus(c, s.centre));
  return at(s.centre.z + way.z * own, s.centre.r + way.r * own);
}

/** A segment used up to nothing becomes a line without length: an arc from a point to itself would be a full circle. */
const ending = (s: Segment, to: Pt): Segment => (along(s, to) > SAME ? { ...s, to } : { kind: "line", from: s.from, to });
const starting = (s: Segment, from: Pt): Segment =>
  lengthOf(s) - along(s, from) > SAME ? { ...s, from } : { kind: "line", from, to: s.to };

function rounded(before: Segment, after: Segment, r: number): Cut | null {
  const bend = cross(direction(before, before.to), direction(after, after.from));
  const turn: Turn = bend > 0 ? "ccw" : "cw";
  const [one, two] = [track(before, r, turn), track(after, r, turn)];
  if (!one || !two) return null;
  let best: Cut | null = null;
  let loss = Infinity;
  for (const c of meet(one, two)) {
    const [from, to] = [touch(before, c), touch(after, c)];
    const [keep, skip] = [along(before, from), along(after, to)];
    const lost = lengthOf(before) - keep + skip;
    if (keep < -ROUND || skip < -ROUND || keep > lengthOf(before) + ROUND || skip > lengthOf(after) + ROUND || lost >= loss) continue;
    loss = lost;
    const between: Segment = { kind: "arc", from, to, centre: at(c.z, c.r), turn };
    best = { before: ending(before, from), between, after: starting(after, to) };
  }
  return best;
}

/** Puts an element on the corner between two segments that meet; null when it does not fit or can not stand there. */
export function cutCorner(before: Segment, after: Segment, corner: CornerElement): Cut | null {
  if (corner.kind === "round") return rounded(before, after, corner.size);
  if (before.kind === "arc" || after.kind === "arc") return null;
  const [one, two] = [lengthOf(before), lengthOf(after)];
  if (corner.size > one + ROUND || corner.size > two + ROUND) return null;
  const [back, on] = [direction(before, before.to), direction(after, after.from)];
  const from = at(before.to.z - back.z * corner.size, before.to.r - back.r * corner.size);
  const to = at(after.from.z + on.z * corner.size, after.from.r + on.r * corner.size);
  return { before: { ...before, to: from }, between: { kind: "line", from, to }, after: { ...after, from: to } };
}
