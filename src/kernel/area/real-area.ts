import { areaOf } from "./area.ts";
import { difference, opened } from "./clip.ts";
import type { Ring } from "../geometry/point.ts";
import { SLIVER } from "../tolerance.ts";

/** Smaller areas are chord and grid errors of two curves that touch, mm². */
export const REAL_AREA = 0.01;

/** An area without slivers; empty when the rest is smaller than REAL_AREA. */
export const withoutSlivers = (area: Ring[]): Ring[] => {
  if (areaOf(area) < REAL_AREA) return [];
  const thick = opened(area, SLIVER);
  return areaOf(thick) < REAL_AREA ? [] : thick;
};

/** The area outside another area, mm²; 0 where the two only differ by chords and grid. */
export const areaOutside = (area: readonly Ring[], other: readonly Ring[]): number =>
  areaOf(withoutSlivers(difference(area, other)));
