import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";

/** The least and the greatest value that a size allows, the drawn one included; mm, of a diameter as radii. */
export type Limits = readonly [least: number, most: number];

/**
 * What a size of a drawing measures: a diameter on its stretch of Z, a length from Z0, or a broken corner or the angle of
 * a cone with all its places. Part space, mm.
 */
export type MeasuredFeature =
  | {
      readonly kind: "diameter";
      readonly r: number;
      readonly left: number;
      readonly right: number;
      readonly limits: Limits;
    }
  | { readonly kind: "length"; readonly z: number; readonly limits: Limits }
  | { readonly kind: "corner"; readonly size: number; readonly places: readonly Pt[] }
  | { readonly kind: "angle"; readonly degrees: number; readonly places: readonly Pt[] };

/** Nearer values are one, mm. */
const ONE = 0.005;
/** A corner of a contour is the one on the drawing if its middle is this near, mm. */
const NEAR = 0.05;

export const isSameLength = (a: number, b: number): boolean => Math.abs(a - b) < ONE;

/** Whether a value makes a size: a program often has the middle of the tolerance. */
export const isWithin = ([least, most]: Limits, value: number): boolean => value > least - ONE && value < most + ONE;

const overlaps = (s: Segment, left: number, right: number): boolean =>
  Math.max(s.from.z, s.to.z) > left - ONE && Math.min(s.from.z, s.to.z) < right + ONE;

function lies(feature: MeasuredFeature, s: Segment): boolean {
  switch (feature.kind) {
    case "diameter":
      return (
        isWithin(feature.limits, s.from.r) &&
        isWithin(feature.limits, s.to.r) &&
        overlaps(s, feature.left, feature.right)
      );
    case "length":
      return isWithin(feature.limits, s.from.z) && isWithin(feature.limits, s.to.z);
    case "corner": {
      const middle = part.pointOn(s, 1 / 2);
      return feature.places.some((p) => part.apart(p, middle) < NEAR);
    }
    case "angle": {
      const slope = Math.tan((feature.degrees * Math.PI) / 180) * Math.abs(s.to.z - s.from.z);
      const isSlope = s.kind === "line" && isSameLength(Math.abs(s.to.r - s.from.r), slope);
      return isSlope && feature.places.some((p) => part.distanceTo(s, p) < NEAR);
    }
  }
}

/** Whether a size that is no element of its own measures a point: the end of a cone, a corner before it is broken. */
function isAt(feature: MeasuredFeature, p: Pt): boolean {
  switch (feature.kind) {
    case "diameter":
      return isWithin(feature.limits, p.r) && p.z > feature.left - ONE && p.z < feature.right + ONE;
    case "length":
      return isWithin(feature.limits, p.z);
    case "corner":
    case "angle":
      return false;
  }
}

/** The points where a segment ends, and where it would meet the lines beyond a broken corner. */
function endsOf(outline: readonly Segment[], i: number): readonly Pt[] {
  const s = outline[i];
  if (!s) return [];
  const sharp = [outline[i - 2], outline[i + 2]].flatMap((other) =>
    other?.kind === "line" && s.kind === "line" ? part.meetings(s, other) : [],
  );
  return [s.from, s.to, ...sharp];
}

/** Indexes of the segments of an outline that a size measures; those that only end there where none lies on it. */
export function measuredSegments(feature: MeasuredFeature, outline: readonly Segment[]): readonly number[] {
  const all = outline.map((_, i) => i);
  const whole = all.filter((i) => outline[i] && lies(feature, outline[i]));
  return whole.length > 0 ? whole : all.filter((i) => endsOf(outline, i).some((p) => isAt(feature, p)));
}
