import { ROUND } from "../../kernel/tolerance.ts";
import { add, minus, size3, times, type Curve3, type Spline3, type V3 } from "./space.ts";

/** Most control points and highest degree that are read. */
const MOST_POINTS = 20_000,
  HIGHEST = 25;

/** Knots of a curve that begins and ends in its first and last point. */
function clamped(degree: number, count: number): number[] {
  const inner = count - degree;
  return Array.from({ length: count + degree + 1 }, (_, i) => Math.min(Math.max(0, i - degree), inner));
}

/**
 * A spline of a file's numbers; missing or unordered knots become even ones, missing weights 1. Null where no curve
 * follows from them.
 */
export function splineOf(
  degree: number,
  knots: readonly number[],
  points: readonly V3[],
  weights: readonly number[],
): [Spline3] | null {
  const count = points.length;
  if (!Number.isInteger(degree) || degree < 1 || degree > HIGHEST || count <= degree || count > MOST_POINTS)
    return null;
  const isSound =
    knots.length === count + degree + 1 &&
    knots.every((k, i) => Number.isFinite(k) && k >= (knots[i - 1] ?? k)) &&
    (knots[count] ?? 0) > (knots[degree] ?? 0);
  const areWeights = weights.length === count && weights.every((w) => w > 0 && w < 1e9);
  if (weights.length > 0 && !areWeights) return null;
  return [
    {
      kind: "spline",
      degree,
      knots: isSound ? knots : clamped(degree, count),
      points,
      weights: areWeights ? weights : points.map(() => 1),
    },
  ];
}

/** Homogeneous coordinates of a point: x w, y w, z w, w. */
type V4 = readonly [number, number, number, number];

/** The point of a spline at a parameter (de Boor's algorithm). */
export function splinePoint({ degree, knots, points, weights }: Spline3, parameter: number): V3 {
  const last = points.length - 1,
    [start = 0, end = 1] = [knots[degree], knots[last + 1]],
    t = Math.min(Math.max(parameter, start), end);
  let low = degree,
    high = last;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((knots[middle] ?? 0) <= t) low = middle;
    else high = middle - 1;
  }
  const span = low;
  const d: V4[] = Array.from({ length: degree + 1 }, (_, i) => {
    const at = span - degree + i,
      w = weights[at] ?? 1,
      p = points[at] ?? [0, 0, 0];
    return [p[0] * w, p[1] * w, p[2] * w, w];
  });
  for (let level = 1; level <= degree; level += 1)
    for (let i = degree; i >= level; i -= 1) {
      const from = knots[span - degree + i] ?? 0,
        to = knots[span + 1 + i - level] ?? 0,
        k = to > from ? (t - from) / (to - from) : 0,
        [a, b] = [d[i - 1], d[i]];
      if (a && b)
        d[i] = [a[0] + (b[0] - a[0]) * k, a[1] + (b[1] - a[1]) * k, a[2] + (b[2] - a[2]) * k, a[3] + (b[3] - a[3]) * k];
    }
  const [x, y, z, w] = d[degree] ?? [0, 0, 0, 1];
  return [x / w, y / w, z / w];
}

/** Parameters between which a spline is smooth: its ends and the knots where it may have a corner. */
export function smoothParts({ degree, knots, points }: Spline3): number[] {
  const ends = [knots[degree] ?? 0, knots[points.length] ?? 1] as const;
  const out: number[] = [ends[0]];
  for (let i = degree + 1; i < points.length; i += 1) {
    const k = knots[i] ?? 0;
    let many = 1;
    while (knots[i + many] === k) many += 1;
    if (many >= degree && k > (out.at(-1) ?? k) && k < ends[1]) out.push(k);
  }
  return [...out, ends[1]];
}

/**
 * The smooth curve through points, for splines that are given by their fit points alone: cubic, with the lengths of
 * its chords as parameters and without curvature at open ends.
 */
export function interpolated(through: readonly V3[], closed: boolean): Curve3[] | null {
  const points = through.filter((p, i) => i === 0 || size3(minus(p, through[i - 1] ?? p)) > ROUND),
    first = points[0];
  if (!first || points.length < 2 || points.length > MOST_POINTS) return null;
  const isRing = closed && points.length > 2;
  // A closed curve is solved over three rounds, whose middle one is smooth at its seam.
  const round = isRing && size3(minus(first, points.at(-1) ?? first)) < ROUND ? points.slice(0, -1) : points;
  const all = isRing ? [...round, ...round, ...round, first] : points;
  const chord = all.slice(1).map((p, i) => size3(minus(p, all[i] ?? p)));
  const slopes = naturalSlopes(all, chord);
  const spans = all.slice(1).map((to, i): Spline3 => {
    const from = all[i] ?? to,
      third = (chord[i] ?? 0) / 3,
      zero: V3 = [0, 0, 0];
    return {
      kind: "spline",
      degree: 3,
      knots: [0, 0, 0, 0, 1, 1, 1, 1],
      points: [from, add(from, times(slopes[i] ?? zero, third)), minus(to, times(slopes[i + 1] ?? zero, third)), to],
      weights: [1, 1, 1, 1],
    };
  });
  return isRing ? spans.slice(round.length, 2 * round.length) : spans;
}

/** First derivatives of the natural cubic spline in its points: a tridiagonal system, solved from the front. */
function naturalSlopes(all: readonly V3[], chord: readonly number[]): V3[] {
  const n = all.length,
    upper: number[] = [],
    right: V3[] = [];
  for (let i = 0; i < n; i += 1) {
    const [before, behind] = [chord[i - 1], chord[i]],
      p = all[i] ?? [0, 0, 0];
    const [a, b, c] = [
      before === undefined ? 0 : 1 / before,
      2 * ((before === undefined ? 0 : 1 / before) + (behind === undefined ? 0 : 1 / behind)),
      behind === undefined ? 0 : 1 / behind,
    ];
    const back = before === undefined ? [0, 0, 0] : times(minus(p, all[i - 1] ?? p), 3 / (before * before)),
      front = behind === undefined ? [0, 0, 0] : times(minus(all[i + 1] ?? p, p), 3 / (behind * behind));
    const pivot = b - a * (upper[i - 1] ?? 0);
    upper.push(c / pivot);
    right.push(times(minus(add(back as V3, front as V3), times(right[i - 1] ?? [0, 0, 0], a)), 1 / pivot));
  }
  const out = [...right];
  for (let i = n - 2; i >= 0; i -= 1)
    out[i] = minus(right[i] ?? [0, 0, 0], times(out[i + 1] ?? [0, 0, 0], upper[i] ?? 0));
  return out;
}
