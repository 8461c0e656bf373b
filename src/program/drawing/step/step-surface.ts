import { at, type Pt } from "../../../kernel/geometry/point.ts";
import type { Part21Value } from "../../files/part21.ts";
import { enumerationIn, listIn, numberIn, recordOf } from "../../files/part21-values.ts";
import {
  ALIKE,
  isSameAxis,
  meridianOf,
  PARALLEL,
  ROUGH,
  sectionPoint,
  type Axis3,
  type Meridian,
} from "./meridian.ts";
import { alongU, domainOf, evenKnots, exchanged, isSpline, knotsOf, splineAt, type SplineSurface } from "./spline.ts";
import { controlPoints, isSimple, numbersIn, stepCurve, weightsOf, type StepCurve } from "./step-curve.ts";
import type { StepGeometry } from "./step-geometry.ts";
import { frameOf, vec3, type Frame, type Vec3 } from "./vec3.ts";

/** A surface as far as turning goes. */
export interface StepSurface {
  readonly kind: "plane" | "cylinder" | "cone" | "torus" | "sphere" | "revolution" | "spline" | "other";
  /** Axis of revolution; of a plane its normal through its origin; null for a sphere, which has every one, and others. */
  readonly axis: Axis3 | null;
  /** Centre of a sphere. */
  readonly centre?: Vec3;
  /** Its curve in the half section of an axis; null when it is not of revolution about that. */
  readonly meridian: (about: Axis3) => Meridian | null;
}

/** Points at which a profile is looked at to see whether it lies in a plane with the axis. */
const POINTS = 24;
/** A profile within this of a line or a circle is one, mm. */
const PLAIN = 2e-4;

const none: StepSurface = { kind: "other", axis: null, meridian: () => null };
const axisOf = (f: Frame): Axis3 => ({ origin: f.origin, direction: f.z });
/** 1 when the direction of a surface is that of the axis, -1 against it, 0 when they are not parallel. */
const along = (about: Axis3, d: Vec3) =>
  vec3.size(vec3.cross(about.direction, d)) < PARALLEL * 10 ? Math.sign(vec3.dot(about.direction, d)) : 0;

function planeOf(f: Frame): StepSurface {
  return {
    kind: "plane",
    axis: axisOf(f),
    meridian: (about) => {
      const side = along(about, f.z);
      if (side === 0) return null;
      // Outwards along r: the left of that is against z.
      return { kind: "line", origin: at(sectionPoint(about, f.origin).z, 0), direction: at(0, 1), left: side < 0 };
    },
  };
}

/** Cone or cylinder: the radius at the origin, and what it grows by along the axis. */
function coneOf(f: Frame, size: number, slope: number): StepSurface {
  const axis = axisOf(f);
  return {
    kind: slope === 0 ? "cylinder" : "cone",
    axis,
    meridian: (about) => {
      if (!isSameAxis(about, axis)) return null;
      const growth = slope * along(about, f.z),
        n = Math.hypot(1, growth);
      const direction = at(1 / n, growth / n);
      return { kind: "line", origin: at(sectionPoint(about, f.origin).z, size), direction, left: true };
    },
  };
}

function torusOf(f: Frame, major: number, minor: number): StepSurface {
  const axis = axisOf(f);
  return {
    kind: "torus",
    axis,
    meridian: (about) =>
      isSameAxis(about, axis)
        ? { kind: "arc", centre: at(sectionPoint(about, f.origin).z, major), size: minor, left: false }
        : null,
  };
}

function sphereOf(f: Frame, size: number): StepSurface {
  return {
    kind: "sphere",
    axis: null,
    centre: f.origin,
    meridian: (about) => {
      const centre = sectionPoint(about, f.origin);
      return centre.r < ALIKE ? { kind: "arc", centre: at(centre.z, 0), size, left: false } : null;
    },
  };
}


/** A profile turned about an axis. A profile across the axis is taken on the side where it is farthest from it. */
function revolved(curve: StepCurve, axis: Axis3): StepSurface {
  // A line has no ends: any part of it shows how it leans.
  const [from, to] = curve.range ?? [0, curve.period ?? 100],
    points = Array.from({ length: POINTS + 1 }, (_, i) => curve.at(from + ((to - from) * i) / POINTS)),
    section = points.map((p) => sectionPoint(axis, p));
  const far = section.reduce((best, p, i) => (p.r > (section[best]?.r ?? 0) ? i : best), 0),
    outwards = radialAt(axis, points[far] ?? axis.origin);
  const isFlat =
    outwards !== null &&
    points.every((p) => Math.abs(vec3.dot(vec3.minus(p, axis.origin), vec3.cross(axis.direction, outwards))) < ALIKE);
  return {
    kind: "revolution",
    axis,
    meridian: (about) => {
      if (!isSameAxis(about, axis)) return null;
      const turned = along(about, axis.direction) < 0;
      const place = (p: Vec3): Pt => {
        const s = sectionPoint(about, p);
        return isFlat && vec3.dot(vec3.minus(p, axis.origin), outwards) < 0 ? at(s.z, -s.r) : s;
      };
      // A line that leans out of the plane of the axis makes a hyperboloid, which has no ends here.
      if (curve.kind === "line" && !isFlat) return null;
      // The normal is the direction of the turn crossed with that of the profile.
      return meridianOf({ point: (t) => place(curve.at(t)), from, to }, !turned, PLAIN);
    },
  };
}

function radialAt(axis: Axis3, p: Vec3): Vec3 | null {
  const d = vec3.minus(p, axis.origin);
  return vec3.unit(vec3.minus(d, vec3.times(axis.direction, vec3.dot(d, axis.direction))));
}

/** Spline surface of an entity; null where its numbers do not fit. */
function splineSurface(g: StepGeometry, v: Part21Value): SplineSurface | null {
  const entity = g.entity(v);
  if (!entity) return null;
  const whole = isSimple(entity),
    base = whole ? entity[0]?.values.slice(1) : recordOf(entity, "B_SPLINE_SURFACE")?.values;
  const [degreeU, degreeV] = [base && numberIn(base[0]), base && numberIn(base[1])];
  if (!base || typeof degreeU !== "number" || typeof degreeV !== "number") return null;
  const weights = whole ? undefined : weightsOf(entity, "RATIONAL_B_SPLINE_SURFACE"),
    lists = listIn(base[2]);
  const rows = lists.flatMap((row, i) => {
    const points = controlPoints(g, row, weights ? listIn(weights[i]) : null);
    return points ? [points] : [];
  });
  const knots = recordOf(entity, "B_SPLINE_SURFACE_WITH_KNOTS"),
    given = whole ? knots?.values.slice(8) : knots?.values;
  const width = rows[0]?.length ?? 0,
    clamped = !recordOf(entity, "UNIFORM_SURFACE");
  if (rows.length !== lists.length || rows.some((r) => r.length !== width) || rows.length * width > 40_000) return null;
  const u = given ? knotsOf(numbersIn(given[2]), numbersIn(given[0])) : evenKnots(rows.length, degreeU, clamped),
    w = given ? knotsOf(numbersIn(given[3]), numbersIn(given[1])) : evenKnots(width, degreeV, clamped);
  if (!u || !w) return null;
  const surface = { u: { degree: degreeU, knots: u }, v: { degree: degreeV, knots: w }, rows };
  const fits = isSpline({ ...surface.v, points: rows[0] ?? [] }) && isSpline({ ...surface.u, points: rows.flatMap((r) => r.slice(0, 1)) });
  return fits ? surface : null;
}

/** Axis of a circle through three points of space. */
function axisThrough(a: Vec3, b: Vec3, c: Vec3): Axis3 | null {
  const [ab, ac] = [vec3.minus(b, a), vec3.minus(c, a)],
    normal = vec3.cross(ab, ac),
    n = vec3.dot(normal, normal),
    direction = vec3.unit(normal);
  if (!direction || n < 1e-10) return null;
  const to = vec3.plus(
    vec3.times(vec3.cross(normal, ab), vec3.dot(ac, ac)),
    vec3.times(vec3.cross(ac, normal), vec3.dot(ab, ab)),
  );
  return { origin: vec3.plus(a, vec3.times(to, 1 / (2 * n))), direction };
}

/** Places at which a spline surface is looked at in each direction. */
const LOOKS = 8;

/** Normal of control points that lie in one plane; null for others. */
function flatNormal(s: SplineSurface): Vec3 | null {
  const points = s.rows.flatMap((row) => row.map(([x, y, z, w]): Vec3 => [x / w, y / w, z / w])),
    at3 = (u: number, v: number) => splineAt(alongU(s, v), u);
  const [u0, u1] = domainOf({ ...s.u, points: s.rows.flatMap((r) => r.slice(0, 1)) }),
    [v0, v1] = domainOf({ ...s.v, points: s.rows[0] ?? [] }),
    [u, v] = [(u0 + u1) / 2, (v0 + v1) / 2],
    origin = at3(u, v);
  const du = vec3.minus(at3(u + (u1 - u0) / 8, v), origin),
    dv = vec3.minus(at3(u, v + (v1 - v0) / 8), origin),
    normal = vec3.unit(vec3.cross(du, dv));
  return normal && points.every((p) => Math.abs(vec3.dot(vec3.minus(p, origin), normal)) < PLAIN) ? normal : null;
}

/**
 * A spline surface whose curves of constant v are circles about one axis is of revolution, whoever wrote it; within ROUGH,
 * since some systems write their fillets as splines of a tolerance of their own.
 */
function splineRevolved(s: SplineSurface, isExchanged: boolean): StepSurface | null {
  const [from, to] = domainOf({ ...s.v, points: s.rows[0] ?? [] });
  const at3 = (curve: ReturnType<typeof alongU>, k: number) => {
    const [a, b] = domainOf(curve);
    return splineAt(curve, a + (b - a) * k);
  };
  const curves = Array.from({ length: LOOKS + 1 }, (_, j) => alongU(s, from + ((to - from) * j) / LOOKS)),
    looks = curves.map((c) => Array.from({ length: LOOKS + 1 }, (_, i) => at3(c, i / LOOKS)));
  /** How far the curves are off circles about an axis. */
  const offOf = (axis: Axis3) =>
    Math.max(
      ...looks.map((points) => {
        const places = points.map((p) => sectionPoint(axis, p)),
          [first] = places;
        return Math.max(...places.map((p) => Math.hypot(p.z - (first?.z ?? 0), p.r - (first?.r ?? 0))));
      }),
    );
  // Of a closed curve first and last point coincide.
  const axes = curves.flatMap((c) => axisThrough(at3(c, 0.05), at3(c, 0.4), at3(c, 0.75)) ?? []),
    middle = axes[axes.length >> 1],
    own = middle && offOf(middle) < ROUGH ? middle : null;
  if (!own) return null;
  const [u] = domainOf({ ...s.u, points: s.rows.flatMap((r) => r.slice(0, 1)) }),
    meridian = alongU(exchanged(s), u),
    wide = curves[LOOKS >> 1] ?? meridian;
  return {
    kind: "spline",
    axis: own,
    meridian: (about) => {
      const off = offOf(about);
      if (off > ROUGH) return null;
      const start = at3(wide, 0),
        turn = vec3.cross(vec3.minus(start, about.origin), vec3.minus(at3(wide, 0.01), start));
      // The normal is du × dv; u turns about the axis, in its direction or against it.
      const forwards = vec3.dot(turn, about.direction) > 0,
        profile = { point: (k: number) => sectionPoint(about, at3(meridian, k)), from: 0, to: 1 };
      return meridianOf(profile, forwards !== isExchanged, Math.max(off, PLAIN));
    },
  };
}

/** Extrusion of a line is a plane, that of a circle along its axis a cylinder. */
function extruded(g: StepGeometry, values: readonly Part21Value[]): StepSurface {
  const vector = g.values(values[2], "VECTOR"),
    d = vector && g.direction(vector[1]),
    curve = stepCurve(g, values[1]);
  if (!d || !curve) return none;
  if (curve.kind === "line") {
    const normal = vec3.unit(vec3.cross(vec3.minus(curve.at(1), curve.at(0)), d));
    return normal ? planeOf({ origin: curve.at(0), z: normal, x: d, y: vec3.cross(normal, d) }) : none;
  }
  const [a, b] = curve.range ?? [0, 2 * Math.PI],
    axis = axisThrough(curve.at(a + (b - a) * 0.05), curve.at(a + (b - a) * 0.4), curve.at(a + (b - a) * 0.75));
  if (!axis || vec3.size(vec3.cross(axis.direction, d)) > PARALLEL * 10) return none;
  const sizes = Array.from({ length: 17 }, (_, i) => sectionPoint(axis, curve.at(a + ((b - a) * i) / 16)));
  const first = sizes[0];
  if (!first || sizes.some((p) => Math.abs(p.r - first.r) > PLAIN)) return none;
  const ccw =
    vec3.dot(
      vec3.cross(vec3.minus(curve.at(a), axis.origin), vec3.minus(curve.at(a + (b - a) * 0.02), curve.at(a))),
      d,
    ) > 0;
  return {
    kind: "cylinder",
    axis,
    meridian: (about) =>
      isSameAxis(about, axis)
        ? { kind: "line", origin: at(sectionPoint(about, axis.origin).z, first.r), direction: at(1, 0), left: ccw }
        : null,
  };
}

/** Surface of an entity. */
export function stepSurface(g: StepGeometry, v: Part21Value, depth = 0): StepSurface {
  const entity = g.entity(v);
  if (!entity || depth > 5) return none;
  if (entity.some((r) => /(B_SPLINE|BEZIER|UNIFORM)_SURFACE(_WITH_KNOTS)?$/.test(r.type))) {
    const s = splineSurface(g, v);
    if (!s) return none;
    const z = flatNormal(s),
      [corner] = s.rows[0] ?? [];
    if (z && corner) return planeOf(frameOf(vec3.times([corner[0], corner[1], corner[2]], 1 / corner[3]), z, null));
    return splineRevolved(s, false) ?? splineRevolved(exchanged(s), true) ?? { ...none, kind: "spline" };
  }
  const { type, values } = entity[0] ?? { type: "", values: [] },
    f = g.frame(values[1]),
    size = g.length(values[2]);
  switch (type) {
    case "PLANE":
      return f ? planeOf(f) : none;
    case "CYLINDRICAL_SURFACE":
      return f && size !== null && size > 0 ? coneOf(f, size, 0) : none;
    case "CONICAL_SURFACE": {
      const angle = numberIn(values[3]);
      if (!f || size === null || angle === null) return none;
      const slope = Math.tan(angle * g.units.angle);
      return Number.isFinite(slope) && Math.abs(slope) < 1e6 ? coneOf(f, size, slope) : none;
    }
    case "TOROIDAL_SURFACE":
    case "DEGENERATE_TOROIDAL_SURFACE": {
      const minor = g.length(values[3]);
      if (!f || size === null || minor === null || minor <= 0) return none;
      // The inner half of a lemon-shaped torus has its centre beyond the axis.
      return torusOf(f, values.length > 4 && enumerationIn(values[4]) === "F" ? -size : size, minor);
    }
    case "SPHERICAL_SURFACE":
      return f && size !== null && size > 0 ? sphereOf(f, size) : none;
    case "SURFACE_OF_REVOLUTION": {
      const curve = stepCurve(g, values[1]),
        axis = g.frame(values[2]);
      return curve && axis ? revolved(curve, axisOf(axis)) : none;
    }
    case "SURFACE_OF_LINEAR_EXTRUSION":
      return extruded(g, values);
    case "RECTANGULAR_TRIMMED_SURFACE":
    case "CURVE_BOUNDED_SURFACE":
      return stepSurface(g, values[1], depth + 1);
    default:
      return none;
  }
}
