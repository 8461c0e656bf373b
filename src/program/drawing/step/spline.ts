import type { Vec3 } from "./vec3.ts";

/** A point with its weight: (wx, wy, wz, w). */
type Weighted = readonly [number, number, number, number];

/** Degree, control points and knots (each as often as its multiplicity) of a rational spline. */
export interface Spline {
  readonly degree: number;
  readonly points: readonly Weighted[];
  readonly knots: readonly number[];
}

/** A control point with its weight. */
export const weighted = (p: Vec3, w: number): Weighted => [p[0] * w, p[1] * w, p[2] * w, w];

/** Whether the numbers of a spline fit each other; only such may be evaluated. */
export const isSpline = ({ degree, points, knots }: Spline) =>
  Number.isInteger(degree) &&
  degree >= 1 &&
  degree <= 25 &&
  points.length > degree &&
  knots.length === points.length + degree + 1 &&
  knots.every((k, i) => i === 0 || k >= (knots[i - 1] ?? k)) &&
  (knots[points.length] ?? 0) > (knots[degree] ?? 0) &&
  points.every((p) => p[3] > 0);

/** Knots repeated by their multiplicities; null where both lists do not fit or grow too long. */
export function knotsOf(values: readonly number[], multiplicities: readonly number[]): number[] | null {
  if (values.length !== multiplicities.length) return null;
  if (!multiplicities.every((m) => Number.isInteger(m) && m >= 1 && m <= 30)) return null;
  return values.flatMap((k, i) => Array.from({ length: multiplicities[i] ?? 0 }, () => k));
}

/** Knots 0, 1, 2 … of a spline without any: at its ends as often as `ends`. */
export function evenKnots(count: number, degree: number, clamped: boolean): number[] {
  const inner = count - degree;
  if (!clamped) return Array.from({ length: count + degree + 1 }, (_, i) => i - degree);
  return Array.from({ length: count + degree + 1 }, (_, i) => Math.min(Math.max(i - degree, 0), inner));
}

/** First and last parameter. */
export const domainOf = ({ degree, points, knots }: Spline): readonly [number, number] => [
  knots[degree] ?? 0,
  knots[points.length] ?? 1,
];

/** The weighted point at a parameter, by de Boor's algorithm. */
function weightedAt({ degree, points, knots }: Spline, at: number): Weighted {
  const [first, last] = [knots[degree] ?? 0, knots[points.length] ?? 1],
    t = Math.min(Math.max(at, first), last);
  let low = degree,
    high = points.length - 1;
  // The last span whose knot does not exceed t.
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((knots[middle] ?? 0) <= t) low = middle;
    else high = middle - 1;
  }
  const d = Array.from({ length: degree + 1 }, (_, j) => points[low - degree + j] ?? ([0, 0, 0, 1] as const));
  for (let r = 1; r <= degree; r += 1)
    for (let j = degree; j >= r; j -= 1) {
      const i = low - degree + j,
        from = knots[i] ?? 0,
        width = (knots[i + degree - r + 1] ?? 0) - from,
        k = width > 0 ? (t - from) / width : 0;
      const [a, b] = [d[j - 1], d[j]];
      if (!a || !b) continue;
      d[j] = [a[0] + k * (b[0] - a[0]), a[1] + k * (b[1] - a[1]), a[2] + k * (b[2] - a[2]), a[3] + k * (b[3] - a[3])];
    }
  return d[degree] ?? [0, 0, 0, 1];
}

/** The point at a parameter; parameters outside the domain are its ends. */
export function splineAt(s: Spline, t: number): Vec3 {
  const [x, y, z, w] = weightedAt(s, t);
  return [x / w, y / w, z / w];
}

/** A surface as rows of control points along v, one row for each control point along u. */
export interface SplineSurface {
  readonly u: Omit<Spline, "points">;
  readonly v: Omit<Spline, "points">;
  readonly rows: readonly (readonly Weighted[])[];
}

/** Curve of a surface with constant v, over u. */
export const alongU = (s: SplineSurface, v: number): Spline => ({
  ...s.u,
  points: s.rows.map((points) => weightedAt({ ...s.v, points }, v)),
});

/** The same surface with u and v exchanged. */
export const exchanged = (s: SplineSurface): SplineSurface => ({
  u: s.v,
  v: s.u,
  rows: (s.rows[0] ?? []).map((_, j) => s.rows.map((row) => row[j] ?? ([0, 0, 0, 1] as const))),
});
