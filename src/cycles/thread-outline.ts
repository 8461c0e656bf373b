import type { Frame } from "../kernel/geometry/flat.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import { part, type Pt } from "../kernel/geometry/point.ts";
import { METRIC } from "../kernel/contour/metric-thread.ts";
import { ROUND } from "../kernel/tolerance.ts";
import {
  axial,
  radians,
  radius,
  toRadius,
  type Axial,
  type Degrees,
  type Diameter,
  type Length,
} from "../kernel/units.ts";
import type { Dimension, Outline } from "./define.ts";

/** The values of every thread cycle that its picture shows. */
export interface ThreadValues {
  readonly Q471: number;
  readonly Q472: Length;
  readonly Q473: Length;
  readonly Q474: Length;
  readonly Q467: Degrees;
  readonly Q475: number;
}

/** Degrees. */
const SQUARE = 90;

/** Ways to dimension a taper (Q464). */
export const TAPER = { points: 0, endStartX: 1, endStartZ: 2, startEndX: 3, startEndZ: 4 } as const;

export interface TaperValues {
  readonly Q464: number;
  readonly Q491: Diameter;
  readonly Q492: Axial;
  readonly Q493: Diameter;
  readonly Q494: Axial;
  readonly Q469: Degrees;
}

const pt = part.point;

/** Issues of the ends of a straight thread. */
function endIssues(
  from: Pt,
  to: Pt,
  transverse: boolean,
  given: { Q491: Diameter; Q493?: Diameter; Q492: Axial; Q494: Axial },
): Issue[] {
  const issues: Issue[] = [];
  for (const q of ["Q491", "Q493"] as const) {
    const value = given[q];
    if (value !== undefined && value < 0)
      issues.push(issue("diameterNegative", "error", { value, nearest: -value }, q));
  }
  if (transverse && Math.abs(from.r - to.r) < ROUND && given.Q493 !== undefined)
    issues.push(issue("startEqualsEnd", "error", { other: "Q491", value: given.Q493 }, "Q493"));
  if (!transverse && Math.abs(from.z - to.z) < ROUND)
    issues.push(issue("startEqualsEnd", "error", { other: "Q492", value: given.Q494 }, "Q494"));
  return issues;
}

/** Orientation of strategy space: along the thread, and out of the material. */
export const threadFrame = (from: Pt, to: Pt, transverse: boolean, inside: boolean): Frame =>
  transverse
    ? { transverse, signU: to.r < from.r ? -1 : 1, signV: 1 }
    : { transverse, signU: to.z > from.z ? 1 : -1, signV: inside ? -1 : 1 };

/** Depth of the thread as entered, or that of the metric profile. */
export const depthOf = (v: ThreadValues): number =>
  v.Q473 > 0 ? v.Q473 : (v.Q472 / Math.max(1, v.Q475)) * (v.Q471 === 1 ? METRIC.inside : METRIC.outside);

/** A thread on a straight line between two points, with the dimensions of all thread cycles. */
export function straightThread(
  v: ThreadValues & { readonly Q465?: Length; readonly Q466?: Length },
  given: { Q491: Diameter; Q493?: Diameter; Q492: Axial; Q494: Axial },
  [from, to]: readonly [Pt, Pt],
  transverse: boolean,
  own: readonly Dimension[],
): Outline {
  const frame = threadFrame(from, to, transverse, v.Q471 === 1);
  const issues = endIssues(from, to, transverse, given);
  const none = { contour: [], frame, sunk: false, dimensions: [], issues };
  if (issues.length > 0) return none;
  return {
    ...none,
    contour: [{ kind: "line", from, to }],
    dimensions: [...own, ...threadDimensions(v, from, to, frame)],
  };
}

/** Dimensions on the line of a thread in any cycle: run-in, run-out, pitch, depth and the direction of infeed. */
export function threadDimensions(
  v: ThreadValues & { readonly Q465?: Length; readonly Q466?: Length },
  from: Pt,
  to: Pt,
  frame: Frame,
): Dimension[] {
  const size = part.apart(from, to);
  const on = (way: number): Pt => pt(from.z + ((to.z - from.z) * way) / size, from.r + ((to.r - from.r) * way) / size);
  // An inside thread is also drawn by its nominal line: its depth is above that line.
  const sign = (v.Q471 === 1 ? 1 : -1) * frame.signV;
  const off = (p: Pt, by: number): Pt => (frame.transverse ? pt(p.z + sign * by, p.r) : pt(p.z, p.r + sign * by));
  const form = frame.transverse ? "r" : "z";
  const middle = on(size / 2);
  const root = off(middle, v.Q471 === 1 ? 0 : depthOf(v));
  const arm = size / 4;
  const tilt = radians(v.Q467);
  const lean: Pt = frame.transverse
    ? pt(root.z + frame.signV * arm * Math.cos(tilt), root.r - frame.signU * arm * Math.sin(tilt))
    : pt(root.z - frame.signU * arm * Math.sin(tilt), root.r + frame.signV * arm * Math.cos(tilt));
  const upright: Pt = frame.transverse
    ? pt(root.z + frame.signV * arm, root.r)
    : pt(root.z, root.r + frame.signV * arm);
  return [
    { q: "Q472", form, from: on(size * 0.3), to: on(size * 0.3 + Math.min(v.Q472, size * 0.6)) },
    { q: "Q473", form: frame.transverse ? "z" : "r", from: middle, to: off(middle, depthOf(v)) },
    { q: "Q474", form, from: on(Math.max(0, size - v.Q474)), to },
    { q: "Q467", form: "angle", vertex: root, from: upright, to: lean },
    ...(v.Q465 === undefined ? [] : [{ q: "Q465", form, from: on(-v.Q465), to: from } as const]),
    ...(v.Q466 === undefined ? [] : [{ q: "Q466", form, from: to, to: on(size + v.Q466) } as const]),
  ];
}

/**
 * Start and end of a taper, from whichever coordinates are given. The angle opens from a line along the axis in the
 * cutting direction, positive where the diameter grows. A missing Z is on the side of the cycle's start point.
 */
export function taperEnds(
  v: TaperValues,
  start: Pt | null,
): { readonly from: Pt; readonly to: Pt; readonly issues: readonly Issue[] } {
  const [r1, r2] = [toRadius(v.Q491), toRadius(v.Q493)];
  const [from, to] = [pt(v.Q492, r1), pt(v.Q494, r2)];
  // Square to the axis or beyond, a line never advances along it.
  if (v.Q464 !== TAPER.points && Math.abs(v.Q469) >= SQUARE)
    return { from, to, issues: [issue("taperImpossible", "error", { angle: v.Q469 }, "Q469")] };
  const slope = Math.tan(radians(v.Q469));
  const found = (a: Pt, b: Pt) => ({
    from: a,
    to: b,
    issues:
      v.Q464 !== TAPER.points && Math.min(a.r, b.r) < 0
        ? [issue("taperImpossible", "error", { angle: v.Q469 }, "Q469")]
        : [],
  });
  const long = Math.abs(slope) < ROUND ? NaN : (r2 - r1) / slope;
  switch (v.Q464) {
    case TAPER.endStartZ:
      return found(pt(v.Q492, radius(r2 - slope * Math.abs(v.Q494 - v.Q492))), to);
    case TAPER.startEndZ:
      return found(from, pt(v.Q494, radius(r1 + slope * Math.abs(v.Q494 - v.Q492))));
    case TAPER.endStartX:
    case TAPER.startEndX: {
      if (!(long > ROUND)) return { from, to, issues: [issue("taperImpossible", "error", { angle: v.Q469 }, "Q469")] };
      const known = v.Q464 === TAPER.endStartX ? v.Q494 : v.Q492;
      const isFromLeft = start !== null && start.z < known - ROUND;
      const way = isFromLeft ? 1 : -1;
      return v.Q464 === TAPER.endStartX
        ? found(pt(axial(v.Q494 - way * long), r1), to)
        : found(from, pt(axial(v.Q492 + way * long), r2));
    }
    default:
      return found(from, to);
  }
}
