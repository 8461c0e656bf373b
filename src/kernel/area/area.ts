import type { Ring } from "../geometry/point.ts";

/** Signed area of one ring, mm²: positive counter-clockwise. */
export function areaOfRing(ring: Ring): number {
  let sum = 0;
  let last = ring[ring.length - 1];
  for (const p of ring) {
    if (last) sum += last.z * p.r - p.z * last.r;
    last = p;
  }
  return sum / 2;
}

/** Area of rings that do not overlap, mm²; holes count negative. */
export const areaOf = (area: readonly Ring[]): number => area.reduce((sum, ring) => sum + areaOfRing(ring), 0);
