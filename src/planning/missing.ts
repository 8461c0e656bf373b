import type { Site } from "../cycles/shape-request.ts";
import { boxAround, boxOf, inBox } from "../kernel/area/box.ts";
import { part, type Segment } from "../kernel/geometry/point.ts";
import { CHORD, SAME } from "../kernel/tolerance.ts";
import { inDegrees, toDiameter, radius } from "../kernel/units.ts";
import { isValley, pocketsOf, type Pocket } from "./actions/pockets.ts";
import { grooveOf } from "./actions/recess-inside.ts";
import { borderOf, LEAST_REGION, type OpenRegion } from "./open-regions.ts";
import type { Chain, PlanRequest, PlannedPart } from "./types.ts";
import type { MissingTool } from "./working-plan.ts";

/** Steeper walls are left to blades, degrees from the axis. */
const WALL = 85;
/** Least setting angle of usual boring bars, degrees (recalled, tag K): a smaller one cuts into what stands behind a bore. */
const LEAST_IN_BORE = 75;
/** Any turning tool comes up to such a face, degrees. */
const UPRIGHT = 91;
/** Levels at which the width of a region is measured, and the share of its depth at which that of its floor is. */
const [LEVELS, FLOOR] = [8, 0.01];

const whole = (n: number, digits = 2) => Number(n.toFixed(digits));
const roundedDown = (mm: number) => Math.floor(mm * 100 + SAME) / 100;

/** The side of the part on which a region lies, and its elements there. */
export function sideOf(
  region: OpenRegion,
  { outside, inside, rings }: PlannedPart,
): { site: Site; border: readonly number[] } {
  const [out, into] = [borderOf(outside, region), borderOf(inside, region)];
  const indices = (b: readonly [number, number] | null) =>
    b ? Array.from({ length: b[1] - b[0] + 1 }, (_, i) => b[0] + i) : [];
  if (into && !out) return { site: "inside", border: indices(into) };
  const border = indices(out);
  const isFace = border.length > 0 && (border.every((i) => isAcross(outside.segments[i])) || isInFace(region, rings));
  return { site: isFace ? "face" : "outside", border };
}

const isAcross = (s: Segment | undefined) => s !== undefined && Math.abs(s.to.z - s.from.z) < SAME;

/** Farther than any part, mm. */
const FAR = 10_000;

/** Whether a region is a groove in a face: the part stands on its outer side, and nothing of it in front. */
function isInFace({ box }: OpenRegion, rings: PlannedPart["rings"]): boolean {
  const middle = (box.left + box.right) / 2;
  const outer = inBox(rings, { left: middle - SAME, right: middle + SAME, low: box.high, high: FAR });
  const front = inBox(rings, { left: box.right + SAME, right: FAR, low: box.low + SAME, high: box.high - SAME });
  return outer.length > 0 && front.length === 0;
}

/** Width of a region where it is narrowest between two walls, mm; Infinity where one side is open at every level. */
function narrowest({ rings, box }: Pick<OpenRegion, "rings" | "box">, site: Site): number {
  // Levels are radii for a groove from outside or from the bore, and Z for one in a face.
  const [level, width] = site === "face" ? (["z", "r"] as const) : (["r", "z"] as const);
  const [from, to] = site === "face" ? [box.left, box.right] : [box.low, box.high];
  const floor = site === "inside" ? 1 - FLOOR : FLOOR;
  const shares = [floor, ...Array.from({ length: LEVELS }, (_, i) => (i + 0.5) / LEVELS)];
  const levels = shares.map((share) => from + share * (to - from));
  const widths = levels.flatMap((at) => {
    const crossed = rings
      .flatMap((ring) =>
        ring.flatMap((b, i) => {
          const a = ring.at(i - 1) ?? b;
          if (a[level] <= at === b[level] <= at) return [];
          return [a[width] + ((b[width] - a[width]) * (at - a[level])) / (b[level] - a[level])];
        }),
      )
      .sort((a, b) => a - b);
    return crossed.flatMap((w, i) => (i % 2 === 1 ? [w - (crossed[i - 1] ?? w)] : []));
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

/** Least radius of the rounded hollows of a chain, mm; Infinity without one. */
const leastHollow = (elements: readonly Segment[], site: Site): number =>
  Math.min(Infinity, ...elements.flatMap((s) => (s.kind === "arc" && isHollow(s, site) ? [part.radiusOf(s)] : [])));

/** Less is hardly left in a corner, mm². */
const HARDLY = 0.01;

/**
 * Greatest nose radius that leaves no more than an area in each sharp hollow of a chain, mm; Infinity without one. In a
 * hollow of the angle θ it leaves r² · (cot(θ/2) − (π − θ)/2).
 */
function nosesInCorners(elements: readonly Segment[], site: Site, most: number): number {
  const out = site === "inside" ? -1 : 1;
  const noses = elements.slice(1).flatMap((next, i) => {
    const before = elements[i] ?? next;
    if (part.apart(before.to, next.from) > SAME) return [];
    const [a, b] = [part.direction(before, before.to), part.direction(next, next.from)];
    // From the front to the rear a hollow of the outside turns away from the axis.
    const turn = Math.atan2(a.r * b.z - a.z * b.r, a.z * b.z + a.r * b.r) * out;
    const left = turn > 0 ? Math.tan(turn / 2) - turn / 2 : 0;
    return left > SAME ? [Math.sqrt(most / left)] : [];
  });
  return Math.min(Infinity, ...noses);
}

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

/** Elements of the undercut in which all of a border lies, with those beside it; none where it lies in none. */
function undercutAround(border: readonly number[], { segments, marks }: Chain): readonly Segment[] {
  const isIn = (i: number) => marks[i]?.undercut !== undefined;
  const row = marks[border.find(isIn) ?? -1]?.row;
  const own = segments.flatMap((_, i) => (row !== undefined && marks[i]?.row === row ? [i] : []));
  const [first, last] = [(own[0] ?? 0) - 1, (own.at(-1) ?? -2) + 1];
  return border.every((i) => i >= first && i <= last) ? segments.slice(Math.max(0, first), last + 1) : [];
}

/** The space of a pocket. */
function pieceOf({ segments }: Pick<Chain, "segments">): Pick<OpenRegion, "rings" | "box"> {
  const ring = part.flattenedChain(segments, CHORD);
  return { rings: [ring], box: boxOf(ring) };
}

/** The blade of a region between two steep walls: narrower than it and as long as it is deep, from its mouth. */
function blade(
  region: OpenRegion,
  chain: Chain,
  site: Site,
  pocket: Pick<Chain, "segments"> | null,
): Partial<MissingTool> {
  const { box } = region;
  const near = chain.segments
    .flatMap((s) => [s.from, s.to])
    .filter(({ z }) => z >= box.left - 1 && z <= box.right + 1)
    .map(({ r }) => r);
  const depth = {
    inside: box.high - Math.min(box.low, ...near),
    outside: Math.max(box.high, ...near) - box.low,
    face: box.right - box.left,
  }[site];
  const width = narrowest(pocket ? pieceOf(pocket) : region, site);
  return {
    ...(Number.isFinite(width) ? { mostWidth: whole(width) } : {}),
    leastDepth: whole(depth),
    ...(site === "face" && { across: [whole(acrossOf(box.low)), whole(acrossOf(box.high))] as const }),
  };
}

const acrossOf = (r: number): number => toDiameter(radius(r));

/**
 * The smallest data of a tool that takes a region, from the shape of the region and of the elements around it. A tool
 * with these data takes it (`tests/planning/missing.test.ts`).
 */
export function missingFor(region: OpenRegion, { part: planned, blank }: PlanRequest): MissingTool {
  const { site, border } = sideOf(region, planned);
  const chain: Chain = site === "inside" ? planned.inside : planned.outside;
  const { box } = region;
  const undercut = undercutAround(border, chain);
  const isOpen = undercut.length === 0;
  const pocket = isOpen && site === "outside" ? pocketAround(border, planned) : null;
  const around = isOpen && site === "inside" ? grooveOf(planned, region) : pocket;
  const own = isOpen ? border.flatMap((i) => chain.segments[i] ?? []) : undercut;
  const elements = [...(around?.segments ?? []), ...own];
  // A tool that takes less than what counts would not be used.
  const most = Math.max(HARDLY, Math.min(LEAST_REGION, region.area - LEAST_REGION));
  const hollow = Math.min(leastHollow(elements, site), nosesInCorners(elements, site, most));
  const nose = Number.isFinite(hollow) ? { mostNose: roundedDown(hollow) } : {};
  const inside = site === "inside" ? boring(region, planned, blank) : {};
  const { ahead, back } = descents(elements, site === "inside" ? -1 : 1);
  if (site === "inside" && box.low < SAME) return { form: "drill", site, ...inside };
  const isPocket = isOpen && (site !== "inside" || box.low > leastRadius(region, planned) - SAME);
  const isInFaceGroove = site === "face" && !elements.every(isAcross);
  const isGroove = pocket !== null && !isValley(pocket);
  if ((isPocket && Math.min(ahead, back) > WALL) || isInFaceGroove || isGroove)
    return { form: "recessing", site, ...blade(region, chain, site, around), ...nose, ...inside };
  // The edge behind the tip stays clear of what descends, the main edge cuts up to what rises.
  const hand = ahead <= back ? "right" : "left";
  const edge = whole(steepest(elements, hand, site), 1);
  const least = site === "inside" ? LEAST_IN_BORE : 0;
  const [descends, rises] = [whole(Math.min(ahead, back), 1), whole(Math.max(ahead, back, least), 1)];
  return {
    form: site === "inside" ? "boring" : "turning",
    site,
    hand,
    ...(rises > 0 && edge <= UPRIGHT && { rises }),
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
    ...(Number.isFinite(most) ? { mostDiameter: whole(acrossOf(most)) } : {}),
    leastReach: whole(boxAround(blank).right - box.left),
  };
}
