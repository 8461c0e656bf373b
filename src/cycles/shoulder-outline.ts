import { type Flat, type Frame, toFlat, toPart } from "../kernel/geometry/flat.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import { part, type Pt } from "../kernel/geometry/point.ts";
import {
  type Axial,
  type Degrees,
  degrees,
  type Diameter,
  inDegrees,
  type Length,
  length,
  radians,
  toRadius,
} from "../kernel/units.ts";
import { cornerElementOf, LEG, namedContour, type NamedContour, roundOf } from "./corner-element.ts";
import type { Dimension, Outline } from "./define.ts";
import { JOINED } from "../kernel/tolerance.ts";

/** The values of an extended shoulder that affect its contour. */
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

/** The values that a cycle without elements, corner radii and an angle at the end uses instead. */
export const PLAIN = { Q501: 0, Q502: length(0), Q500: length(0), Q496: degrees(0), Q503: 0, Q504: length(0) } as const;

const pt = part.point;

/** An outline inside a box, with the data that a plan needs. */
export interface BoxOutline extends Outline, NamedContour {
  /** The value of an angle whose wall runs in a direction: degrees against the cutting direction, positive rising. */
  readonly angleAt: (q: string, direction: number) => number;
}

/** Orientation of strategy space over a box: from its first corner to its second, deeper corner. */
export const boxFrame = (v: Pick<ShoulderValues, "Q491" | "Q492" | "Q493" | "Q494">, transverse: boolean): Frame =>
  transverse
    ? { transverse, signU: v.Q491 > v.Q493 ? -1 : 1, signV: v.Q494 < v.Q492 ? 1 : -1 }
    : { transverse, signU: v.Q494 < v.Q492 ? -1 : 1, signV: v.Q491 > v.Q493 ? 1 : -1 };

/**
 * Contour of a shoulder inside its box (decision "The box rule"), in cutting direction: start element, surface at the
 * depth of the second corner, inner corner, wall, end element. Along the axis the surface is circumferential and the
 * wall is a face; across it the surface is the face.
 */
export function shoulderOutline(v: ShoulderValues, transverse: boolean): BoxOutline {
  const issues: Issue[] = equalEnds(v);
  const frame = boxFrame(v, transverse);
  const none = { contour: [], frame, sunk: false, names: [], dimensions: [], angleAt };
  if (issues.length > 0) return { ...none, issues };
  const [p1, p2] = [pt(v.Q492, toRadius(v.Q491)), pt(v.Q494, toRadius(v.Q493))].map((p) => toFlat(frame, p)) as [
    Flat,
    Flat,
  ];
  const [A, H] = [p2.u - p1.u, p1.v - p2.v];
  const [t1, t2] = [Math.tan(radians(v.Q495)), Math.tan(radians(v.Q496))];
  const at = (a: number, h: number): Pt => toPart(frame, { u: p1.u + a, v: p2.v + h });
  if (A - H * t2 <= 0) {
    const max = inDegrees(Math.atan2(A, H));
    return { ...none, issues: [issue("wallsMeet", "error", { angle: v.Q496, max }, "Q496")] };
  }
  if (A * t1 >= H) {
    const max = inDegrees(Math.atan2(H, A));
    return { ...none, issues: [issue("wallsMeet", "error", { angle: v.Q495, max }, "Q495")] };
  }
  const a = (A - H * t2) / (1 - t1 * t2);
  const corner = at(a, a * t1);
  // Towards the axis the outside of the part ends there: an outer element cannot be longer.
  const inwards = Math.max(toRadius(v.Q493), JOINED);
  const lead = !transverse && frame.signV > 0 ? inwards : LEG;
  const out = transverse && frame.signU < 0 ? inwards : LEG;
  const built = namedContour(
    [at(0, -lead), at(0, 0), corner, at(A, H), at(A + out, H)],
    ["", "Q495", "Q496", ""],
    [
      { element: cornerElementOf(v.Q501, v.Q502), q: "Q502" },
      { element: roundOf(v.Q500), q: "Q500" },
      { element: cornerElementOf(v.Q503, v.Q504), q: "Q504" },
    ],
  );
  const shape = { start: at(0, 0), corner, end: at(A, H), axisFoot: at(a, 0), wallFoot: at(A, a * t1) };
  return { ...none, ...built, dimensions: dimensionsOf(v, shape, frame) };
}

const angleAt = (q: string, direction: number) => (q === "Q496" ? 90 - direction : direction);

/** A contour whose start and end agree in a coordinate has no area, and neither has one wholly beyond the axis. */
export function equalEnds(v: { Q491: Diameter; Q492: Axial; Q493: Diameter; Q494: Axial }): Issue[] {
  const issues: Issue[] = [];
  if (v.Q491 === v.Q493) issues.push(issue("startEqualsEnd", "error", { other: "Q491", value: v.Q493 }, "Q493"));
  if (v.Q492 === v.Q494) issues.push(issue("startEqualsEnd", "error", { other: "Q492", value: v.Q494 }, "Q494"));
  const outer = v.Q491 > v.Q493 ? "Q491" : "Q493";
  if (v[outer] < 0) issues.push(issue("diameterNegative", "error", { value: v[outer], nearest: -v[outer] }, outer));
  return issues;
}

function dimensionsOf(
  v: ShoulderValues,
  g: { start: Pt; corner: Pt; end: Pt; axisFoot: Pt; wallFoot: Pt },
  frame: Frame,
): Dimension[] {
  // Along the axis the contour begins in the plane of the first corner, across it on the diameter.
  const [atR1, atR2] = frame.transverse ? [g.start, g.end] : [g.end, g.start];
  const away = toPart(frame, { u: -1, v: 1 });
  const leader = (q: string, at: Pt): Dimension => ({
    q,
    form: "leader",
    at,
    towards: pt(at.z + away.z, at.r + away.r),
  });
  return [
    { q: "Q491", form: "diameter", at: atR1 },
    { q: "Q492", form: "z", from: pt(0, atR2.r), to: atR2 },
    { q: "Q493", form: "diameter", at: atR2 },
    { q: "Q494", form: "z", from: pt(0, atR1.r), to: atR1 },
    { q: "Q495", form: "angle", vertex: g.start, from: g.axisFoot, to: g.corner },
    leader("Q502", g.start),
    leader("Q500", g.corner),
    { q: "Q496", form: "angle", vertex: g.end, from: g.wallFoot, to: g.corner },
    leader("Q504", g.end),
    ...(v.Q501 > 0 ? [leader("Q501", g.start)] : []),
    ...(v.Q503 > 0 ? [leader("Q503", g.end)] : []),
  ];
}
