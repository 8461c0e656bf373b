import { NOTHING } from "../../../kernel/tolerance.ts";
import { at, type Pt } from "../../../kernel/geometry/point.ts";
import type { Part21Entity, Part21Value } from "../../files/part21.ts";
import { enumerationIn, listIn, numberIn, recordOf } from "../../files/part21-values.ts";
import { ALIKE, isSameAxis, meridianOf, PARALLEL, ROUGH, sectionPoint, type Axis3, type Meridian } from "./meridian.ts";
import { isSimple, numbersIn, pointsIn, stepCurve, type StepCurve } from "./step-curve.ts";
import type { StepGeometry } from "./step-geometry.ts";
import { add, cross3, dot3, minus, size3, times, unit3, type Placing, type Spline3, type V3 } from "../space.ts";
import { splinePoint } from "../splines.ts";
import {
  alongU,
  domainOf,
  domainOfV,
  exchanged,
  repeatedKnots,
  surfaceOf,
  uniformKnots,
  type SplineSurface,
} from "./spline-surface.ts";
import { uprightFrame } from "./frame.ts";

/** A surface as far as turning goes. */
export interface StepSurface {
  readonly kind: "plane" | "cylinder" | "cone" | "torus" | "sphere" | "revolution" | "spline" | "other";
  /** Axis of revolution; of a plane its normal through its origin; null for a sphere, which has every one, and others. */
  readonly axis: Axis3 | null;
  /** Centre of a sphere. */
  readonly centre?: V3;
  /** Its curve in the half section of an axis; null when it is not of revolution about that. */
  readonly meridian: (about: Axis3) => Meridian | null;
}

/** Points at which a profile is looked at to see whether it lies in a plane with the axis. */
const POINTS = 24;
/** A profile within this of a line or a circle is one, mm. */
const PLAIN = 2e-4;

const none: StepSurface = { kind: "other", axis: null, meridian: () => null };
const axisOf = (f: Placing): Axis3 => ({ origin: f.origin, direction: f.z });
/** 1 when the direction of a surface is that of the axis, -1 against it, 0 when they are not parallel. */
const along = (about: Axis3, d: V3) =>
  size3(cross3(about.direction, d)) < PARALLEL * 10 ? Math.sign(dot3(about.direction, d)) : 0;

function planeOf(f: Placing): StepSurface {
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
function coneOf(f: Placing, size: number, slope: number): StepSurface {
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

function torusOf(f: Placing, major: number, minor: number): StepSurface {
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

/** `left`: the normal points to the centre. */
function sphereOf(centre: V3, size: number, left = false): StepSurface {
  return {
    kind: "sphere",
    axis: null,
    centre,
    meridian: (about) => {
      const place = sectionPoint(about, centre);
      return place.r < ALIKE ? { kind: "arc", centre: at(place.z, 0), size, left } : null;
    },
  };
}

/**
 * A profile turned about an axis. A profile across the axis is taken on the side where it is farthest from it, a line, which
 * has no ends, on the side of a point of its face.
 */
function revolved(curve: StepCurve, axis: Axis3, near: V3 | null): StepSurface {
  // A line has no ends: any part of it shows how it leans.
  const [from, to] = curve.range ?? [0, curve.period ?? 100],
    points = Array.from({ length: POINTS + 1 }, (_, i) => curve.at(from + ((to - from) * i) / POINTS)),
    section = points.map((p) => sectionPoint(axis, p));
  const far = section.reduce((best, p, i) => (p.r > (section[best]?.r ?? 0) ? i : best), 0),
    rise = (section.at(-1)?.z ?? 0) - (section[0]?.z ?? 0);
  const beside =
    curve.kind === "line" && near && Math.abs(rise) > ALIKE
      ? curve.at((100 * (sectionPoint(axis, near).z - (section[0]?.z ?? 0))) / rise)
      : points[far];
  const outwards = radialAt(axis, beside ?? axis.origin);
  const isFlat =
    outwards !== null &&
    points.every((p) => Math.abs(dot3(minus(p, axis.origin), cross3(axis.direction, outwards))) < ALIKE);
  return {
    kind: "revolution",
    axis,
    meridian: (about) => {
      if (!isSameAxis(about, axis)) return null;
      const turned = along(about, axis.direction) < 0;
      const place = (p: V3): Pt => {
        const s = sectionPoint(about, p);
        return isFlat && dot3(minus(p, axis.origin), outwards) < 0 ? at(s.z, -s.r) : s;
      };
      // A line that leans out of the plane of the axis makes a hyperboloid, which has no ends here.
      if (curve.kind === "line" && !isFlat) return null;
      // The normal is the direction of the turn crossed with that of the profile.
      return meridianOf({ point: (t) => place(curve.at(t)), from, to }, !turned, PLAIN);
    },
  };
}

function radialAt(axis: Axis3, p: V3): V3 | null {
  const d = minus(p, axis.origin);
  return unit3(minus(d, times(axis.direction, dot3(d, axis.direction))));
}

/** Spline surface of an entity; null where its numbers do not fit. */
function splineSurface(g: StepGeometry, entity: Part21Entity): SplineSurface | null {
  const whole = isSimple(entity),
    base = whole ? entity[0]?.values.slice(1) : recordOf(entity, "B_SPLINE_SURFACE")?.values;
  const [degreeU, degreeV] = [base && numberIn(base[0]), base && numberIn(base[1])];
  if (!base || typeof degreeU !== "number" || typeof degreeV !== "number") return null;
  const weights = listIn(recordOf(entity, "RATIONAL_B_SPLINE_SURFACE")?.values[0]).map(numbersIn),
    lists = listIn(base[2]);
  const rows = lists.flatMap((row) => {
    const points = pointsIn(g, row);
    return points ? [points] : [];
  });
  if (rows.length !== lists.length || !g.spend(rows.reduce((sum, row) => sum + row.length, 0))) return null;
  const withKnots = recordOf(entity, "B_SPLINE_SURFACE_WITH_KNOTS"),
    given = whole ? withKnots?.values.slice(8) : withKnots?.values,
    isUniform = recordOf(entity, "UNIFORM_SURFACE") !== undefined;
  const bare = (count: number, degree: number) => (isUniform ? uniformKnots(count, degree) : []);
  const u = given ? repeatedKnots(numbersIn(given[2]), numbersIn(given[0])) : bare(rows.length, degreeU),
    v = given ? repeatedKnots(numbersIn(given[3]), numbersIn(given[1])) : bare(rows[0]?.length ?? 0, degreeV);
  return u && v && surfaceOf({ degree: degreeU, knots: u }, { degree: degreeV, knots: v }, rows, weights);
}

/** Axis of a circle through three points of space. */
function axisThrough(a: V3, b: V3, c: V3): Axis3 | null {
  const [ab, ac] = [minus(b, a), minus(c, a)],
    normal = cross3(ab, ac),
    n = dot3(normal, normal),
    direction = unit3(normal);
  if (!direction || n < NOTHING) return null;
  const to = add(times(cross3(normal, ab), dot3(ac, ac)), times(cross3(ac, normal), dot3(ab, ab)));
  return { origin: add(a, times(to, 1 / (2 * n))), direction };
}

/** Places at which a spline surface is looked at in each direction. */
const LOOKS = 8;

/** Normal of control points that lie in one plane; null for others. */
function flatNormal(s: SplineSurface): V3 | null {
  const points = s.points.flat(),
    at3 = (u: number, v: number) => splinePoint(alongU(s, v), u);
  const [u0, u1] = domainOfV(exchanged(s)),
    [v0, v1] = domainOfV(s),
    [u, v] = [(u0 + u1) / 2, (v0 + v1) / 2],
    origin = at3(u, v);
  const du = minus(at3(u + (u1 - u0) / 8, v), origin),
    dv = minus(at3(u, v + (v1 - v0) / 8), origin),
    normal = unit3(cross3(du, dv));
  return normal && points.every((p) => Math.abs(dot3(minus(p, origin), normal)) < PLAIN) ? normal : null;
}

/**
 * A spline surface whose curves of constant v are circles about one axis is of revolution, whoever wrote it; within ROUGH,
 * since some systems write their fillets as splines of a tolerance of their own.
 */
function splineRevolved(s: SplineSurface, isExchanged: boolean): StepSurface | null {
  const [from, to] = domainOfV(s);
  const at3 = (curve: ReturnType<typeof alongU>, k: number) => {
    const [a, b] = domainOf(curve);
    return splinePoint(curve, a + (b - a) * k);
  };
  const curveAt = (j: number) => alongU(s, from + ((to - from) * j) / LOOKS),
    looksAt = (c: Spline3) => Array.from({ length: LOOKS + 1 }, (_, i) => at3(c, i / LOOKS));
  /** How far points are off a circle about an axis. */
  const offOf = (axis: Axis3, points: readonly V3[]) => {
    const places = points.map((p) => sectionPoint(axis, p)),
      [first] = places;
    return Math.max(...places.map((p) => Math.hypot(p.z - (first?.z ?? 0), p.r - (first?.r ?? 0))));
  };
  // Most free forms show at one curve what they are. Of a closed curve first and last point coincide.
  const wide = curveAt(LOOKS / 2 + 0.3),
    own = axisThrough(at3(wide, 0.05), at3(wide, 0.4), at3(wide, 0.75));
  if (!own || offOf(own, looksAt(wide)) > ROUGH) return null;
  const looks = Array.from({ length: LOOKS + 1 }, (_, j) => looksAt(curveAt(j))),
    farthest = (axis: Axis3) => Math.max(...looks.map((points) => offOf(axis, points)));
  if (farthest(own) > ROUGH) return null;
  const turned = exchanged(s),
    meridian = alongU(turned, domainOfV(turned)[0]);
  const meridianAbout = (about: Axis3) => {
    const off = farthest(about);
    if (off > ROUGH) return null;
    const start = at3(wide, 0),
      turn = cross3(minus(start, about.origin), minus(at3(wide, 0.01), start));
    // The normal is du × dv; u turns about the axis, in its direction or against it.
    const forwards = dot3(turn, about.direction) > 0,
      profile = { point: (k: number) => sectionPoint(about, at3(meridian, k)), from: 0, to: 1 };
    return meridianOf(profile, forwards !== isExchanged, Math.max(off, PLAIN));
  };
  const round = meridianAbout(own);
  // A sphere is one about any axis through its centre, not only about that of its numbers.
  if (round?.kind === "arc" && Math.abs(round.centre.r) < ALIKE)
    return sphereOf(add(own.origin, times(own.direction, round.centre.z)), round.size, round.left);
  return { kind: "spline", axis: own, meridian: meridianAbout };
}

/** Extrusion of a line is a plane, that of a circle along its axis a cylinder. */
function extruded(g: StepGeometry, values: readonly Part21Value[]): StepSurface {
  const vector = g.values(values[2], "VECTOR"),
    d = vector && g.direction(vector[1]),
    curve = stepCurve(g, values[1]);
  if (!d || !curve) return none;
  if (curve.kind === "line") {
    const normal = unit3(cross3(minus(curve.at(1), curve.at(0)), d));
    return normal ? planeOf({ origin: curve.at(0), z: normal, x: d, y: cross3(normal, d) }) : none;
  }
  const [a, b] = curve.range ?? [0, 2 * Math.PI],
    axis = axisThrough(curve.at(a + (b - a) * 0.05), curve.at(a + (b - a) * 0.4), curve.at(a + (b - a) * 0.75));
  if (!axis || size3(cross3(axis.direction, d)) > PARALLEL * 10) return none;
  const sizes = Array.from({ length: 17 }, (_, i) => sectionPoint(axis, curve.at(a + ((b - a) * i) / 16)));
  const first = sizes[0];
  if (!first || sizes.some((p) => Math.abs(p.r - first.r) > PLAIN)) return none;
  const ccw = dot3(cross3(minus(curve.at(a), axis.origin), minus(curve.at(a + (b - a) * 0.02), curve.at(a))), d) > 0;
  return {
    kind: "cylinder",
    axis,
    meridian: (about) =>
      isSameAxis(about, axis)
        ? { kind: "line", origin: at(sectionPoint(about, axis.origin).z, first.r), direction: at(1, 0), left: ccw }
        : null,
  };
}

/** Surface of an entity; `near`: a point of it. */
export function stepSurface(g: StepGeometry, v: Part21Value, near: V3 | null, depth = 0): StepSurface {
  const entity = g.entity(v);
  if (!entity || depth > 5) return none;
  if (entity.some((r) => /(B_SPLINE|BEZIER|UNIFORM)_SURFACE(_WITH_KNOTS)?$/.test(r.type))) {
    const s = splineSurface(g, entity);
    if (!s) return none;
    const z = flatNormal(s),
      [corner] = s.points[0] ?? [];
    if (z && corner) return planeOf(uprightFrame(corner, z, null));
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
      return f && size !== null && size > 0 ? sphereOf(f.origin, size) : none;
    case "SURFACE_OF_REVOLUTION": {
      const curve = stepCurve(g, values[1]),
        axis = g.frame(values[2]);
      return curve && axis ? revolved(curve, axisOf(axis), near) : none;
    }
    case "SURFACE_OF_LINEAR_EXTRUSION":
      return extruded(g, values);
    case "RECTANGULAR_TRIMMED_SURFACE":
    case "CURVE_BOUNDED_SURFACE":
      return stepSurface(g, values[1], near, depth + 1);
    default:
      return none;
  }
}
