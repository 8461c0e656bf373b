/**
 * How a space reads and makes its points: the first axis to the right, the second upwards, so that counter-clockwise
 * and left mean the same in every space. A direction or a difference is written like a point.
 */
export interface Axes<P> {
  readonly x: (p: P) => number;
  readonly y: (p: P) => number;
  readonly point: (x: number, y: number) => P;
}

/**
 * The length of a step. What engines have for it takes care of numbers near the ends of their range, for a tenth of
 * what a plan takes.
 */
export const hypotenuse = (dx: number, dy: number): number => Math.sqrt(dx * dx + dy * dy);

export type Vectors<P> = ReturnType<typeof vectorsOf<P>>;

/** Sums, products and turns of the points of a space. Lengths as the space has them, mm. */
export function vectorsOf<P>({ x, y, point }: Axes<P>) {
  const sum = (a: P, b: P): P => point(x(a) + x(b), y(a) + y(b));
  const difference = (a: P, b: P): P => point(x(a) - x(b), y(a) - y(b));
  const scaled = (a: P, k: number): P => point(x(a) * k, y(a) * k);
  /** The point `k` times a direction away from `p`; for a direction of length 1, `k` mm. */
  const beyond = (p: P, way: P, k: number): P => point(x(p) + x(way) * k, y(p) + y(way) * k);
  const dot = (a: P, b: P): number => x(a) * x(b) + y(a) * y(b);
  /** Positive when `b` points to the left of `a`. */
  const cross = (a: P, b: P): number => x(a) * y(b) - y(a) * x(b);
  const sizeOf = (a: P): number => hypotenuse(x(a), y(a));
  const apart = (a: P, b: P): number => hypotenuse(x(a) - x(b), y(a) - y(b));
  /** A quarter turn counter-clockwise: the left of a direction. */
  const leftOf = (a: P): P => point(-y(a), x(a));
  /** The same direction with length 1; a direction without length stays. */
  const unit = (a: P): P => {
    const size = sizeOf(a);
    return size > 0 ? point(x(a) / size, y(a) / size) : a;
  };
  /** Angle of a direction to the first axis, radians, −π … π. */
  const angleOf = (a: P): number => Math.atan2(y(a), x(a));
  /** The direction of length 1 at an angle in radians. */
  const heading = (angle: number): P => point(Math.cos(angle), Math.sin(angle));
  /** The point of a circle at an angle in radians. */
  const onCircle = (centre: P, radius: number, angle: number): P =>
    point(x(centre) + radius * Math.cos(angle), y(centre) + radius * Math.sin(angle));
  /** A point turned about a centre, degrees, counter-clockwise positive. Whole quarters are exact. */
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
