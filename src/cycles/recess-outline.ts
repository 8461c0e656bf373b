import type { Frame } from "../kernel/geometry/flat.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import { part, type Pt } from "../kernel/geometry/point.ts";
import { inDegrees, radians, toRadius } from "../kernel/units.ts";
import { cornerElementOf, LEG, namedContour, roundOf } from "./corner-element.ts";
import type { Dimension } from "./define.ts";
import { type BoxOutline, equalEnds, type ShoulderValues } from "./shoulder-outline.ts";
import { JOINED, ROUND } from "../kernel/tolerance.ts";

const pt = part.point;

export interface RecessOutline extends BoxOutline {
  /** Width of the opening and of the flat floor, mm across the groove; 0 when there is no contour. */
  readonly opening: number;
  readonly floor: number;
}

/**
 * Contour of an extended recess inside its box (decision "The box rule"): both walls pivot on the edges of the opening
 * and slope inwards. Cut across the axis, the opening is in the plane Q492 and the floor at Q494 (85x); otherwise the
 * opening is on the diameter Q491 and the floor on Q493 (84x).
 */
export function recessOutline(v: ShoulderValues, frame: Frame): RecessOutline {
  const axialGroove = frame.transverse;
  const issues: Issue[] = equalEnds(v);
  const [r1, r2, z1, z2] = [toRadius(v.Q491), toRadius(v.Q493), v.Q492, v.Q494];
  const none = { contour: [], frame, sunk: true, names: [], dimensions: [], angleAt, opening: 0, floor: 0 };
  if (issues.length > 0) return { ...none, issues };
  const [W, D] = axialGroove ? [Math.abs(r2 - r1), Math.abs(z2 - z1)] : [Math.abs(z2 - z1), Math.abs(r2 - r1)];
  const at = axialGroove
    ? (w: number, d: number): Pt => pt(z1 + Math.sign(z2 - z1) * d, r1 + Math.sign(r2 - r1) * w)
    : (w: number, d: number): Pt => pt(z1 + Math.sign(z2 - z1) * w, r1 + Math.sign(r2 - r1) * d);
  const [t1, t2] = [Math.tan(radians(v.Q495)), Math.tan(radians(v.Q496))];
  const [w1, w2] = [D * t1, W - D * t2];
  if (w2 - w1 < ROUND) {
    const q = t1 >= t2 ? "Q495" : "Q496";
    const room = Math.max(0, W - D * Math.min(t1, t2));
    const max = inDegrees(Math.atan2(room, D));
    return { ...none, issues: [issue("wallsMeet", "error", { angle: v[q], max }, q)] };
  }
  const legs = Math.tan(radians(45 - v.Q495 / 2)) + Math.tan(radians(45 - v.Q496 / 2));
  const widest = (w2 - w1) / legs;
  const tooWide = v.Q500 > widest + ROUND;
  if (tooWide) issues.push(issue("cornersTooWide", "error", { radius: v.Q500, max: widest }, "Q500"));
  const round = roundOf(tooWide ? 0 : v.Q500);
  // A leg towards the axis ends there: an outer element cannot be longer.
  const start = axialGroove && r1 < r2 ? Math.max(r1, JOINED) : LEG;
  const end = axialGroove && r2 < r1 ? Math.max(r2, JOINED) : LEG;
  const mouth = axialGroove ? "Q492" : "Q491";
  const built = namedContour(
    [at(-start, 0), at(0, 0), at(w1, D), at(w2, D), at(W, 0), at(W + end, 0)],
    [mouth, "Q495", axialGroove ? "Q494" : "Q493", "Q496", mouth],
    [
      { element: cornerElementOf(v.Q501, v.Q502), q: "Q502" },
      { element: round, q: "Q500" },
      { element: round, q: "Q500" },
      {
        element: cornerElementOf(v.Q503, v.Q504),
        q: "Q504",
      },
    ],
  );
  const shape = {
    a: at(0, 0),
    b: at(w1, D),
    c: at(w2, D),
    d: at(W, 0),
    footA: at(0, D),
    footD: at(W, D),
    out: (p: Pt) => beyond(p, at(W / 2, -D)),
  };
  const dimensions = dimensionsOf(v, shape, axialGroove);
  return { ...none, ...built, dimensions, issues: [...issues, ...built.issues], opening: W, floor: w2 - w1 };
}

/** Walls are upright in strategy space: their angles count from there. */
const angleAt = (_q: string, direction: number) => 90 - Math.abs(direction);

/** A point a quarter of the way from `p` to `q`, for a leader line. */
const beyond = (p: Pt, q: Pt): Pt => pt(p.z + (q.z - p.z) / 4, p.r + (q.r - p.r) / 4);

function dimensionsOf(
  v: ShoulderValues,
  g: { a: Pt; b: Pt; c: Pt; d: Pt; footA: Pt; footD: Pt; out: (p: Pt) => Pt },
  axialGroove: boolean,
): Dimension[] {
  const [atQ493, atQ494] = axialGroove ? [g.d, g.b] : [g.b, g.d];
  return [
    { q: "Q491", form: "diameter", at: g.a },
    { q: "Q492", form: "z", from: pt(0, g.a.r), to: g.a },
    {
      q: "Q493",
      form: "diameter",
      at: atQ493,
    },
    { q: "Q494", form: "z", from: pt(0, atQ494.r), to: atQ494 },
    { q: "Q495", form: "angle", vertex: g.a, from: g.footA, to: g.b },
    {
      q: "Q502",
      form: "leader",
      at: g.a,
      towards: g.out(g.a),
    },
    { q: "Q500", form: "leader", at: g.b, towards: g.out(g.b) },
    { q: "Q496", form: "angle", vertex: g.d, from: g.footD, to: g.c },
    {
      q: "Q504",
      form: "leader",
      at: g.d,
      towards: g.out(g.d),
    },
    ...(v.Q501 > 0 ? [{ q: "Q501", form: "leader", at: g.a, towards: g.out(g.a) } as const] : []),
    ...(v.Q503 > 0 ? [{ q: "Q503", form: "leader", at: g.d, towards: g.out(g.d) } as const] : []),
  ];
}
