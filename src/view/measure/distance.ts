import type { Kind } from "../../cycles/params.ts";
import type { MeasuredKind } from "../../kernel/plan/measured.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import {
  axial,
  type Diameter,
  radius,
  rounded,
  roundedAngle,
  roundedInch,
  toDiameter,
  toRadius,
} from "../../kernel/units.ts";

/** The distance between two places. */
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

/**
 * The reading of a ruler for a kind of value: a place for positions, the distance between two places for sizes; null
 * for other kinds.
 */
export function rulerValueFor(kind: Kind, place: Pt | null, between: Distance | null): number | null {
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

/** Kinds of measurement that fit a size without a place. */
const TAKES: Partial<Record<Kind, readonly MeasuredKind[]>> = {
  diameter: ["diameter"],
  radial: ["depth"],
  length: ["length", "depth", "distance", "radius", "wall"],
};

/** A finished measurement as a value of a kind, mm or degrees; null if it does not fit. */
export function fieldValueOf(kind: Kind, measured: MeasuredKind, value: number): number | null {
  if (kind === "angle") return measured === "angle" ? roundedAngle(value) : null;
  const fits: readonly MeasuredKind[] = TAKES[kind] ?? [];
  return fits.includes(measured) ? rounded(value) : null;
}

/** How a block counts: in units of `unit` mm, from a datum at `zero` on the workpiece. */
export interface BlockUnits {
  readonly unit: number;
  readonly zero: Pt;
}

/**
 * A value of a kind, mm or degrees and from the workpiece zero, in the units of a block, on the grid of the control.
 */
export function inBlockUnits(kind: Kind, value: number, { unit, zero }: BlockUnits): number {
  if (kind === "angle") return value;
  const from = kind === "diameter" ? toDiameter(zero.r) : kind === "axial" ? zero.z : 0;
  return unit === 1 ? rounded(value - from) : roundedInch((value - from) / unit);
}

/** A place moved by so much of Z and r, mm, on whole thousandths. */
export const nudged = (p: Pt, dz: number, dr: number): Pt => ({
  z: axial(rounded(p.z + dz)),
  r: radius(rounded(p.r + dr)),
});
