import type { Kind } from "../cycles/params.ts";
import type { Pt, Segment } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { axial, type Diameter, radius, rounded, toDiameter, toRadius } from "../kernel/units.ts";

/** What lies between two places. */
export interface Distance {
  /** Difference of X as a diameter, mm, with its sign. */
  readonly dx: Diameter;
  /** Difference of Z, mm, with its sign. */
  readonly dz: number;
  /** Straight distance in the half plane, mm. */
  readonly distance: number;
}

/** Measures from one place to another. */
export const measure = (from: Pt, to: Pt): Distance => ({
  dx: toDiameter(radius(to.r - from.r)),
  dz: to.z - from.z,
  distance: Math.hypot(to.z - from.z, to.r - from.r),
});

/** What a ruler reads for a value of a kind: a place for positions, the way between two places for sizes; null where it reads none. */
export function measuredFor(kind: Kind, place: Pt | null, between: Distance | null): number | null {
  switch (kind) {
    case "diameter":
      return place && rounded(toDiameter(place.r));
    case "axial":
      return place && rounded(place.z);
    case "axialDepth":
      return between && rounded(between.dz);
    case "radial":
      return between && rounded(Math.abs(toRadius(between.dx)));
    case "oversizeDiameter":
      return between && rounded(Math.abs(between.dx));
    case "length":
      return between && rounded(between.distance);
    default:
      return null;
  }
}

/** The places a ruler snaps to, in the order in which Tab would walk them: contour corners first, then ends of moves. */
export function snapPoints(contours: readonly (readonly Segment[])[], steps: readonly Step[]): readonly Pt[] {
  const seen = new Set<string>(), points: Pt[] = [];
  const add = (p: Pt) => {
    const key = `${Math.round(p.z * 1e3)},${Math.round(p.r * 1e3)}`;
    if (seen.has(key)) return;
    seen.add(key);
    points.push(p);
  };
  for (const contour of contours) {
    for (const s of contour) {
      add(s.from);
      add(s.to);
      if (s.kind === "arc") add(s.centre);
    }
  }
  for (const { from, move } of steps) {
    add(from);
    add(move.to);
  }
  return points;
}

/** The nearest snap point within `reach` mm, else the place itself. */
export function snappedPoint(place: Pt, points: readonly Pt[], reach: number): Pt {
  let best = place, near = reach;
  for (const p of points) {
    const away = Math.hypot(p.z - place.z, p.r - place.r);
    if (away < near) {
      near = away;
      best = p;
    }
  }
  return best;
}

/** A place moved by so much of Z and r, mm, on whole thousandths. */
export const nudged = (p: Pt, dz: number, dr: number): Pt => ({
  z: axial(rounded(p.z + dz)),
  r: radius(rounded(p.r + dr)),
});
