import { areaOf } from "./area.ts";
import { difference, opened } from "./clip.ts";
import type { Ring } from "../geometry/point.ts";
import { SLIVER } from "../tolerance.ts";

/** Smaller areas are chord and grid errors of two curves that touch, mm². */
export const REAL_AREA = 0.01;

/** An area without slivers; nothing when that is too small to be true. */
export const real = (area: Ring[]): Ring[] => {
  if (areaOf(area) < REAL_AREA) return [];
  const thick = opened(area, SLIVER);
  return areaOf(thick) < REAL_AREA ? [] : thick;
};

/** How much of an area lies outside another one, mm²; 0 where the two only differ by chords and grid. */
export const areaOutside = (area: readonly Ring[], other: readonly Ring[]): number =>
  areaOf(real(difference(area, other)));
