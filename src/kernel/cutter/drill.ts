import { centreProfile } from "./centre-drill.ts";
import { METRIC } from "../contour/metric-thread.ts";
import type { Convex } from "../reach/convex.ts";
import type { Flat } from "../geometry/flat.ts";
import { DRILL_TYPES, type Tool } from "../plan/tool.ts";
import { degrees, inDegrees, length, radians, type Degrees } from "../units.ts";
import type { NeededHole } from "../time/step.ts";

/** Length of a drill whose LCUTS is empty, mm. */
const LONG = 100;
/** A point angle from which on a drill is flat, degrees. */
const FLAT = 180;

export const isDrill = (t: Tool): boolean => DRILL_TYPES.some((type) => type === t.TYPE);

/** Length of the point of a drill up to its full radius, mm: 0 if the point is flat or its angle unknown. */
export function pointLength(t: Tool): number {
  const angle = t["T-ANGLE"] ?? FLAT;
  return angle > 0 && angle < FLAT ? (t.R ?? 0) / Math.tan(radians(angle) / 2) : 0;
}

/** Point angle of a drill by its radius and the length of its point, mm. */
export const pointAngleOf = (radius: number, point: number): Degrees =>
  degrees(2 * inDegrees(Math.atan2(radius, point)));

/** Depth of the point at which the bore has this radius, mm; null if the angle makes no point. */
export function depthAtRadius(t: Tool, radius: number): number | null {
  const angle = t["T-ANGLE"] ?? 0;
  return angle > 0 && angle < FLAT ? radius / Math.tan(radians(angle) / 2) : null;
}

/** A core may be this much narrower, mm: the tolerance of the pilot drill. */
const NARROWER = 0.05;
/** Least radius of a core as a share of the tap's radius, also for a tap without a pitch. */
const NARROWEST = 0.5;
/** Reduction of the radius for the drilled hole, in pitches. */
const HALF_PITCH = 0.5;

/** The hole that a tap needs, by its pitch (mm; by default the tool's pitch); null for any other tool. */
export function holeOf(t: Tool, pitch: number = t.PITCH ?? 0): NeededHole | null {
  if (t.TYPE !== "TAP" && pitch === 0) return null;
  const r = t.R ?? 0;
  const narrowest = NARROWEST * r;
  const least = pitch > 0 ? Math.max(narrowest, r - METRIC.inside * pitch - NARROWER) : narrowest;
  // The trade drills the nominal diameter less the pitch.
  return { radius: length(least), drill: length(pitch > 0 ? Math.max(least, r - HALF_PITCH * pitch) : least) };
}

/** End of a drill above its point, mm. */
const endOf = (t: Tool, shoulder: number) => shoulder + Math.max(t.CUTLENGTH ?? LONG, t.R ?? 0);

/** Length from the point that can be inside a hole before what holds the drill is, mm; 0 if it is not known. */
export const insertedLength = (t: Tool): number =>
  t.centre ? (centreProfile(t.centre, t.R ?? 0).at(-1)?.u ?? 0) : (t.CUTLENGTH ?? 0);

/** Half outline from the point to the full radius: distance from the point, and radius. */
function profileOf(t: Tool): readonly Flat[] {
  const r = t.R ?? 0;
  if (t.centre) return centreProfile(t.centre, r);
  const point = pointLength(t);
  return [...(point > 0 ? [{ u: 0, v: 0 }] : []), { u: point, v: r }];
}

/** A drill on the axis, relative to its point, in side view: it points to -Z and lies on both sides of the axis. */
export function drillShape(t: Tool): Convex {
  const profile = profileOf(t);
  const shoulder = profile[profile.length - 1] ?? { u: 0, v: 0 };
  const end = endOf(t, shoulder.u);
  const across = profile.filter(({ v }) => v > 0);
  const corners: Flat[] = [
    ...across.map(({ u, v }) => ({ u, v: -v })),
    { u: end, v: -shoulder.v },
    { u: end, v: shoulder.v },
    ...across.toReversed(),
  ];
  if (profile[0]?.v === 0) corners.push({ u: 0, v: 0 });
  const features = [
    ...across.map(() => "secondaryEdge" as const),
    "back" as const,
    ...across.map(() => "mainEdge" as const),
  ];
  return corners.map((from, i) => ({
    kind: "line",
    from,
    to: corners[(i + 1) % corners.length] as Flat,
    feature: features[i] ?? "nose",
  }));
}

/** A centre drill as convex parts, whose union is its shape; null for any other tool. */
export function centreParts(t: Tool): readonly (readonly Flat[])[] | null {
  if (!t.centre) return null;
  const profile = centreProfile(t.centre, t.R ?? 0);
  const end = endOf(t, profile[profile.length - 1]?.u ?? 0);
  // Each part runs on to the end: a cone has the cylinder above it.
  return profile.slice(1).map((to, i) => {
    const from = profile[i] as Flat;
    const half = [from, to, { u: end, v: to.v }];
    return [...half.map(({ u, v }) => ({ u, v: -v })), ...half.toReversed()].filter(
      (p, k, all) => Math.hypot(p.u - (all[k - 1]?.u ?? Infinity), p.v - (all[k - 1]?.v ?? 0)) > 0,
    );
  });
}
