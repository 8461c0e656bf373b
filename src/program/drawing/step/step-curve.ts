import { ROUND, SAME } from "../../../kernel/tolerance.ts";
import type { Part21Entity, Part21Value } from "../../files/part21.ts";
import { enumerationIn, listIn, numberIn, recordOf } from "../../files/part21-values.ts";
import type { StepGeometry } from "./step-geometry.ts";
import { add, minus, times, dot3, placed, type Spline3, type V3 } from "../space.ts";
import { splineOf, splinePoint } from "../splines.ts";
import { domainOf, repeatedKnots, uniformKnots } from "./spline-surface.ts";
import { apart3 } from "./frame.ts";

/** A curve of a solid over its parameter. */
export interface StepCurve {
  readonly kind: "line" | "round" | "conic" | "spline";
  readonly at: (t: number) => V3;
  /** Parameter of a point on the curve. */
  readonly parameterOf: (p: V3) => number;
  /** A full turn of circle and ellipse. */
  readonly period: number | null;
  /** Ends of a spline. */
  readonly range: readonly [number, number] | null;
}

/** Points at which a spline is looked at to find the parameter of a point. */
const LOOKS = 64;

function splineCurve(s: Spline3): StepCurve {
  const [from, to] = domainOf(s),
    at = (t: number) => splinePoint(s, t);
  const parameterOf = (p: V3) => {
    if (apart3(p, at(from)) < SAME) return from;
    if (apart3(p, at(to)) < SAME) return to;
    let best = from,
      near = Infinity,
      step = (to - from) / LOOKS;
    for (let i = 0; i <= LOOKS; i += 1) {
      const far = apart3(p, at(from + i * step));
      if (far < near) [best, near] = [from + i * step, far];
    }
    for (; step > (to - from) * ROUND; step /= 2)
      for (const t of [best - step, best + step]) {
        const far = apart3(p, at(t));
        if (far < near) [best, near] = [Math.min(Math.max(t, from), to), far];
      }
    return best;
  };
  return { kind: "spline", at, parameterOf, period: null, range: [from, to] };
}

/** Points of a list; null where one is missing. */
export function pointsIn(g: StepGeometry, list: Part21Value): readonly V3[] | null {
  const refs = listIn(list),
    points = refs.flatMap((v) => {
      const p = g.point(v);
      return p ? [p] : [];
    });
  return points.length === refs.length ? points : null;
}

/** One record with all parameters, the name first; a complex instance divides them among its records. */
export const isSimple = (entity: Part21Entity) => entity.length === 1;

/** Numbers of a list. */
export const numbersIn = (v: Part21Value) => listIn(v).flatMap((n) => numberIn(n) ?? []);

function splineIn(g: StepGeometry, entity: Part21Entity): StepCurve | null {
  const withKnots = recordOf(entity, "B_SPLINE_CURVE_WITH_KNOTS"),
    whole = isSimple(entity);
  const base = whole ? entity[0]?.values.slice(1) : recordOf(entity, "B_SPLINE_CURVE")?.values;
  const degree = base ? numberIn(base[0]) : null,
    points = base ? pointsIn(g, base[1]) : null;
  if (degree === null || !points) return null;
  const given = whole ? withKnots?.values.slice(6) : withKnots?.values;
  // Without knots a spline begins and ends in its points, as Bézier curves do.
  const bare = recordOf(entity, "UNIFORM_CURVE") ? uniformKnots(points.length, degree) : [],
    knots = given ? repeatedKnots(numbersIn(given[1]), numbersIn(given[0])) : bare;
  const weights = recordOf(entity, "RATIONAL_B_SPLINE_CURVE")?.values[0],
    made = knots && splineOf(degree, knots, points, numbersIn(weights));
  return made && splineCurve(made[0]);
}

const SPLINES = ["B_SPLINE_CURVE_WITH_KNOTS", "B_SPLINE_CURVE", "BEZIER_CURVE", "QUASI_UNIFORM_CURVE", "UNIFORM_CURVE"];

/** Curve of an entity; null for a kind that is not read. Curves on surfaces and trimmed ones are their basis. */
export function stepCurve(g: StepGeometry, v: Part21Value, depth = 0): StepCurve | null {
  const entity = g.entity(v);
  if (!entity || depth > 5) return null;
  if (entity.some((r) => SPLINES.includes(r.type))) return splineIn(g, entity);
  const { type, values } = entity[0] ?? { type: "", values: [] };
  const onSurface = entity.find((r) => /^(SURFACE|SEAM|INTERSECTION|BOUNDED_SURFACE)_CURVE$/.test(r.type));
  if (onSurface) return stepCurve(g, onSurface.values[isSimple(entity) ? 1 : 0], depth + 1);
  switch (type) {
    case "LINE": {
      const from = g.point(values[1]),
        vector = g.values(values[2], "VECTOR"),
        d = vector && g.direction(vector[1]);
      if (!from || !d) return null;
      return {
        kind: "line",
        at: (t) => add(from, times(d, t)),
        parameterOf: (p) => dot3(minus(p, from), d),
        period: null,
        range: null,
      };
    }
    case "CIRCLE":
    case "ELLIPSE":
    case "HYPERBOLA": {
      const f = g.frame(values[1]),
        a = g.length(values[2]),
        b = type === "CIRCLE" ? a : g.length(values[3]);
      if (!f || a === null || b === null || a <= 0 || b <= 0) return null;
      const x = (p: V3) => dot3(minus(p, f.origin), f.x) / a,
        y = (p: V3) => dot3(minus(p, f.origin), f.y) / b;
      return type === "HYPERBOLA"
        ? {
            kind: "conic",
            at: (t) => placed(f, [a * Math.cosh(t), b * Math.sinh(t), 0]),
            parameterOf: (p) => Math.asinh(y(p)),
            period: null,
            range: null,
          }
        : {
            kind: "round",
            at: (t) => placed(f, [a * Math.cos(t), b * Math.sin(t), 0]),
            parameterOf: (p) => Math.atan2(y(p), x(p)),
            period: 2 * Math.PI,
            range: null,
          };
    }
    case "PARABOLA": {
      const f = g.frame(values[1]),
        focal = g.length(values[2]);
      if (!f || focal === null || focal <= 0) return null;
      return {
        kind: "conic",
        at: (t) => placed(f, [focal * t * t, 2 * focal * t, 0]),
        parameterOf: (p) => dot3(minus(p, f.origin), f.y) / (2 * focal),
        period: null,
        range: null,
      };
    }
    case "POLYLINE": {
      const points = pointsIn(g, values[1]),
        made = points && splineOf(1, [], points, []);
      return made && splineCurve(made[0]);
    }
    case "TRIMMED_CURVE":
      return trimmed(g, values, depth);
    default:
      return null;
  }
}

/** A trimmed curve: its basis, with the ends where they are given as points. */
function trimmed(g: StepGeometry, values: readonly Part21Value[], depth: number): StepCurve | null {
  const basis = stepCurve(g, values[1], depth + 1);
  if (!basis) return null;
  const end = (list: Part21Value) => {
    for (const v of listIn(list)) {
      const p = g.point(v);
      if (p) return basis.parameterOf(p);
    }
    return null;
  };
  const [a, b] = [end(values[2]), end(values[3])];
  if (a === null || b === null) return basis;
  const forward = enumerationIn(values[4]) !== "F";
  return { ...basis, range: basis.period === null ? [Math.min(a, b), Math.max(a, b)] : turnBetween(a, b, forward) };
}

/** Angles from a to b in a direction, at most a full turn; equal angles are a full turn. */
export function turnBetween(a: number, b: number, forward: boolean): readonly [number, number] {
  const turn = 2 * Math.PI,
    ahead = (((b - a) % turn) + turn) % turn,
    // Rounding must not make a full turn nothing, or nothing a full turn.
    sweep = ahead < ROUND ? turn : ahead;
  if (forward) return [a, a + sweep];
  const back = turn - ahead;
  return [a, a - (back < ROUND ? turn : back)];
}
