import { areaOfRing } from "../kernel/area/area.ts";
import { isInside } from "../kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../kernel/geometry/point.ts";

/** One connected piece of an area: its outline, its holes, and its area in mm². */
export interface Region {
  readonly outline: Ring;
  readonly holes: readonly Ring[];
  readonly area: number;
}

/** The connected pieces of an area that are larger than `least` mm². */
export function regionsOf(area: readonly Ring[], least: number): Region[] {
  const holes = area.filter((ring) => areaOfRing(ring) < 0);
  return area
    .filter((ring) => areaOfRing(ring) > 0)
    .map((outline) => {
      const own = holes.filter((h) => h[0] && isInside(outline, h[0]));
      return { outline, holes: own, area: [outline, ...own].reduce((sum, ring) => sum + areaOfRing(ring), 0) };
    })
    .filter((region) => region.area > least);
}

/** A point inside a ring: the middle of its widest crossing at half its height. */
export function placeIn(ring: Ring): Pt {
  const heights = ring.map((p) => p.r);
  const r = (Math.min(...heights) + Math.max(...heights)) / 2;
  const crossings: number[] = [];
  let a = ring[ring.length - 1];
  for (const b of ring) {
    if (a && a.r <= r !== b.r <= r) crossings.push(a.z + ((b.z - a.z) * (r - a.r)) / (b.r - a.r));
    a = b;
  }
  crossings.sort((p, q) => p - q);
  let [best, width] = [ring[0]?.z ?? 0, -1];
  for (let i = 0; i + 1 < crossings.length; i += 2) {
    const [from, to] = [crossings[i] as number, crossings[i + 1] as number];
    if (to - from > width) [best, width] = [(from + to) / 2, to - from];
  }
  return at(best, ring.length > 0 ? r : 0);
}

/** The largest ring, for the place of a finding. */
export const largest = (rings: readonly Ring[]): Ring =>
  rings.reduce<Ring>((best, ring) => (areaOfRing(ring) > areaOfRing(best) ? ring : best), rings[0] ?? []);
