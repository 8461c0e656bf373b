import type { Pt } from "../../kernel/geometry/point.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import { diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";

/** A place in the measure of the table: X as diameter, mm. */
export interface SnapSpot {
  readonly x: number;
  readonly z: number;
}

/** Grid steps to choose from, mm; X on the diameter. The last is as fine as a control keeps. */
export const GRID_STEPS = [10, 5, 1, 0.5, 0.1, 0.001] as const;
export type GridStep = (typeof GRID_STEPS)[number];

const tidy = (n: number) => Number(n.toFixed(3)) || 0;
export const onGrid = (value: number, step: number): number => tidy(Math.round(value / step) * step);

/** Lines that catch a point that comes near them: coordinates of other points. */
export interface Magnets {
  readonly x: readonly number[];
  readonly z: readonly number[];
  /** How near, in the measure of each axis. */
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

/** A way on which a point may run: from where the element begins, in the direction in which the one before it ends. */
export interface Ray {
  readonly from: Pt;
  readonly along: Pt;
}

/** Where a point comes to lie, and what caught it there. */
export interface Aim {
  readonly spot: SnapSpot;
  /** It lies on the X, or on the Z, of another point. */
  readonly onX: boolean;
  readonly onZ: boolean;
  /** It lies where its element goes on tangentially. */
  readonly ray: Ray | null;
}

/**
 * The nearest place on the grid, on the line of another point, or on the tangent of the element before. X is never
 * below the axis.
 */
export function aimed(at: SnapSpot, step: number, magnets: Magnets, ray: Ray | null = null): Aim {
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
export const snapped = (at: SnapSpot, step: number, magnets: Magnets): SnapSpot => aimed(at, step, magnets).spot;

/** Distance of grid lines that are far enough apart to be seen: the step, or the next rounder number. */
export function gridSpacing(step: number, scale: number, pixels = 12): number {
  for (const ten of [0.001, 0.01, 0.1, 1, 10, 100, 1000])
    for (const n of [1, 2, 5]) if (n * ten >= step - ROUND && n * ten * scale >= pixels) return tidy(n * ten);
  return 5000;
}
