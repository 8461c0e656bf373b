import type { Cycle } from "../../cycles/define.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { tipDirection } from "../../kernel/cutter/insert.ts";
import { part as geometry, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { rounded, radius, toDiameter } from "../../kernel/units.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import type { SetJob } from "../../program/job/job.ts";
import { readDraft } from "../../program/job/read-draft.ts";
import { jobFor, tipAtCall } from "../../program/job/requested-job.ts";
import { boxAroundContour, cylinderAround } from "../../program/job/requested-shape.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { checkTool } from "../../program/tools/check-tool.ts";
import { fitOf } from "../../program/tools/which-tool.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { borderOf, type OpenRegion } from "../open-regions.ts";
import type { Action, ActionKind, PlannedPart, PlanRequest } from "../types.ts";
import { boredTo, clearRadius, solidFrom } from "./bore.ts";

/** Clearance of the tip in front of the material, and beside the wall of the bore, mm. */
const [AHEAD, BESIDE] = [2, 0.2];
/** Radius at which the cone that a drill has left is measured, mm. */
const CONE_AT = 0.5;
/** Distance that a cut goes beyond the rear end of a bore, mm, so that its nose radius leaves nothing. */
const BEYOND = 1;
/** Halvings that find a point of an element: below every resolution. */
const HALVINGS = 40;

/** Elements of the inside that a region borders; at the rear end of a through bore a little beyond it. */
export function sectionOf({ inside }: PlannedPart, region: OpenRegion): readonly Segment[] {
  const border = borderOf(inside, region);
  if (!border) return [];
  const [first, last] = border;
  const section = inside.segments.slice(first, last + 1);
  const end = section.at(-1)?.to;
  if (last < inside.segments.length - 1 || !end || end.r < BESIDE) return section;
  return [...section, geometry.line(end, geometry.point(end.z - BEYOND, end.r))];
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

/** A chain between two Z. */
export const between = (section: readonly Segment[], { front, rear }: Pick<BoreWay, "front" | "rear">) =>
  upToZ(fromZ(section, front), rear);

/** The way into a bore, mm. */
export interface BoreWay {
  /** Z of the start point, and the radius of the narrowest place on the way to it. */
  readonly z: number;
  readonly clear: number;
  /** The least radius of the start: passes begin there. */
  readonly low: number;
  /** Z between which the contour is cut: no farther than the cone that a drill has left, and not beside the start. */
  readonly front: number;
  readonly rear: number;
}

/** Length of the cone at the bottom of a bore in radii. */
const coneSlope = (stock: readonly Ring[], bottom: number): number =>
  bottom === -Infinity ? 0 : (solidFrom(stock, CONE_AT) - bottom) / CONE_AT;

/** The way to a region; null without a bore that leads to it. */
export function wayInto(stock: readonly Ring[], { box }: OpenRegion): BoreWay | null {
  const front = frontOf(stock);
  const bottom = boredTo(stock);
  if (bottom >= box.right - BESIDE) return null;
  const isDeep = box.right < front - AHEAD;
  const clear = clearRadius(stock, Math.min(box.right, front) - BESIDE, front);
  // The cone that a drill has left is taken by passes of its own, from its front.
  const rear = isDeep ? -Infinity : bottom + clear * coneSlope(stock, bottom) + BESIDE;
  const along = clearRadius(stock, Math.max(box.left, rear), front);
  return {
    z: (isDeep ? box.right : front) + AHEAD,
    clear,
    low: Math.min(along, isDeep ? box.low : Infinity) - BESIDE,
    front: isDeep ? box.right + BESIDE : Infinity,
    rear,
  };
}

/** Radius at which the tip of a bar starts so that its body is clear of the opposite wall; null where it is too thick. */
export function startFor(tool: Tool, { clear, low }: BoreWay): number | null {
  const least = -Math.min(0, ...holderOutlines(tool).flatMap((ring) => ring.map(({ r }) => r))) - clear + BESIDE;
  const r = Math.max(0, low, least);
  return r <= clear - BESIDE && (tool.DMIN ?? 0) <= toDiameter(radius(clear)) ? r : null;
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

/** The job of a cycle inside, from a start point in the bore. */
export function jobInside(
  cycle: Cycle,
  wanted: ShapeRequest,
  stock: readonly Ring[],
  start: { readonly z: number; readonly r: number },
  values: Readonly<Record<string, number>>,
): SetJob {
  const job = jobFor(cycle, wanted, stock);
  const own = Object.entries(values).filter(([q]) => cycle.params[q]);
  const bore = clearRadius(stock, start.z, frontOf(stock));
  return {
    ...job,
    // The way into the bore depends on its size at the mouth.
    blank: { ...cylinderAround(stock), bore: Number.isFinite(bore) ? positionAsTyped(toDiameter(radius(bore))) : "0" },
    start: { x: positionAsTyped(toDiameter(radius(start.r))), z: positionAsTyped(start.z) },
    drafts: {
      [cycle.number]: {
        ...job.drafts[cycle.number],
        ...Object.fromEntries(own.map(([q, value]) => [q, String(rounded(value))])),
      },
    },
  };
}

/** Whether a tool points away from the axis. */
const isBoring = ({ TO }: Tool): boolean => tipDirection(TO).v > 0;

/** A boring bar and its job. */
export interface BarJob {
  readonly tool: Tool;
  readonly job: SetJob;
}

/** Jobs of a cycle with each boring bar that enters and cuts, those that reach most first. */
export function barJobs(
  cycle: Cycle,
  wanted: ShapeRequest,
  stock: readonly Ring[],
  way: BoreWay,
  values: Readonly<Record<string, number>>,
  tools: readonly Tool[],
): readonly BarJob[] {
  return tools
    .filter((tool) => isBoring(tool) && checkTool(tool).length === 0)
    .flatMap((tool) => {
      const r = startFor(tool, way);
      if (r === null) return [];
      const job = { ...jobInside(cycle, wanted, stock, { z: way.z, r }, values), tool: tool.T };
      const read = readDraft(cycle, job.drafts[job.cycle] ?? {}).values;
      const start = tipAtCall(job);
      const contour = cycle.contour === "free" ? readRows(job.contour).contour.segments : null;
      if (!read) return [];
      const setting = { tool, start, feedUnit: "mm/rev", autoFeed: null, stock: null } as const;
      const fit = fitOf(tool, cycle.plan(read, setting, { contour, start }));
      return fit.cuts ? [{ tool, job, fit }] : [];
    })
    .toSorted((a, b) => a.fit.unreached - b.fit.unreached);
}

/** The turning tools of a request that suit, without the excluded ones. */
export const barsOf = ({ shop, withoutTools }: PlanRequest, suits: (tool: Tool) => boolean): readonly Tool[] =>
  shop.tools.filter((tool) => isBoring(tool) && !withoutTools.includes(tool.T) && suits(tool));

/** The action of a boring bar on a region. */
export const barAction = (kind: ActionKind, { tool, job }: BarJob, { box }: Pick<OpenRegion, "box">): Action => ({
  kind,
  key: `${kind} ${job.cycle} T${tool.T} X${job.start.x} Z${job.start.z}`,
  site: "inside",
  tool,
  cycle: job.cycle,
  job,
  place: { front: box.right, rear: box.left, high: box.high, low: box.low },
  threads: [],
  values: [],
});
