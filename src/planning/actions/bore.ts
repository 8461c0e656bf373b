import { boxAround, inBox } from "../../kernel/area/box.ts";
import { intersection, opened } from "../../kernel/area/clip.ts";
import { at, part as geometry, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD, SLIVER } from "../../kernel/tolerance.ts";
import { regionsOf } from "../../sim/region.ts";
import { thickestOf } from "../apply-action.ts";
import { LEAST_REGION, type OpenRegion } from "../open-regions.ts";
import type { PlannedPart, PlanRequest } from "../types.ts";
import { withoutEdge } from "./front.ts";

/** Farther than any part, mm. */
export const FAR = 10_000;

/** The inside of a part: from its contour to the axis, between its front and its rear end. Null for a solid part. */
export function insideOf({ inside }: PlannedPart): Ring | null {
  const points = geometry.flattenedChain(inside.segments, CHORD);
  const [first, last] = [points[0], points.at(-1)];
  return first && last ? [...points, at(last.z, 0), at(first.z, 0)] : null;
}

/** Material inside, in connected pieces that are thicker than `thick` mm, the largest first. */
export function insideRegions(stock: readonly Ring[], part: PlannedPart, thick = 0): readonly OpenRegion[] {
  const inside = insideOf(part);
  if (!inside) return [];
  return regionsOf(opened(intersection(stock, [inside]), Math.max(thick, SLIVER)), LEAST_REGION)
    .map(({ outline, holes, area }) => ({ rings: [outline, ...holes], box: boxAround([outline]), area }))
    .toSorted((a, b) => b.area - a.area);
}

/** The same, more than the edge at the front of the bore: finishing takes that, as far as it can with what lies before it. */
export function thickRegions(
  stock: readonly Ring[],
  request: Pick<PlanRequest, "part" | "rules">,
  thick: number,
): readonly OpenRegion[] {
  const { part } = request;
  const all = insideRegions(stock, part, thick);
  const segments = withoutEdge(part.inside.segments, "inside");
  if (!segments) return all;
  const plain = { ...part, inside: { ...part.inside, segments } };
  const most = thickestOf(request) + SLIVER;
  return all.filter(
    ({ rings }) => insideRegions(rings, plain, thick).length > 0 || insideRegions(rings, part, most).length > 0,
  );
}

/** Radius within which a stock has no material between two Z; Infinity where there is none at all. */
export function clearRadius(stock: readonly Ring[], left: number, right: number): number {
  let low = Infinity;
  for (const ring of stock)
    ring.forEach((b, i) => {
      const a = ring.at(i - 1) ?? b;
      const [rear, front] = a.z < b.z ? [a, b] : [b, a];
      if (front.z <= left || rear.z >= right) return;
      const at = (z: number) => rear.r + ((front.r - rear.r) * (z - rear.z)) / (front.z - rear.z);
      low = Math.min(low, rear.z < left ? at(left) : rear.r, front.z > right ? at(right) : front.r);
    });
  return low;
}

/** The Z from which on a stock has material within a radius; −Infinity without any. */
export function solidFrom(stock: readonly Ring[], r: number): number {
  const core = inBox(stock, { left: -FAR, right: FAR, low: -1, high: r });
  return core.length === 0 ? -Infinity : boxAround(core).right;
}

/** Material this near to the axis stands on it, mm. */
const ON_AXIS = 0.001;

/** The Z from which on a stock is solid on its axis; −Infinity where it has a bore from end to end. */
export const boredTo = (stock: readonly Ring[]): number => solidFrom(stock, ON_AXIS);
