import { ROUND } from "../../kernel/tolerance.ts";
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

function caught(value: number, step: number, magnets: readonly number[], reach: number): number {
  const grid = onGrid(value, step);
  const near = magnets.filter((m) => Math.abs(m - value) <= reach).sort((a, b) => Math.abs(a - value) - Math.abs(b - value))[0];
  return near !== undefined && Math.abs(near - value) <= Math.max(Math.abs(grid - value), reach / 2) ? near : grid;
}

/** The nearest place on the grid, or on the line of another point. X is never below the axis. */
export const snapped = (at: SnapSpot, step: number, magnets: Magnets): SnapSpot => ({
  x: Math.max(0, caught(at.x, step, magnets.x, magnets.reach.x)),
  z: caught(at.z, step, magnets.z, magnets.reach.z),
});

/** Distance of grid lines that are far enough apart to be seen: the step, or the next rounder number. */
export function gridSpacing(step: number, scale: number, pixels = 12): number {
  for (const ten of [0.001, 0.01, 0.1, 1, 10, 100, 1000])
    for (const n of [1, 2, 5]) if (n * ten >= step - ROUND && n * ten * scale >= pixels) return tidy(n * ten);
  return 5000;
}
