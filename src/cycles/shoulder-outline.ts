import type { Frame } from "../kernel/flat.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import { part, type Pt } from "../kernel/point.ts";
import { type Axial, type Degrees, type Diameter, inDegrees, type Length, radians, rounded, STEP, toRadius } from "../kernel/units.ts";
import { angleBelow, cornerElementOf, LEG, namedContour, type NamedContour, roundOf } from "./corner-element.ts";
import type { Dimension, Outline } from "./define.ts";
import { JOINED } from "../kernel/tolerance.ts";

/** The values that shape an extended shoulder, by what they mean. */
export interface ShoulderValues {
  readonly Q491: Diameter;
  readonly Q492: Axial;
  readonly Q493: Diameter;
  readonly Q494: Axial;
  /** Angle of the circumferential surface against the axis. */
  readonly Q495: Degrees;
  readonly Q501: number;
  readonly Q502: Length;
  readonly Q500: Length;
  /** Angle of the face against the perpendicular to the axis. */
  readonly Q496: Degrees;
  readonly Q503: number;
  readonly Q504: Length;
}

const pt = part.point;

/**
 * Contour of a longitudinal shoulder inside its box (decision "The box rule"): start element, circumferential surface
 * through (Q492, Q493), inner corner, face through (Q494, Q491), end element.
 */
export function shoulderOutline(v: ShoulderValues): Outline & NamedContour {
  const issues: Issue[] = equalEnds(v);
  const [r1, r2, z1, z2] = [toRadius(v.Q491), toRadius(v.Q493), v.Q492, v.Q494];
  const frame: Frame = { transverse: false, signU: z2 < z1 ? -1 : 1, signV: r1 > r2 ? 1 : -1 };
  const none = { contour: [], frame, sunk: false, names: [], dimensions: [] };
  if (issues.length > 0) return { ...none, issues };
  const along = Math.sign(z2 - z1);
  const out = Math.sign(r1 - r2);
  const [A, H] = [Math.abs(z2 - z1), Math.abs(r1 - r2)];
  const [t1, t2] = [Math.tan(radians(v.Q495)), Math.tan(radians(v.Q496))];
  const at = (a: number, h: number): Pt => pt(z1 + along * a, r2 + out * h);
  if (A - H * t2 <= 0) {
    const max = inDegrees(Math.atan2(A, H));
    return { ...none, issues: [issue("wallsMeet", "error", { angle: v.Q496, max, nearest: angleBelow(max) }, "Q496")] };
  }
  if (A * t1 >= H) {
    const max = inDegrees(Math.atan2(H, A));
    return { ...none, issues: [issue("wallsMeet", "error", { angle: v.Q495, max, nearest: angleBelow(max) }, "Q495")] };
  }
  const a = (A - H * t2) / (1 - t1 * t2);
  const corner = at(a, a * t1);
  const lead = out > 0 ? Math.max(r2, JOINED) : LEG;
  const built = namedContour([at(0, -lead), at(0, 0), corner, at(A, H), at(A + LEG, H)], ["Q492", "Q495", "Q496", "Q491"], [
    { element: cornerElementOf(v.Q501, v.Q502), q: "Q502" },
    { element: roundOf(v.Q500), q: "Q500" },
    { element: cornerElementOf(v.Q503, v.Q504), q: "Q504" },
  ]);
  return { ...none, ...built, dimensions: dimensionsOf(v, { start: at(0, 0), corner, end: at(A, H), along, out }) };
}

/** A contour whose start and end agree in a coordinate has no area. */
export function equalEnds(v: { Q491: Diameter; Q492: Axial; Q493: Diameter; Q494: Axial }): Issue[] {
  const issues: Issue[] = [];
  if (v.Q491 === v.Q493) issues.push(issue("startEqualsEnd", "error", { other: "Q491", value: v.Q493, nearest: nextTo(v.Q493) }, "Q493"));
  if (v.Q492 === v.Q494) issues.push(issue("startEqualsEnd", "error", { other: "Q492", value: v.Q494, nearest: nextTo(v.Q494) }, "Q494"));
  for (const q of ["Q491", "Q493"] as const)
    if (v[q] < 0) issues.push(issue("diameterNegative", "error", { value: v[q], nearest: -v[q] }, q));
  return issues;
}
/** The next value on the control's grid. */
const nextTo = (n: number) => rounded(n - STEP);

function dimensionsOf(v: ShoulderValues, g: { start: Pt; corner: Pt; end: Pt; along: number; out: number }): Dimension[] {
  const axisLine = pt(g.start.z + (g.corner.z - g.start.z), g.start.r);
  const upright = pt(g.end.z, g.corner.r);
  const away = (p: Pt, z: number, r: number): Pt => pt(p.z + z, p.r + r);
  return [
    { q: "Q491", form: "diameter", at: g.end },
    { q: "Q492", form: "z", from: pt(0, g.start.r), to: g.start },
    {
      q: "Q493",
      form: "diameter",
      at: g.start,
    },
    { q: "Q494", form: "z", from: pt(0, g.end.r), to: g.end },
    { q: "Q495", form: "angle", vertex: g.start, from: axisLine, to: g.corner },
    { q: "Q502", form: "leader", at: g.start, towards: away(g.start, -g.along, g.out) },
    {
      q: "Q500",
      form: "leader",
      at: g.corner,
      towards: away(g.corner, -g.along, g.out),
    },
    { q: "Q496", form: "angle", vertex: g.end, from: upright, to: g.corner },
    {
      q: "Q504",
      form: "leader",
      at: g.end,
      towards: away(g.end, -g.along, g.out),
    },
    ...(v.Q501 > 0 ? [{ q: "Q501", form: "leader", at: g.start, towards: away(g.start, -g.along, g.out) } as const] : []),
    ...(v.Q503 > 0 ? [{ q: "Q503", form: "leader", at: g.end, towards: away(g.end, -g.along, g.out) } as const] : []),
  ];
}
