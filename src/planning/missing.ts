import type { Site } from "../cycles/shape-request.ts";
import { boxAround, boxOf } from "../kernel/area/box.ts";
import { part, type Segment } from "../kernel/geometry/point.ts";
import { CHORD, SAME } from "../kernel/tolerance.ts";
import { inDegrees, toDiameter, radius } from "../kernel/units.ts";
import { pocketsOf, type Pocket } from "./actions/pockets.ts";
import { borderOf, type OpenRegion } from "./open-regions.ts";
import type { Chain, PlanRequest, PlannedPart } from "./types.ts";
import type { MissingTool } from "./working-plan.ts";

/** Steeper walls are left to blades, degrees from the axis. */
const WALL = 85;
/** Any turning tool comes up to such a face, degrees. */
const UPRIGHT = 91;
/** Levels at which the width of a region is measured. */
const LEVELS = 8;

const whole = (n: number, digits = 2) => Number(n.toFixed(digits));

/** The side of the part on which a region lies, and its elements there. */
export function sideOf(
  region: OpenRegion,
  { outside, inside }: PlannedPart,
): { site: Site; border: readonly number[] } {
  const [out, into] = [borderOf(outside, region), borderOf(inside, region)];
  const indices = (b: readonly [number, number] | null) =>
    b ? Array.from({ length: b[1] - b[0] + 1 }, (_, i) => b[0] + i) : [];
  if (into && !out) return { site: "inside", border: indices(into) };
  const border = indices(out);
  const isFace = border.length > 0 && border.every((i) => isAcross(outside.segments[i]));
  return { site: isFace ? "face" : "outside", border };
}

const isAcross = (s: Segment | undefined) => s !== undefined && Math.abs(s.to.z - s.from.z) < SAME;

/** Width of a region where it is narrowest between two walls, mm; Infinity where one side is open at every level. */
function narrowest({ rings, box }: Pick<OpenRegion, "rings" | "box">): number {
  const heights = Array.from({ length: LEVELS }, (_, i) => box.low + ((i + 0.5) * (box.high - box.low)) / LEVELS);
  const widths = heights.flatMap((r) => {
    const crossed = rings
      .flatMap((ring) =>
        ring.flatMap((b, i) => {
          const a = ring.at(i - 1) ?? b;
          return a.r <= r === b.r <= r ? [] : [a.z + ((b.z - a.z) * (r - a.r)) / (b.r - a.r)];
        }),
      )
      .sort((a, b) => a - b);
    return crossed.flatMap((z, i) => (i % 2 === 1 ? [z - (crossed[i - 1] ?? z)] : []));
  });
  return Math.min(Infinity, ...widths);
}

/** Steepest descents of a chain as seen from the front and from the rear, degrees from the axis. */
function descents(elements: readonly Segment[], sign: 1 | -1): { readonly ahead: number; readonly back: number } {
  const slopes = elements.flatMap((s) => {
    const points = part.flattenedChain([s], CHORD);
    return points.slice(1).map((b, i) => {
      const a = points[i] ?? b;
      return inDegrees(Math.atan2((a.r - b.r) * sign, Math.abs(a.z - b.z)));
    });
  });
  return { ahead: Math.max(0, ...slopes), back: Math.max(0, ...slopes.map((n) => -n)) };
}

/** Steepest wall that a tool comes up to, degrees from the axis: more than 90 where it leans over its own foot. */
function steepest(elements: readonly Segment[], hand: "right" | "left", site: Site): number {
  const [ahead, out] = [hand === "right" ? -1 : 1, site === "inside" ? -1 : 1];
  const walls = elements.flatMap((s) => {
    const points = part.flattenedChain([s], CHORD);
    return points.slice(1).flatMap((b, i) => {
      const a = points[i] ?? b;
      const [low, high] = (b.r - a.r) * out > 0 ? [a, b] : [b, a];
      const rises = hand === "right" ? low === a : low === b;
      return rises && part.apart(a, b) > SAME
        ? [inDegrees(Math.atan2(Math.abs(b.r - a.r), (high.z - low.z) * ahead))]
        : [];
    });
  });
  return Math.max(0, ...walls);
}

/** Least radius of the hollows of a chain, mm; Infinity without one. */
const leastHollow = (elements: readonly Segment[], site: Site): number =>
  Math.min(Infinity, ...elements.flatMap((s) => (s.kind === "arc" && isHollow(s, site) ? [part.radiusOf(s)] : [])));

/** Whether the centre of an arc lies outside the material. */
function isHollow(s: Extract<Segment, { kind: "arc" }>, site: Site): boolean {
  const middle = part.pointOn(s, 0.5);
  return site === "inside" ? s.centre.r < middle.r : s.centre.r > middle.r;
}

/** The pocket of the outside in which all of a border lies; null where it lies in none. */
function pocketAround(border: readonly number[], { outside }: PlannedPart): Pocket | null {
  const [first, last] = [border[0] ?? -1, border.at(-1) ?? -1];
  // The wall behind a pocket may lean over it.
  return pocketsOf(outside, "r").find((p) => p.first <= first && last <= p.last + 1) ?? null;
}

/** The space of a pocket. */
function pieceOf({ segments }: Pocket): Pick<OpenRegion, "rings" | "box"> {
  const ring = part.flattenedChain(segments, CHORD);
  return { rings: [ring], box: boxOf(ring) };
}

/** The smallest data of a tool that takes a region, from the shape of the region and of the elements around it. */
export function missingFor(region: OpenRegion, { part: planned, blank }: PlanRequest): MissingTool {
  const { site, border } = sideOf(region, planned);
  const chain: Chain = site === "inside" ? planned.inside : planned.outside;
  const { box } = region;
  const pocket = site === "outside" ? pocketAround(border, planned) : null;
  const elements = [...(pocket?.segments ?? []), ...border.flatMap((i) => chain.segments[i] ?? [])];
  const hollow = leastHollow(elements, site);
  const nose = Number.isFinite(hollow) ? { mostNose: whole(hollow) } : {};
  const inside = site === "inside" ? boring(region, planned, blank) : {};
  const { ahead, back } = descents(elements, site === "inside" ? -1 : 1);
  if (site === "inside" && box.low < SAME) return { form: "drill", site, ...inside };
  const isPocket = site !== "inside" || box.low > leastRadius(region, planned) - SAME;
  if (isPocket && Math.min(ahead, back) > WALL) {
    const around = chain.segments
      .flatMap((s) => [s.from, s.to])
      .filter(({ z }) => z >= box.left - 1 && z <= box.right + 1);
    const edge = around.map(({ r }) => r);
    const open = site === "inside" ? Math.min(box.low, ...edge) : Math.max(box.high, ...edge);
    const depth = site === "inside" ? box.high - open : open - box.low;
    const width = narrowest(pocket ? pieceOf(pocket) : region);
    return {
      form: "recessing",
      site,
      ...(Number.isFinite(width) ? { mostWidth: whole(width) } : {}),
      leastDepth: whole(depth),
      ...nose,
      ...inside,
    };
  }
  const hand = ahead <= back ? "right" : "left";
  const descends = whole(Math.min(ahead, back), 1);
  const edge = whole(steepest(elements, hand, site), 1);
  return {
    form: site === "inside" ? "boring" : "turning",
    site,
    hand,
    ...(descends > 0 && descends <= WALL && { descends }),
    ...(edge > UPRIGHT && { leastEdge: edge }),
    ...nose,
    ...inside,
  };
}

/** Least radius of the finished bore from its front to the rear of a region, mm; Infinity where it has none. */
const leastRadius = ({ box }: OpenRegion, { inside }: PlannedPart): number =>
  Math.min(
    Infinity,
    ...inside.segments
      .flatMap((s) => [s.from, s.to])
      .filter(({ z, r }) => z > box.left - SAME && r > SAME)
      .map(({ r }) => r),
  );

/** What fits into a bore up to a region: into the hole that is there, or for a drill into the finished bore. */
function boring(region: OpenRegion, planned: PlannedPart, blank: PlanRequest["blank"]): Partial<MissingTool> {
  const { box } = region;
  const least = leastRadius(region, planned);
  const most = box.low < SAME ? least : Math.min(least, box.low);
  return {
    ...(Number.isFinite(most) ? { mostDiameter: whole(toDiameter(radius(most))) } : {}),
    leastReach: whole(boxAround(blank).right - box.left),
  };
}
