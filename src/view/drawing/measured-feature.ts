import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";

/**
 * What a size of a drawing measures: a diameter on its stretch of Z, a length from Z0, or a broken corner with all its
 * places. Part space, mm.
 */
export type MeasuredFeature =
  | { readonly kind: "diameter"; readonly r: number; readonly left: number; readonly right: number }
  | { readonly kind: "length"; readonly z: number }
  | { readonly kind: "corner"; readonly size: number; readonly places: readonly Pt[] };

/** Nearer values are one, mm. */
const ONE = 0.005;
/** A corner of a contour is the one on the drawing if its middle is this near, mm. */
const NEAR = 0.05;

export const isSameLength = (a: number, b: number): boolean => Math.abs(a - b) < ONE;

const overlaps = (s: Segment, left: number, right: number): boolean =>
  Math.max(s.from.z, s.to.z) > left - ONE && Math.min(s.from.z, s.to.z) < right + ONE;

/** Whether a segment ends at a place that a size measures. */
const ends = (s: Segment, at: (p: Pt) => boolean): boolean => at(s.from) || at(s.to);

function lies(feature: MeasuredFeature, s: Segment): boolean {
  switch (feature.kind) {
    case "diameter":
      return (
        isSameLength(s.from.r, feature.r) && isSameLength(s.to.r, feature.r) && overlaps(s, feature.left, feature.right)
      );
    case "length":
      return isSameLength(s.from.z, feature.z) && isSameLength(s.to.z, feature.z);
    case "corner": {
      const middle = part.pointOn(s, 1 / 2);
      return feature.places.some((p) => part.apart(p, middle) < NEAR);
    }
  }
}

/** Whether a segment without an element of its own ends where a size measures: a cone, an outline that runs out. */
function touches(feature: MeasuredFeature, s: Segment): boolean {
  if (feature.kind === "corner") return false;
  if (feature.kind === "length") return ends(s, (p) => isSameLength(p.z, feature.z));
  return overlaps(s, feature.left, feature.right) && ends(s, (p) => isSameLength(p.r, feature.r));
}

/** Indexes of the segments of an outline that a size measures; those that only end there where none lies on it. */
export function measuredSegments(feature: MeasuredFeature, outline: readonly Segment[]): readonly number[] {
  const on = (holds: (feature: MeasuredFeature, s: Segment) => boolean) =>
    outline.flatMap((s, i) => (holds(feature, s) ? [i] : []));
  const whole = on(lies);
  return whole.length > 0 ? whole : on(touches);
}
