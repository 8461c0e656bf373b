import { pointLength } from "../../kernel/cutter/drill.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { difference, intersection, union } from "../../kernel/area/clip.ts";
import { at, part as geometry, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { radiusOf, rounded } from "../../kernel/units.ts";
import { canDo, type AxisWork } from "../../program/edits/hand-operation.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { drillsBefore } from "../../program/tools/reamed-hole.ts";
import { RUN_THROUGH } from "../../sim/behind-blank.ts";
import { applyAction } from "../apply-action.ts";
import { boundOf } from "../bound.ts";
import type { Action, ActionSource, ElementMark, PlannedPart, PlanRequest } from "../types.ts";
import { isDeepHole } from "../values/axis-values.ts";
import { insideOf } from "./bore.ts";
import { beyondRear, ROUGH_BEYOND } from "./bore-turning.ts";
import { finishInside } from "./finish-inside.ts";
import { drillsOf, onAxis } from "./on-axis.ts";
import { reachesRear, reamedBy, reamersOf, reamSeconds } from "./ream.ts";

/** Stock in front of the face that is no reason to face first, mm. */
const FACED = 0.05;
/** A drill this much smaller makes a bore without a tolerance, or one that a tap follows, mm on the radius. */
const SMALLER = 0.15;
/** Greatest roughness of a drilled wall, Ra in µm: finer ones are bored. */
const DRILLED = 6.3;
/** Least length of the cylinder that a drill makes, in radii. */
const LEAST_LENGTH = 0.5;
/** Least material that a drill takes, mm² of the half plane. */
const LEAST = 2;
/** Of usual drills that differ by less than this depth, mm, and hardly in diameter, the largest is proposed. */
const LIKE_DEPTH = 1;
/** Most drills that are proposed. */
const MOST = 4;
const NO_MARK: ElementMark = { row: "" };

/** Whether a drill makes a cylinder to size. */
function fits(r: number, { from, to }: Segment, { tolerance, roughness = Infinity, thread }: ElementMark): boolean {
  const rough = thread !== undefined || (tolerance === undefined && roughness >= DRILLED);
  return Math.abs(from.r - to.r) < SAME && from.r > r - SAME && from.r < r + SMALLER && rough;
}

/**
 * Z that the point of a drill may reach inside a part, with material left on the wall, mm; null where it does not fit. One
 * of `reamers` may follow.
 */
export function deepestPoint(
  tool: Tool,
  part: PlannedPart,
  allowance: number,
  reamers: readonly Tool[] = [],
): number | null {
  const { inside } = part;
  const [first, last] = [inside.segments[0]?.from, inside.segments.at(-1)?.to];
  const [r, point] = [tool.R ?? 0, pointLength(tool)];
  if (!first || !last || !(r > 0)) return null;
  let deepest = last.r > SAME ? last.z - point - beyondRear(part) - ROUGH_BEYOND : -Infinity;
  // A drill that makes one of the cylinders, or the hole before a reamer, leaves nothing for boring.
  const isReamed = reamers.some((reamer) => drillsBefore(reamer, tool) && reamedBy(reamer, part));
  const makes = isReamed || inside.segments.some((segment, i) => fits(r, segment, inside.marks[i] ?? NO_MARK));
  const wall = r + (makes ? -SAME : allowance);
  inside.segments.forEach((segment) => {
    // No bar gets to the axis: its point makes a bottom.
    const wide = segment.to.r < SAME ? r - SAME : wall;
    const corners = geometry.flattened(segment, CHORD);
    corners.forEach((p, k) => {
      const before = corners[k - 1];
      if (before && (before.r - wide) * (p.r - wide) < 0)
        deepest = Math.max(deepest, before.z + ((wide - before.r) / (p.r - before.r)) * (p.z - before.z) - point);
      if (p.r < wide) deepest = Math.max(deepest, p.z - (p.r * point) / wide);
    });
  });
  return deepest < first.z - point - LEAST_LENGTH * r ? deepest : null;
}

/** The half section of a drill whose point is at a Z. */
function bodyOf(tool: Tool, z: number, front: number): Ring {
  const r = tool.R ?? 0;
  return [at(z, 0), at(front, 0), at(front, r), at(z + pointLength(tool), r)];
}

/** A faced blank with the bore of its part, the oversize for finishing on some of its cylinders, and open behind it. */
function boredFor(cylinders: readonly Segment[], { part, blank, rules }: PlanRequest): readonly Ring[] {
  const box = (left: number, right: number, low: number, high: number): Ring => [
    at(left, low),
    at(right, low),
    at(right, high),
    at(left, high),
  ];
  const oversize = radiusOf(rules.allowance.diameter);
  const [inside, last] = [insideOf(part), part.inside.segments.at(-1)?.to];
  if (!inside || !last) return blank;
  const behind = box(last.z - beyondRear(part) - ROUGH_BEYOND, last.z, 0, last.r - oversize);
  const { high, right } = boxAround(blank);
  const front = box(boxAround([inside]).right, right, 0, high);
  const skins = cylinders.map(({ from, to }) => box(to.z, from.z, from.r - oversize, from.r));
  return union(difference(blank, [inside, behind, front]), skins);
}

/**
 * Whether a reamer reaches the rear, and takes no longer than boring does, or no bar bores: with the prices of tools that
 * the table lacks.
 */
function isWorthReaming(reamer: Tool, request: PlanRequest): boolean {
  const made = reamedBy(reamer, request.part);
  if (!made) return false;
  const { usualTools = [], rules } = request;
  const price = ({ T }: Tool) => (usualTools.includes(T) ? rules.usualTool : 0);
  const stock = boredFor(made.cylinders, request);
  if (!reachesRear(reamer, made, stock)) return false;
  const rear = Math.min(...made.cylinders.map(({ to }) => to.z));
  const state = { stock, done: [], threads: new Set<string>() };
  // A bar that is blocked in front of their rear, or meets a wall on its way, does not bore them.
  const bars = finishInside
    .actions(state, request)
    .filter((action) => action.place.rear < rear + SAME && applyAction(action, state, request).works);
  const boring = bars.map((action) => boundOf(action, [], request).seconds + price(action.tool));
  return reamSeconds(reamer, made, stock, request) + price(reamer) <= Math.min(Infinity, ...boring);
}

/** The reamers for whose holes a part is drilled, found once. */
const worth = new WeakMap<PlanRequest, readonly Tool[]>();
function reamersFor(request: PlanRequest): readonly Tool[] {
  const made = worth.get(request) ?? reamersOf(request).filter((reamer) => isWorthReaming(reamer, request));
  worth.set(request, made);
  return made;
}

function drillAction(tool: Tool, z: number, stock: readonly Ring[], request: PlanRequest): Action | null {
  const front = frontOf(stock);
  const depth = rounded(front - z);
  const made = (work: AxisWork) => {
    const cut = onAxis(work, tool, depth, stock, request);
    return cut && { ...cut, key: `${work} T${tool.T} Z${rounded(z)}` };
  };
  // Without a cycle whose pecks get shorter they are all as short as the last one.
  const reamer = reamersFor(request).find((each) => drillsBefore(each, tool));
  const cut = (isDeepHole(tool, depth) ? made("peck") : null) ?? made("drill");
  return (
    cut && {
      ...cut,
      kind: "drill",
      site: "inside",
      tool,
      place: { front, rear: front - depth, high: tool.R ?? 0, low: 0 },
      threads: [],
      ...(reamer && { reamer: reamer.T }),
    }
  );
}

/** Drills that fit inside the part, each to its deepest place, those that take most first. */
export function drillsFor(stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { part, rules } = request;
  const inside = insideOf(part);
  const front = frontOf(stock);
  if (!inside || front > boxAround([inside]).right + FACED) return [];
  const reamers = reamersFor(request);
  return drillsOf(request)
    .filter((tool) => canDo("drill", tool, { isInside: true, depth: 0 }))
    .flatMap((tool) => {
      const reached = deepestPoint(tool, part, radiusOf(rules.allowance.diameter), reamers);
      if (reached === null) return [];
      const z = Math.max(reached, front - (tool.CUTLENGTH ?? Infinity), boxAround(stock).left - RUN_THROUGH);
      const taken = areaOf(intersection(stock, [bodyOf(tool, z, front)]));
      return taken < LEAST ? [] : [{ tool, z, taken }];
    })
    .toSorted((a, b) => b.taken - a.taken)
    .filter(({ tool, z }, i, all) => {
      const isLike = (other: (typeof all)[number]) =>
        Math.abs((other.tool.R ?? 0) - (tool.R ?? 0)) < SMALLER && Math.abs(other.z - z) < LIKE_DEPTH;
      return !request.usualTools?.includes(tool.T) || !all.slice(0, i).some(isLike);
    })
    .slice(0, MOST)
    .flatMap(({ tool, z }) => drillAction(tool, z, stock, request) ?? []);
}

/** Drills the inside on the axis. */
export const drill: ActionSource = {
  kind: "drill",
  actions: ({ stock }, request) => drillsFor(stock, request),
};
