import type { Pt, Segment, Turn } from "./point.ts";
import { ROUND, SAME } from "./tolerance.ts";
import { axial, radius } from "./units.ts";

/** A direction or difference in part space. */
export interface Vector {
  readonly z: number;
  readonly r: number;
}

/** A point from bare numbers. */
export const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const minus = (a: Vector, b: Vector): Vector => ({ z: a.z - b.z, r: a.r - b.r });
const dot = (a: Vector, b: Vector) => a.z * b.z + a.r * b.r;
export const cross = (a: Vector, b: Vector) => a.z * b.r - a.r * b.z;
const size = (a: Vector) => Math.hypot(a.z, a.r);
const unit = (a: Vector): Vector => {
  const length = size(a) || 1;
  return { z: a.z / length, r: a.r / length };
};
/** A quarter turn counter-clockwise. */
const left = (a: Vector): Vector => ({ z: -a.r, r: a.z });

/** Direction of travel in a point of a segment, as a unit vector. */
export function direction(s: Segment, point: Pt): Vector {
  if (s.kind === "line") return unit(minus(s.to, s.from));
  const out = left(unit(minus(point, s.centre)));
  return s.turn === "ccw" ? out : { z: -out.z, r: -out.r };
}

/** How far along its segment a point lies, mm, negative before its beginning. */
export function along(s: Segment, point: Pt): number {
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
export type Track = { readonly point: Vector; readonly along: Vector } | { readonly centre: Vector; readonly radius: number };

export function track(s: Segment, r: number, side: Turn): Track | null {
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

/** Where two such curves meet: none, one or two points. */
export function meet(a: Track, b: Track): Vector[] {
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
export function touch(s: Segment, c: Vector): Pt {
  if (s.kind === "line") {
    const way = unit(minus(s.to, s.from));
    const k = dot(minus(c, s.from), way);
    return at(s.from.z + way.z * k, s.from.r + way.r * k);
  }
  const own = size(minus(s.from, s.centre));
  const way = unit(minus(c, s.centre));
  return at(s.centre.z + way.z * own, s.centre.r + way.r * own);
}
