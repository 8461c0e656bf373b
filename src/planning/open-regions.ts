import { boxOf } from "../kernel/area/box.ts";
import { difference, insideOf, offset, opened } from "../kernel/area/clip.ts";
import { part, type Ring, type Segment } from "../kernel/geometry/point.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { regionsOf } from "../sim/region.ts";
import type { Chain, PlannedPart } from "./types.ts";

/** Smaller pieces are no work, mm² of the half plane. */
export const LEAST_REGION = 0.05;

/** A connected piece of material to remove. */
export interface OpenRegion {
  readonly rings: readonly Ring[];
  readonly box: Box;
  /** mm² of the half plane. */
  readonly area: number;
}

/** Area of the connected pieces that are work, mm². */
export const workIn = (open: readonly Ring[]): number =>
  regionsOf(open, LEAST_REGION).reduce((sum, { area }) => sum + area, 0);

/** Material that is not part of the finished part, in connected pieces, the largest first. */
export function openRegions(stock: readonly Ring[], { rings }: PlannedPart): readonly OpenRegion[] {
  return regionsOf(opened(difference(stock, rings), SLIVER), LEAST_REGION)
    .map(({ outline, holes, area }) => ({ rings: [outline, ...holes], box: boxOf(outline), area }))
    .toSorted((a, b) => b.area - a.area);
}

/** Distance of the points at which an element is compared with a region, mm. */
const STEP = 0.5;

/** Elements of a chain that border a region: the indices of the first and the last one; null where none does. */
export function borderOf({ segments }: Chain, { rings }: OpenRegion): readonly [first: number, last: number] | null {
  const isNear = insideOf(offset(rings, 2 * SLIVER));
  const borders = (s: Segment) => {
    const count = Math.ceil(part.lengthOf(s) / STEP);
    return Array.from({ length: count }, (_, i) => part.pointOn(s, (i + 0.5) / count)).some(isNear);
  };
  const hit = segments.flatMap((s, i) => (borders(s) ? [i] : []));
  const [first, last] = [hit[0], hit.at(-1)];
  return first === undefined || last === undefined ? null : [first, last];
}
