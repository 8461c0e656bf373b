import { cross3, dot3, minus, size3, times, unit3, type Placing, type V3 } from "../space.ts";

/** A right-handed system of axes of length 1, with this z axis and its x axis nearest to a direction, if it gives one. */
export function uprightFrame(origin: V3, z: V3, towards: V3 | null): Placing {
  const across = (d: V3) => unit3(minus(d, times(z, dot3(d, z))));
  const x =
    (towards && across(towards)) ?? across(Math.abs(z[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]) ?? ([1, 0, 0] as const);
  return { origin, x, y: cross3(z, x), z };
}

/** Distance of two points. */
export const apart3 = (a: V3, b: V3): number => size3(minus(a, b));
