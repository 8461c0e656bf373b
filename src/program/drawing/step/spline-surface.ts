import type { Spline3, V3 } from "../space.ts";
import { splineOf, splinePoint } from "../splines.ts";

/** Degree and knots of a spline surface in one direction. */
interface Direction {
  readonly degree: number;
  readonly knots: readonly number[];
}

/** A rational spline surface; one row of control points for each along u. */
export interface SplineSurface {
  readonly u: Direction;
  readonly v: Direction;
  readonly points: readonly (readonly V3[])[];
  readonly weights: readonly (readonly number[])[];
}

/** Knots as often as their multiplicities say; null where both lists do not fit. */
export function repeatedKnots(values: readonly number[], multiplicities: readonly number[]): number[] | null {
  if (values.length !== multiplicities.length) return null;
  if (!multiplicities.every((m) => Number.isInteger(m) && m >= 1 && m <= 30)) return null;
  return values.flatMap((k, i) => Array.from({ length: multiplicities[i] ?? 0 }, () => k));
}

/** Knots of a uniform spline, which does not begin in its first point. */
export const uniformKnots = (count: number, degree: number): number[] =>
  Array.from({ length: count + degree + 1 }, (_, i) => i - degree);

/** First and last parameter. */
export const domainOf = ({ degree, points, knots }: Spline3): readonly [number, number] => [
  knots[degree] ?? 0,
  knots[points.length] ?? 1,
];

/** A surface of a file's numbers; null where none follows from them. */
export function surfaceOf(
  u: Direction,
  v: Direction,
  points: readonly (readonly V3[])[],
  weights: readonly (readonly number[])[],
): SplineSurface | null {
  const width = points[0]?.length ?? 0;
  if (points.some((row) => row.length !== width) || points.length * width > 40_000) return null;
  const rows = points.map((row, i) => splineOf(v.degree, v.knots, row, weights[i] ?? [])?.[0]),
    column = splineOf(
      u.degree,
      u.knots,
      points.flatMap((row) => row.slice(0, 1)),
      [],
    )?.[0];
  const [first] = rows;
  if (!first || !column || !rows.every((r) => r !== undefined)) return null;
  return {
    u: { degree: u.degree, knots: column.knots },
    v: { degree: v.degree, knots: first.knots },
    points,
    weights: rows.map((r) => r?.weights ?? []),
  };
}

/** A row of a surface as a curve over v. */
const rowOf = (s: SplineSurface, i: number): Spline3 => ({
  kind: "spline",
  ...s.v,
  points: s.points[i] ?? [],
  weights: s.weights[i] ?? [],
});

/** Parameters between which v runs. */
export const domainOfV = (s: SplineSurface): readonly [number, number] => domainOf(rowOf(s, 0));

/** Curve of a surface with constant v, over u. */
export function alongU(s: SplineSurface, v: number): Spline3 {
  const rows = s.points.map((_, i) => rowOf(s, i)),
    ones = s.v.knots.map(() => 1);
  return {
    kind: "spline",
    ...s.u,
    points: rows.map((row) => splinePoint(row, v)),
    weights: rows.map((row) => splinePoint({ ...row, points: row.weights.map((w) => [w, 0, 0]), weights: ones }, v)[0]),
  };
}

/** The same surface with u and v exchanged. */
export function exchanged(s: SplineSurface): SplineSurface {
  const turned = <T>(rows: readonly (readonly T[])[]) =>
    (rows[0] ?? []).map((_, j) => rows.flatMap((row) => row.slice(j, j + 1)));
  return { u: s.v, v: s.u, points: turned(s.points), weights: turned(s.weights) };
}
