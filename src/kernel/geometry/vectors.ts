/**
 * Access to the points of a space: the first axis to the right, the second upwards, so that counter-clockwise and left
 * mean the same in every space. A direction or a difference has the same type as a point.
 */
export interface Axes<P> {
  readonly x: (p: P) => number;
  readonly y: (p: P) => number;
  readonly point: (x: number, y: number) => P;
}

/**
 * Length of a vector. Math.hypot also handles numbers near the ends of their range, at a cost of a tenth of the
 * planning time.
 */
export const hypotenuse = (dx: number, dy: number): number => Math.sqrt(dx * dx + dy * dy);

export type Vectors<P> = ReturnType<typeof vectorsOf<P>>;

/** Vector functions for the points of a space. Lengths in its unit, mm. */
export function vectorsOf<P>({ x, y, point }: Axes<P>) {
  const sum = (a: P, b: P): P => point(x(a) + x(b), y(a) + y(b));
  const difference = (a: P, b: P): P => point(x(a) - x(b), y(a) - y(b));
  const scaled = (a: P, k: number): P => point(x(a) * k, y(a) * k);
  /** The point at `k` times a direction from `p`; for a unit vector, `k` mm. */
  const beyond = (p: P, way: P, k: number): P => point(x(p) + x(way) * k, y(p) + y(way) * k);
  const dot = (a: P, b: P): number => x(a) * x(b) + y(a) * y(b);
  /** Positive when `b` points to the left of `a`. */
  const cross = (a: P, b: P): number => x(a) * y(b) - y(a) * x(b);
  const sizeOf = (a: P): number => hypotenuse(x(a), y(a));
  const apart = (a: P, b: P): number => hypotenuse(x(a) - x(b), y(a) - y(b));
  /** The direction turned by a quarter counter-clockwise, to the left. */
  const leftOf = (a: P): P => point(-y(a), x(a));
  /** The unit vector; a vector without length is returned unchanged. */
  const unit = (a: P): P => {
    const size = sizeOf(a);
    return size > 0 ? point(x(a) / size, y(a) / size) : a;
  };
  /** Angle between a direction and the first axis, radians, −π … π. */
  const angleOf = (a: P): number => Math.atan2(y(a), x(a));
  /** The unit vector at an angle in radians. */
  const heading = (angle: number): P => point(Math.cos(angle), Math.sin(angle));
  /** The point of a circle at an angle in radians. */
  const onCircle = (centre: P, radius: number, angle: number): P =>
    point(x(centre) + radius * Math.cos(angle), y(centre) + radius * Math.sin(angle));
  /** A point rotated about a centre, degrees, counter-clockwise positive. Multiples of 90° are exact. */
  const turned = (p: P, centre: P, angle: number): P => {
    const quarters = angle / 90;
    const exact = Number.isInteger(quarters)
      ? [
          [1, 0],
          [0, 1],
          [-1, 0],
          [0, -1],
        ][((quarters % 4) + 4) % 4]
      : undefined;
    const radians = (angle * Math.PI) / 180;
    const [cos, sin] = [exact?.[0] ?? Math.cos(radians), exact?.[1] ?? Math.sin(radians)];
    const d = difference(p, centre);
    return point(x(centre) + x(d) * cos - y(d) * sin, y(centre) + x(d) * sin + y(d) * cos);
  };
  return {
    point,
    sum,
    difference,
    scaled,
    beyond,
    dot,
    cross,
    sizeOf,
    apart,
    leftOf,
    unit,
    angleOf,
    heading,
    onCircle,
    turned,
  };
}
