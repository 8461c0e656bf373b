import { NOTHING } from "../../kernel/tolerance.ts";

/** A point or direction in space. */
export type V3 = readonly [x: number, y: number, z: number];

/** Lines, arcs of ellipses and splines in space: each kind is closed under any affine map. */
export type Curve3 =
  | { readonly kind: "line"; readonly from: V3; readonly to: V3 }
  /** centre + u cos t + v sin t, from `start` to `end` radians, start < end. */
  | {
      readonly kind: "conic";
      readonly centre: V3;
      readonly u: V3;
      readonly v: V3;
      readonly start: number;
      readonly end: number;
    }
  | Spline3;

/** A rational B-spline; `knots` has degree + 1 more entries than `points`, all weights are positive. */
export interface Spline3 {
  readonly kind: "spline";
  readonly degree: number;
  readonly knots: readonly number[];
  readonly points: readonly V3[];
  readonly weights: readonly number[];
}

/** An affine map of space: images of the axes and of the origin. */
export interface Placing {
  readonly x: V3;
  readonly y: V3;
  readonly z: V3;
  readonly origin: V3;
}

export const add = (a: V3, b: V3): V3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const times = (a: V3, k: number): V3 => [a[0] * k, a[1] * k, a[2] * k];
export const minus = (a: V3, b: V3): V3 => add(a, times(b, -1));
export const dot3 = (a: V3, b: V3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross3 = (a: V3, b: V3): V3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const size3 = (a: V3): number => Math.sqrt(dot3(a, a));
/** The unit vector; null for a vector without direction. */
export function unit3(a: V3): V3 | null {
  const size = size3(a);
  return size > NOTHING ? times(a, 1 / size) : null;
}

export const UNPLACED: Placing = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], origin: [0, 0, 0] };
export const shift = (origin: V3): Placing => ({ ...UNPLACED, origin });
export const stretch = (x: number, y: number, z: number): Placing => ({
  x: [x, 0, 0],
  y: [0, y, 0],
  z: [0, 0, z],
  origin: [0, 0, 0],
});
/** Rotation about the z axis, radians. */
export const spin = (angle: number): Placing => ({
  ...UNPLACED,
  x: [Math.cos(angle), Math.sin(angle), 0],
  y: [-Math.sin(angle), Math.cos(angle), 0],
});

const turned = (m: Placing, p: V3): V3 => add(add(times(m.x, p[0]), times(m.y, p[1])), times(m.z, p[2]));
export const placed = (m: Placing, p: V3): V3 => add(turned(m, p), m.origin);
/** `first` is applied before `m`. */
export const after = (m: Placing, first: Placing): Placing => ({
  x: turned(m, first.x),
  y: turned(m, first.y),
  z: turned(m, first.z),
  origin: placed(m, first.origin),
});

export function placedCurve(m: Placing, c: Curve3): Curve3 {
  switch (c.kind) {
    case "line":
      return { kind: "line", from: placed(m, c.from), to: placed(m, c.to) };
    case "conic":
      return { ...c, centre: placed(m, c.centre), u: turned(m, c.u), v: turned(m, c.v) };
    case "spline":
      return { ...c, points: c.points.map((p) => placed(m, p)) };
  }
}

/** Points that span a curve: it lies in a plane, or on a line, exactly when they do. */
export function spanOf(c: Curve3): readonly V3[] {
  if (c.kind === "line") return [c.from, c.to];
  return c.kind === "spline" ? c.points : [c.centre, add(c.centre, c.u), add(c.centre, c.v)];
}

/** A direction closer to the z axis than this takes y for its arbitrary axis. */
const ARBITRARY = 1 / 64;

/**
 * Object coordinates of an extrusion direction (group 210) by the arbitrary axis algorithm of the DXF reference; null
 * for no direction.
 */
export function objectPlacing(normal: V3): Placing | null {
  const z = unit3(normal);
  if (!z) return null;
  const isUpright = Math.abs(z[0]) < ARBITRARY && Math.abs(z[1]) < ARBITRARY;
  const x = unit3(cross3(isUpright ? [0, 1, 0] : [0, 0, 1], z));
  return x && { x, y: cross3(z, x), z, origin: [0, 0, 0] };
}
