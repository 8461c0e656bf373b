import { pointLength } from "../../kernel/cutter/drill.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { at, part as geometry, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { radiusOf, rounded } from "../../kernel/units.ts";
import { canDo } from "../../program/edits/hand-operation.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { RUN_THROUGH } from "../../sim/behind-blank.ts";
import type { Action, ActionSource, ElementMark, PlannedPart, PlanRequest } from "../types.ts";
import { insideOf } from "./bore.ts";
import { beyondRear, ROUGH_BEYOND } from "./bore-turning.ts";
import { drillsOf, onAxis } from "./on-axis.ts";

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
/** Most drills that are proposed. */
const MOST = 4;
const NO_MARK: ElementMark = { row: "" };

/** Whether a drill makes a cylinder to size. */
function fits(r: number, { from, to }: Segment, { tolerance, roughness = Infinity, thread }: ElementMark): boolean {
  const rough = thread !== undefined || (tolerance === undefined && roughness >= DRILLED);
  return Math.abs(from.r - to.r) < SAME && from.r > r - SAME && from.r < r + SMALLER && rough;
}

/** Z that the point of a drill may reach inside a part, with material left on the wall; null where it does not fit. */
export function deepestPoint(tool: Tool, part: PlannedPart, allowance: number): number | null {
  const { inside } = part;
  const [first, last] = [inside.segments[0]?.from, inside.segments.at(-1)?.to];
  const [r, point] = [tool.R ?? 0, pointLength(tool)];
  if (!first || !last || !(r > 0)) return null;
  let deepest = last.r > SAME ? last.z - point - beyondRear(part) - ROUGH_BEYOND : -Infinity;
  // A drill that makes one of the cylinders leaves nothing for boring.
  const makes = inside.segments.some((segment, i) => fits(r, segment, inside.marks[i] ?? NO_MARK));
  const wide = r + (makes ? -SAME : allowance);
  inside.segments.forEach((segment) => {
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

function drillAction(tool: Tool, z: number, stock: readonly Ring[], request: PlanRequest): Action | null {
  const front = frontOf(stock);
  const depth = rounded(front - z);
  const made = onAxis("drill", tool, depth, stock, request);
  return (
    made && {
      ...made,
      kind: "drill",
      key: `drill T${tool.T} Z${rounded(z)}`,
      site: "inside",
      tool,
      place: { front, rear: front - depth, high: tool.R ?? 0, low: 0 },
      threads: [],
    }
  );
}

/** Drills that fit inside the part, each to its deepest place, those that take most first. */
export function drillsFor(stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { part, rules } = request;
  const inside = insideOf(part);
  const front = frontOf(stock);
  if (!inside || front > boxAround([inside]).right + FACED) return [];
  return drillsOf(request)
    .filter((tool) => canDo("drill", tool, { isInside: true, depth: 0 }))
    .flatMap((tool) => {
      const reached = deepestPoint(tool, part, radiusOf(rules.allowance.diameter));
      if (reached === null) return [];
      const z = Math.max(reached, front - (tool.CUTLENGTH ?? Infinity), boxAround(stock).left - RUN_THROUGH);
      const taken = areaOf(intersection(stock, [bodyOf(tool, z, front)]));
      return taken < LEAST ? [] : [{ tool, z, taken }];
    })
    .toSorted((a, b) => b.taken - a.taken)
    .slice(0, MOST)
    .flatMap(({ tool, z }) => drillAction(tool, z, stock, request) ?? []);
}

/** Drills the inside on the axis. */
export const drill: ActionSource = {
  kind: "drill",
  actions: ({ stock }, request) => drillsFor(stock, request),
};
