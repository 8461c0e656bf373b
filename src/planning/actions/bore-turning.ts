import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { part as geometry, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { readThread } from "../../kernel/thread/threads.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { boxAroundContour } from "../../program/job/requested-shape.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { borderOf, type OpenRegion } from "../open-regions.ts";
import type { ElementMark, PlannedPart } from "../types.ts";
import { boredTo, clearRadius, solidFrom } from "./bore.ts";
import type { CutRequest } from "./values-of-job.ts";

/** Clearance of the tip in front of the material, and beside the wall of the bore, mm. */
const AHEAD = 2;
export const BESIDE = 0.2;
/** Steps of the radius at which the cone that a drill has left is measured, and the first one, mm. */
const [CONE_AT, ON_CONE] = [0.5, 0.01];
/** Its rise along Z for 1 mm of the radius: a flat bottom rises less, the wall of a stepped bore more. */
const [FLAT, STEEP] = [0.2, 2];
/** Distance that a cut goes beyond the rear end of a bore, mm, so that its nose radius leaves nothing. */
const BEYOND = 1;
/** Roughing goes farther, mm: the edge of a finishing insert leans over its tip. */
export const ROUGH_BEYOND = 1;
/** Room that the run-out of a thread needs there, in pitches. */
const RUN_OUT = 3;

/** Distance that the inside of a part is cut beyond its rear end, mm: a thread runs out there. */
export function beyondRear({ inside: { marks } }: Pick<PlannedPart, "inside">): number {
  const thread = readThread(marks.at(-1)?.thread ?? "");
  return BEYOND + RUN_OUT * (thread?.pitch ?? 0);
}
/** Halvings that find a point of an element: below every resolution. */
const HALVINGS = 40;

/** Elements of the inside, and the marks of those that are surfaces of the part. */
export interface Section {
  readonly segments: readonly Segment[];
  readonly marks: readonly ElementMark[];
}

/**
 * Elements of the inside that a region borders; at the rear end of a through bore they go on beyond it, by `more` mm
 * than finishing does.
 */
export function sectionOf(part: PlannedPart, region: OpenRegion, more = 0): Section {
  const { inside } = part;
  const border = borderOf(inside, region);
  if (!border) return { segments: [], marks: [] };
  const [first, last] = border;
  const section = inside.segments.slice(first, last + 1);
  const end = section.at(-1)?.to;
  const marks = inside.marks.slice(first, last + 1);
  if (last < inside.segments.length - 1 || !end || end.r < BESIDE) return { segments: section, marks };
  return { segments: [...section, geometry.line(end, geometry.point(end.z - beyondRear(part) - more, end.r))], marks };
}

/** A chain from its last point in front of a Z; the whole chain where it begins behind it. */
function fromZ(section: readonly Segment[], z: number): readonly Segment[] {
  const first = section.findLastIndex((s) => s.from.z > z);
  const s = section[first];
  if (!s) return section;
  if (s.to.z >= z) return section.slice(first + 1);
  return [{ ...s, from: geometry.pointOn(s, crossing(s, z)) }, ...section.slice(first + 1)];
}

/** A chain up to its first point behind a Z. */
function upToZ(section: readonly Segment[], z: number): readonly Segment[] {
  const last = section.findIndex((s) => s.to.z < z);
  const s = section[last];
  if (!s) return section;
  if (s.from.z <= z) return section.slice(0, last);
  return [...section.slice(0, last), { ...s, to: geometry.pointOn(s, crossing(s, z)) }];
}

/** The share of a segment at which it passes a Z. */
function crossing(s: Segment, z: number): number {
  let [low, high] = [0, 1];
  for (let i = 0; i < HALVINGS; i += 1) {
    const k = (low + high) / 2;
    [low, high] = geometry.pointOn(s, k).z > z ? [k, high] : [low, k];
  }
  return high;
}

/** The way into a bore, mm. */
export interface BoreWay {
  /** Z of the start point, and the radius of the narrowest place on the way to it. */
  readonly z: number;
  readonly clear: number;
  /** The least radius of the start: passes begin there. */
  readonly low: number;
}

/**
 * Where the cone that a drill has left begins, at the bottom of a bore or at the rear end of one that it has not run
 * through: the Z that a bar may reach; −Infinity without a cone. `z` and `r`: where the bore is narrowest.
 */
function coneFront(
  stock: readonly Ring[],
  { z, r: narrow }: { readonly z: number; readonly r: number },
  clear: number,
): number {
  const bottom = solidFrom(stock, narrow + ON_CONE);
  if (bottom === -Infinity || bottom > z + CONE_AT || narrow + CONE_AT > clear) return -Infinity;
  const slope = (solidFrom(stock, narrow + CONE_AT) - bottom) / (CONE_AT - ON_CONE);
  if (slope < FLAT || slope > STEEP) return -Infinity;
  let r = narrow + CONE_AT;
  const isCone = (at: number) => Math.abs(solidFrom(stock, at) - bottom - slope * (at - narrow - ON_CONE)) < BESIDE;
  while (r < clear && isCone(r + CONE_AT)) r += CONE_AT;
  return bottom + slope * (r - narrow) + BESIDE;
}

/**
 * Off the wall where a cut ends in front of stock that is left: there the nose radius would stand in it, and take some of
 * what lies behind its contour. At 45°, only where the part gets no narrower behind; across where the cone that a drill
 * has left begins. Where the part gets wider behind the wall goes on first, or the nose radius would leave its end.
 */
function runOut(
  contour: readonly Segment[],
  stock: readonly Ring[],
  part: PlannedPart,
  cone: number,
): readonly Segment[] {
  const last = contour.at(-1)?.to;
  if (!last || last.r < BESIDE) return [];
  const hole = clearRadius(stock, last.z - BESIDE, last.z);
  if (hole >= last.r) return [];
  const height = last.r - hole + BESIDE;
  if (solidFrom(stock, hole - BESIDE) > last.z - height) {
    if (last.z > cone + SAME) return [];
    const free = clearRadius(stock, last.z - ON_CONE, last.z);
    return free < last.r ? [geometry.line(last, geometry.point(last.z, free - ON_CONE))] : [];
  }
  const points = geometry.flattenedChain(part.inside.segments, CHORD);
  const wayFrom = ({ z, r }: Pt): readonly Segment[] => {
    const end = geometry.point(z - height, r - height);
    const isNarrower = points.some((p) => p.z > end.z && p.z < last.z && p.r < r - Math.max(0, z - p.z) - SAME);
    return isNarrower ? [] : [geometry.line(geometry.point(z, r), end)];
  };
  const wall = clearRadius(part.rings, last.z - BEYOND, last.z - ON_CONE);
  const beyond = geometry.point(last.z - BEYOND, last.r);
  const farther = wall < Infinity && wall > last.r + SAME ? wayFrom(beyond) : [];
  return farther.length > 0 ? [geometry.line(last, beyond), ...farther] : wayFrom(last);
}

/** A contour inside that is cut only up to a Z, finishing with the way off the wall there. */
export function contourUpTo(
  contour: readonly Segment[],
  z: number,
  stock: readonly Ring[],
  part: PlannedPart,
  operation: CutRequest["operation"],
): readonly Segment[] {
  const cut = upToZ(contour, z);
  return operation === "rough" ? cut : [...cut, ...runOut(cut, stock, part, z)];
}

/**
 * A contour inside for a blade of a width: a finishing pass goes on until the whole blade is past the end. Behind the part
 * the whole program counts what lies behind its contours as the part, so that the contour ends earlier by the width.
 */
export function withinRear(
  contour: readonly Segment[],
  width: number,
  { inside: { segments } }: PlannedPart,
): readonly Segment[] {
  const [end, rear] = [contour.at(-1)?.to, segments.at(-1)?.to];
  if (width === 0 || !end || !rear || end.z > rear.z - SAME) return contour;
  const before = contour.findLastIndex(({ from }) => Math.abs(from.r - end.r) > SAME);
  const front = contour[before + 1]?.from.z ?? rear.z;
  return upToZ(contour, Math.min(end.z + width, front));
}

/** A section with what passes beside a region need in front of it: from a Z on, and whether the wall stands there. */
interface Beside {
  readonly segments: readonly Segment[];
  readonly from: number;
  readonly isWall: boolean;
}

/**
 * A section as it is cut in a bore whose wall stands already, not wider than a radius: from its region on. With the line
 * before a taper, since a path in along its own line would come out of the wall. Behind a neck with a piece of the neck,
 * however far in front of the region that ends: passes at the wider radius would begin in it.
 */
function besideOf(
  section: readonly Segment[],
  right: number,
  widest: number,
  { inside: { segments }, rings }: PlannedPart,
): Beside {
  const [first] = section;
  const before = first ? segments.slice(0, Math.max(0, segments.indexOf(first))) : [];
  const last = before.at(-1);
  const begin = first?.from ?? geometry.point(right, 0);
  const end = first?.to ?? begin;
  const isNeck = clearRadius(rings, begin.z, Math.max(begin.z, right) + AHEAD) < Math.max(begin.r, end.r) - SAME;
  const isTaper = end.r < begin.r - SAME && end.z < begin.z - SAME;
  const isLine = last !== undefined && last.to.z < last.from.z - SAME;
  const along = [...(isNeck ? before : isTaper && isLine ? [last] : []), ...section];
  const beside = right + BESIDE;
  const wall = fromZ(along, beside);
  if (!isNeck) return { segments: wall, from: right, isWall: (wall[0]?.from.r ?? Infinity) < widest };
  const neck = geometry.flattenedChain(upToZ(along, beside), CHORD).findLast(({ r }) => r < widest);
  const from = (neck && neck.z > beside + SAME ? neck.z : right) + AHEAD;
  return { segments: fromZ(along, from), from, isWall: neck !== undefined };
}

/** A section of the contour, and the way to it. */
export interface BoreSection extends Section {
  readonly way: BoreWay;
  /** It begins behind the front of the stock. */
  readonly isDeep: boolean;
}

/**
 * The section that borders a region, and the way to it; null without a bore that leads there. `oversize`: what is left
 * on the wall, mm; `more`: how much farther than finishing it goes beyond the rear end.
 */
export function sectionInBore(
  stock: readonly Ring[],
  part: PlannedPart,
  region: OpenRegion,
  { oversize = 0, more = 0 } = {},
): BoreSection | null {
  const { box } = region;
  const { segments: whole, marks } = sectionOf(part, region, more);
  const front = frontOf(stock);
  const bottom = boredTo(stock);
  const begin = whole[0]?.from;
  if (!begin || bottom >= box.right - BESIDE) return null;
  const isBehind = box.right < front - AHEAD;
  const clear = clearRadius(stock, isBehind ? box.right + BESIDE : Math.min(box.right, front) - BESIDE, front);
  const atFront = (z: number) => (z < front - AHEAD ? z + AHEAD : front + AHEAD);
  // In a bore whose wall stands already the passes begin beside the region, behind a neck where the contour leaves it.
  const beside = besideOf(whole, box.right, clear + BESIDE + oversize, part);
  const { isWall } = beside;
  const isDeep = isBehind && (isWall || begin.z < front - AHEAD);
  const z = atFront(!isDeep ? box.right : isWall ? beside.from : Math.max(begin.z, box.right));
  // The cone that a drill has left is taken by passes of its own, from its front.
  // Through a bore it goes as far as the contour does.
  const left = bottom === -Infinity ? Math.min(box.left, whole.at(-1)?.to.z ?? box.left) : box.left;
  const rearmost = Math.max(left, boxAround(stock).left);
  const narrow = bottom === -Infinity ? { z: rearmost, r: clearRadius(stock, left, front) } : { z: bottom, r: 0 };
  const drilled = coneFront(stock, narrow, clear);
  const endsInCone = box.left < drilled && drilled < box.right - AHEAD;
  const cone = isDeep && !endsInCone ? -Infinity : drilled;
  const least = clearRadius(stock, Math.max(left, cone), front);
  // Behind the part it goes no farther than the bore does.
  const end = part.inside.segments.at(-1)?.to.z ?? 0;
  const open = solidFrom(stock, least - BESIDE);
  const rear = open <= end + SAME ? Math.max(cone, Math.min(end, open)) : cone;
  // Roughing takes a cone behind the part with it: whatever it left there a finishing edge would meet, and the whole
  // program counts it as the part of the contours outside.
  const limit = oversize > 0 && rear === cone && cone < end ? -Infinity : rear;
  const cut = upToZ(isDeep && isWall ? beside.segments : whole, limit);
  const segments = oversize > 0 ? cut : [...cut, ...runOut(cut, stock, part, cone)];
  const low = Math.min(least, isDeep && !endsInCone ? box.low : Infinity) - BESIDE;
  return segments.length > 0 ? { segments, marks, way: { z, clear, low }, isDeep } : null;
}

/** Whether a section gets narrower behind a wider place: with and without plunging into it. */
export function plungings(segments: readonly Segment[]): readonly (boolean | undefined)[] {
  const points = geometry.flattenedChain(segments, CHORD);
  return points.some((p, i) => p.r > (points[i - 1]?.r ?? p.r) + SAME) ? [false, true] : [undefined];
}

/** A shape inside with a contour of its own. */
export const freeInside = (contour: readonly Segment[]): ShapeRequest => ({
  site: "inside",
  shape: "free",
  angle: 0,
  pitch: 1,
  contour,
  allowance: 0,
  ...boxAroundContour(contour, "inside"),
});
