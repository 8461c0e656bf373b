import type { Convex } from "./convex.ts";
import type { Flat } from "./flat.ts";
import { DRILL_TYPES, type Tool } from "./tool.ts";
import { radians } from "./units.ts";

/** Length of a drill whose LCUTS is empty, mm. */
const LONG = 100;
/** A point angle from which on a drill is flat, degrees. */
const FLAT = 180;

export const isDrill = (t: Tool): boolean => DRILL_TYPES.some((type) => type === t.TYPE);

/** From the point of a drill to where it has its full radius, mm: nothing where its point is flat, or its angle unknown. */
export function pointLength(t: Tool): number {
  const angle = t["T-ANGLE"] ?? FLAT;
  return angle > 0 && angle < FLAT ? (t.R ?? 0) / Math.tan(radians(angle) / 2) : 0;
}

/** How deep a point of an angle is driven where the bore has a radius, mm; null where the angle makes no point. */
export function depthAtRadius(t: Tool, radius: number): number | null {
  const angle = t["T-ANGLE"] ?? 0;
  return angle > 0 && angle < FLAT ? radius / Math.tan(radians(angle) / 2) : null;
}

/** A drill on the axis, relative to its point, seen from the side: it points to -Z and lies on both sides of the axis. */
export function drillShape(t: Tool): Convex {
  const [r, point] = [t.R ?? 0, pointLength(t)];
  const end = point + Math.max(t.CUTLENGTH ?? LONG, r);
  const corners: Flat[] = [{ u: point, v: -r }, { u: end, v: -r }, { u: end, v: r }, { u: point, v: r }];
  if (point > 0) corners.push({ u: 0, v: 0 });
  const features = ["secondaryEdge", "back", "mainEdge", "nose", "nose"] as const;
  return corners.map((from, i) => ({
    kind: "line",
    from,
    to: corners[(i + 1) % corners.length] as Flat,
    feature: features[i] ?? "nose",
  }));
}
