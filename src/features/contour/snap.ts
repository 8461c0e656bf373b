import type { Pt } from "../../kernel/geometry/point.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import { diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";

/** A place in the coordinates of the table: X as diameter, mm. */
export interface SnapSpot {
  readonly x: number;
  readonly z: number;
}

/** Grid steps to choose from, mm; X on the diameter. The last one is the resolution of the control. */
export const GRID_STEPS = [10, 5, 1, 0.5, 0.1, 0.001] as const;
export type GridStep = (typeof GRID_STEPS)[number];

const tidy = (n: number) => Number(n.toFixed(3)) || 0;
export const onGrid = (value: number, step: number): number => tidy(Math.round(value / step) * step);

/** Coordinates of other points, which catch a point that comes near. */
export interface Magnets {
  readonly x: readonly number[];
  readonly z: readonly number[];
  /** Snap distance, in the measure of each axis. */
  readonly reach: SnapSpot;
}

/** A coordinate on the grid or on the line of another point. */
interface Caught {
  readonly value: number;
  /** It lies on the line of another point. */
  readonly held: boolean;
}

function caught(value: number, step: number, magnets: readonly number[], reach: number): Caught {
  const grid = onGrid(value, step);
  const near = magnets
    .filter((m) => Math.abs(m - value) <= reach)
    .sort((a, b) => Math.abs(a - value) - Math.abs(b - value))[0];
  return near !== undefined && Math.abs(near - value) <= Math.max(Math.abs(grid - value), reach / 2)
    ? { value: near, held: true }
    : { value: grid, held: magnets.includes(grid) };
}

/** The tangential continuation: start of the element, and end direction of the previous one. */
export interface Ray {
  readonly from: Pt;
  readonly along: Pt;
}

/** The snapped place, and what caught it. */
export interface Aim {
  readonly spot: SnapSpot;
  /** On the X, or on the Z, of another point. */
  readonly onX: boolean;
  readonly onZ: boolean;
  /** On the tangent of the previous element. */
  readonly ray: Ray | null;
}

/**
 * The nearest place on the grid, on the line of another point, or on the tangent of the previous element. X is never
 * below the axis.
 */
export function snapPoint(at: SnapSpot, step: number, magnets: Magnets, ray: Ray | null = null): Aim {
  const x = caught(at.x, step, magnets.x, magnets.reach.x),
    z = caught(at.z, step, magnets.z, magnets.reach.z);
  const free: Aim = { spot: { x: Math.max(0, x.value), z: z.value }, onX: x.held, onZ: z.held, ray: null };
  if (!ray || (x.held && z.held)) return free;
  const { from, along } = ray,
    to = { z: at.z, r: toRadius(diameter(at.x)) };
  const far = (to.z - from.z) * along.z + (to.r - from.r) * along.r;
  const beside = Math.abs((to.z - from.z) * along.r - (to.r - from.r) * along.z);
  if (!(far > magnets.reach.z) || beside > magnets.reach.z) return free;
  const spot = { x: tidy(toDiameter(radius(from.r + far * along.r))), z: tidy(from.z + far * along.z) };
  return spot.x < 0 ? free : { spot, onX: false, onZ: false, ray };
}

/** The nearest place on the grid, or on the line of another point. */
export const snapped = (at: SnapSpot, step: number, magnets: Magnets): SnapSpot => snapPoint(at, step, magnets).spot;

/** Distance of grid lines that are far enough apart to be seen: the step, or the next rounder number. */
export function gridSpacing(step: number, scale: number, pixels = 12): number {
  for (const ten of [0.001, 0.01, 0.1, 1, 10, 100, 1000])
    for (const n of [1, 2, 5]) if (n * ten >= step - ROUND && n * ten * scale >= pixels) return tidy(n * ten);
  return 5000;
}
