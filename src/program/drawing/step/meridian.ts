import { NOTHING, ROUND, SAME } from "../../../kernel/tolerance.ts";
import { at, part, type Pt } from "../../../kernel/geometry/point.ts";
import { minus, dot3, cross3, size3, type V3 } from "../space.ts";

/** Axis of revolution: a point and a direction of length 1. */
export interface Axis3 {
  readonly origin: V3;
  readonly direction: V3;
}

/** Surfaces and axes nearer than this are the same, mm: CAD systems write places to about 0.00001. */
export const ALIKE = 5e-4;
/**
 * Intersections and fillets that a system writes as splines may be this far off, mm: one of CATIA V5 was 0.019 mm, and
 * its fillets 0.011 mm.
 */
export const ROUGH = 0.03;
/** Directions that differ by less are the same, radians. */
export const PARALLEL = 1e-5;

/** Place of a point in the half section of an axis: z along it, r its distance. */
export function sectionPoint(axis: Axis3, p: V3): Pt {
  const d = minus(p, axis.origin),
    z = dot3(d, axis.direction);
  return at(z, Math.sqrt(Math.max(dot3(d, d) - z * z, 0)));
}

/** Whether a line is this axis, in either direction. */
export function isSameAxis(axis: Axis3, other: Axis3): boolean {
  return size3(cross3(axis.direction, other.direction)) < PARALLEL * 10 && sectionPoint(axis, other.origin).r < ALIKE;
}

/**
 * Curve of a surface of revolution in its half section. Its parameter grows along `direction` of a line, counter-clockwise
 * on an arc (an angle), and with that of a profile. `left`: the surface's normal is on the left of that.
 */
export type Meridian = { readonly left: boolean } & (
  | { readonly kind: "line"; readonly origin: Pt; readonly direction: Pt }
  | { readonly kind: "arc"; readonly centre: Pt; readonly size: number }
  | { readonly kind: "profile"; readonly profile: Profile }
);

/** A smooth curve of the half section over its parameter. */
export interface Profile {
  readonly point: (t: number) => Pt;
  readonly from: number;
  readonly to: number;
}

/** Parts into which a profile is divided to look at it. */
const LOOKS = 96;
/** Points of a profile, evenly spaced in its parameter. */
const pointsOf = ({ point, from, to }: Profile) =>
  Array.from({ length: LOOKS + 1 }, (_, i) => point(from + ((to - from) * i) / LOOKS));

/** Parameter of the point of a meridian that is nearest. */
export function meridianParameter(m: Meridian, p: Pt): number {
  if (m.kind === "line") return (p.z - m.origin.z) * m.direction.z + (p.r - m.origin.r) * m.direction.r;
  if (m.kind === "arc") return Math.atan2(p.r - m.centre.r, p.z - m.centre.z);
  const { point, from, to } = m.profile,
    far = (t: number) => part.apart(point(t), p);
  let step = (to - from) / LOOKS,
    best = from,
    near = Infinity;
  pointsOf(m.profile).forEach((q, i) => {
    const d = part.apart(q, p);
    if (d < near) [best, near] = [from + i * step, d];
  });
  for (; step > (to - from) * ROUND; step /= 2)
    for (const t of [Math.max(best - step, from), Math.min(best + step, to)]) {
      const d = far(t);
      if (d < near) [best, near] = [t, d];
    }
  return best;
}

/** Point of a meridian. */
export function meridianPoint(m: Meridian, t: number): Pt {
  if (m.kind === "line") return at(m.origin.z + t * m.direction.z, m.origin.r + t * m.direction.r);
  if (m.kind === "arc") return at(m.centre.z + m.size * Math.cos(t), m.centre.r + m.size * Math.sin(t));
  return m.profile.point(t);
}

/** Direction of growing parameter, of length 1. */
export function meridianDirection(m: Meridian, t: number): Pt {
  if (m.kind === "line") return m.direction;
  if (m.kind === "arc") return at(-Math.sin(t), Math.cos(t));
  const { point, from, to } = m.profile,
    h = (to - from) * SAME;
  return part.unit(part.difference(point(Math.min(t + h, to)), point(Math.max(t - h, from))));
}

/** The normal of the surface at a parameter, in the half section. */
export function meridianNormal(m: Meridian, t: number): Pt {
  const d = meridianDirection(m, t);
  return m.left ? at(-d.r, d.z) : at(d.r, -d.z);
}

/** Whether two meridians are the same line or circle. */
export function isSameMeridian(a: Meridian, b: Meridian): boolean {
  if (a.kind === "line" && b.kind === "line") {
    const off = part.difference(b.origin, a.origin);
    return (
      Math.abs(part.cross(a.direction, b.direction)) < PARALLEL * 10 && Math.abs(part.cross(off, a.direction)) < ALIKE
    );
  }
  return (
    a.kind === "arc" && b.kind === "arc" && part.apart(a.centre, b.centre) < ALIKE && Math.abs(a.size - b.size) < ALIKE
  );
}

/** A profile as what it is: a line or an arc where it is one within the tolerance (mm). Null for one without length. */
export function meridianOf(profile: Profile, left: boolean, tolerance: number): Meridian | null {
  const points = pointsOf(profile),
    [first, second, middle, last] = [points[0], points[1], points[LOOKS / 2], points[LOOKS]];
  if (!first || !second || !middle || !last) return null;
  if (!points.every((p) => Number.isFinite(p.z) && Number.isFinite(p.r))) return null;
  const length = part.apart(first, last);
  if (length > tolerance) {
    const direction = part.unit(part.difference(last, first));
    if (points.every((p) => Math.abs(part.cross(part.difference(p, first), direction)) < tolerance))
      return { kind: "line", origin: first, direction, left };
  } else if (points.every((p) => part.apart(p, first) <= tolerance)) return null;
  // The ends of a closed profile coincide: its thirds are apart.
  const round =
    circleOnAxis(points, tolerance) ??
    (length > tolerance
      ? circleThrough(first, middle, last)
      : circleThrough(first, points[LOOKS / 3] ?? middle, points[(2 * LOOKS) / 3] ?? last));
  if (round && points.every((p) => Math.abs(part.apart(p, round.centre) - round.size) < tolerance)) {
    const isCcw = part.cross(part.difference(first, round.centre), part.difference(second, first)) > 0;
    return { kind: "arc", ...round, left: isCcw === left };
  }
  return { kind: "profile", profile, left };
}

/** Circle through all points with its centre on the axis; a short piece of a sphere does not show it by itself. */
function circleOnAxis(points: readonly Pt[], tolerance: number): { readonly centre: Pt; readonly size: number } | null {
  const [a, b] = [points[0], points.at(-1)];
  if (!a || !b || Math.abs(a.z - b.z) < tolerance) return null;
  const centre = at((a.z + b.z) / 2 + ((a.r - b.r) * (a.r + b.r)) / (2 * (a.z - b.z)), 0),
    size = part.apart(a, centre);
  return size < 1e5 && points.every((p) => Math.abs(part.apart(p, centre) - size) < tolerance)
    ? { centre, size }
    : null;
}

/** Circle through three points; null when they are in line or the circle is of no size a part has. */
function circleThrough(a: Pt, b: Pt, c: Pt): { readonly centre: Pt; readonly size: number } | null {
  const [bz, br, cz, cr] = [b.z - a.z, b.r - a.r, c.z - a.z, c.r - a.r],
    d = 2 * (bz * cr - br * cz);
  if (Math.abs(d) < NOTHING) return null;
  const [bb, cc] = [bz * bz + br * br, cz * cz + cr * cr],
    [uz, ur] = [(cr * bb - br * cc) / d, (bz * cc - cz * bb) / d],
    size = Math.hypot(uz, ur);
  return size < 1e5 ? { centre: at(a.z + uz, a.r + ur), size } : null;
}
