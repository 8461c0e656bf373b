/** A point or direction of the space of a solid, mm. */
export type Vec3 = readonly [x: number, y: number, z: number];

/** Vectors of a solid. */
export const vec3 = {
  plus: (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
  minus: (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
  times: (a: Vec3, k: number): Vec3 => [a[0] * k, a[1] * k, a[2] * k],
  dot: (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  cross: (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  size: (a: Vec3) => Math.hypot(a[0], a[1], a[2]),
  apart: (a: Vec3, b: Vec3) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
  /** Of length 1; null for no direction. */
  unit(a: Vec3): Vec3 | null {
    const n = Math.hypot(a[0], a[1], a[2]);
    return n > 1e-12 ? [a[0] / n, a[1] / n, a[2] / n] : null;
  },
};

/** A right-handed system of axes of length 1. */
export interface Frame {
  readonly origin: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
}

/** The frame with this z axis whose x axis is nearest to a direction; any x axis where that gives none. */
export function frameOf(origin: Vec3, z: Vec3, towards: Vec3 | null): Frame {
  const across = (d: Vec3) => vec3.unit(vec3.minus(d, vec3.times(z, vec3.dot(d, z))));
  const x =
    (towards && across(towards)) ?? across(Math.abs(z[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]) ?? ([1, 0, 0] satisfies Vec3);
  return { origin, x, y: vec3.cross(z, x), z };
}

/** A point given in a frame. */
export const inFrame = (f: Frame, x: number, y: number, z = 0): Vec3 =>
  vec3.plus(f.origin, vec3.plus(vec3.times(f.x, x), vec3.plus(vec3.times(f.y, y), vec3.times(f.z, z))));
