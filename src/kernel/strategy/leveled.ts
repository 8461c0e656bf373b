import { bridged } from "../reach/bridge.ts";
import { extent, type Convex } from "../reach/convex.ts";
import { lowest, type Envelope } from "../reach/envelope.ts";
import { lowestOf, segmentToFlat, toFlat, toPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { flanksUnknown, isBar } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { tracedStock, type Plan, type PlanContext } from "../plan/plan.ts";
import { at, type Segment } from "../geometry/point.ts";
import type { Bound } from "../reach/reach.ts";
import { SAME } from "../tolerance.ts";
import type { ToolType } from "../plan/tool.ts";
import { roomOf, type Room } from "../plan/track.ts";
import { length, radius, toDiameter } from "../units.ts";
import { withAxisCheck } from "./across.ts";
import { axisFloor, beyondAxis } from "./axis.ts";
import type { Feeds } from "./feeds.ts";
import { followContour } from "./finish.ts";
import { unfitIssue } from "./fit.ts";
import { envelopeAtCall, Frontier } from "./frontier.ts";
import {
  FAR,
  tipEnvelopeOver,
  insertIn,
  insidePart,
  reachAhead,
  reachOf,
  startInPart,
  type Surroundings,
} from "./tip-envelope.ts";
import { divide, limitedInfeed, type Division } from "./infeed.ts";
import { renumberedPasses, roughByLevels } from "./levels.ts";
import { limitsInPart, limitsOf } from "./limits.ts";
import { Cutter } from "./link.ts";
import { areaOver, partUnder } from "./outline-area.ts";

/** A cycle that removes its area in levels and then follows the contour: 81x along the axis, 82x across it. */
export interface Leveled {
  readonly frame: Frame;
  /** In machining direction, part space. */
  readonly contour: readonly Segment[];
  /** Number of elements at its start and end that only break an edge: they are ignored for the levels. */
  readonly edges: { readonly start: number; readonly end: number };
  readonly operation: number;
  readonly clearance: number;
  readonly infeed: number;
  readonly feeds: Feeds;
  /** Oversize on the radius and along Z, mm. */
  readonly oversize: { readonly r: number; readonly z: number };
  readonly plunging: boolean;
  readonly smoothing: number;
  /** Machining limits in strategy space; null where there is none. */
  readonly limit: Flat | null;
  /** Height of the outer corner of the area where that is higher than the contour's first point; else null. */
  readonly outerHeight: number | null;
  /**
   * True if the part continues in front of the first point, at its height: the tool comes in over an edge that remains.
   */
  readonly partInFront: boolean;
  /** "shoulder": clear of the box first across, then along. "contour": along the tool axis up to the contour start. */
  readonly startRule: "shoulder" | "contour";
}

/** Tool types that can cut along a surface. */
export const TURNING: readonly ToolType[] = ["ROUGH", "FINISH", "BUTTON", "RECTURN", "RECESS"];

/** Geometry shared by the steps of a plan, in strategy space. */
interface Site {
  readonly flat: readonly FlatSegment[];
  readonly insert: Convex;
  readonly keep: Flat;
  readonly called: Flat;
  /**
   * Tip height of the outer corner of the area; the highest and the lowest point of the contour, in outside machining
   * no deeper than the axis.
   */
  readonly outer: number;
  readonly highest: number;
  readonly lowest: number;
  /**
   * True if the part continues in front of the first point: as the cycle says, or because a cut from the middle
   * outwards leaves a pin.
   */
  readonly inFront: boolean;
}

function siteOf(l: Leveled, setting: PlanContext): Site | null {
  const flat = l.contour.map((s) => segmentToFlat(l.frame, s));
  const first = flat[0];
  if (!first) return null;
  const insert = insertIn(setting.tool, l.frame);
  return {
    flat,
    insert,
    called: toFlat(l.frame, setting.start),
    keep: l.frame.transverse ? { u: l.oversize.r, v: l.oversize.z } : { u: l.oversize.z, v: l.oversize.r },
    outer: Math.max(l.outerHeight ?? first.from.v, first.from.v) - extent(insert).minV,
    highest: flat.reduce((most, s) => Math.max(most, s.from.v, s.to.v), -Infinity),
    lowest: Math.max(
      axisFloor(l.frame),
      flat.reduce((least, s) => Math.min(least, lowestOf(s)), Infinity),
    ),
    inFront: l.partInFront || (l.frame.transverse && l.frame.signU > 0),
  };
}

/** Plans roughing and finishing of a leveled cycle. Never throws; what cannot be planned is an issue. */
export function planLeveled(l: Leveled, setting: PlanContext): Plan {
  const site = siteOf(l, setting);
  if (!site) return emptyPlan([]);
  const { tool } = setting;
  const { flat, called, keep, insert } = site;
  const last = flat[flat.length - 1] as FlatSegment;
  const sketch = {
    ...emptyPlan([]),
    contour: l.contour,
    part: partUnder(flat, l.frame, site.inFront),
    maxInfeed: length(l.infeed),
    openSide: toPart(l.frame, { u: 0, v: 1 }),
    oversize: l.oversize,
  };
  const withoutPath = (issues: readonly Issue[]): Plan => {
    const top = Math.max(called.v, site.outer);
    return { ...sketch, area: areaOver(flat, l.frame, frontOf(l, site, called.u), top), issues };
  };
  const issues: Issue[] = [];
  const refused = [unfitIssue(tool, l.frame, TURNING), wrongStart(l, site, setting)].filter((i) => i !== null);
  if (refused.length > 0) return withoutPath(refused);
  if (flanksUnknown(tool)) issues.push(issue("flanksNotChecked", "info", {}, "tool"));
  if (isBar(tool) && tool.TYPE === "RECESS")
    issues.push(issue("toolCannotCutSideways", "warning", { type: tool.TYPE }, "tool"));

  const bounds: Bound[] = l.plunging ? flat.map((segment) => ({ segment, on: "contour" })) : bridged(flat);
  const limits = limitsOf(l.limit, called, flat, issues);
  const over = toFinishOver(site, limits.floor);
  const drawn = tipEnvelopeOver(bounds, tool, l.frame, NO_OVERSIZE, over);
  const start = startOf(l, site, setting);
  const room: Room = {
    ...roomOf(l.frame, beyondAxis(tool, flat, l.frame)),
    ...(l.frame.transverse && l.frame.signU > 0 && { nearest: called.u }),
  };
  if (insidePart(drawn, called)) return withoutPath([...issues, startInPart(workingStart(l, site))]);
  const top = Math.max(start.v, site.outer);
  // Beyond the axis there is no material: there the area is open.
  const wall = top + extent(insert).minV > last.to.v + SAME && toPart(l.frame, last.to).r > SAME ? top + FAR : null;
  const floor = site.lowest + keep.v;
  // Material in front of a contour that begins or ends on the axis is removed with it: there is no floor.
  const floors =
    site.lowest > axisFloor(l.frame) + SAME ? [...over.floors, { v: floor, on: "edge" as const }] : over.floors;
  const kept = tipEnvelopeOver(bounds, tool, l.frame, keep, { ...over, wall, floors });
  // The contour with oversize is needed only where a cut follows it, or where roughing has run before.
  const isNeeded = (keep.u !== 0 || keep.v !== 0) && (l.operation > 1 || l.smoothing === 1);
  const grown = isNeeded ? tipEnvelopeOver(bounds, tool, l.frame, keep, over) : drawn;
  const stands = envelopeAtCall(
    {
      stock: tracedStock(setting),
      area: areaCorners(site, top, site.inFront ? Infinity : start.u + leadIn(l, site)),
      frame: l.frame,
      insert,
    },
    drawn.partEnvelope,
    l.operation > 1 ? { grown: grown.partEnvelope, infeed: l.infeed, top } : null,
  );
  const cutter = new Cutter(
    l.frame,
    setting.feedUnit,
    called,
    room,
    new Frontier(stands, insert, limits.ceiling),
    Math.max(called.v, l.frame.transverse || l.frame.signV > 0 ? start.v : top),
  );
  moveToStart(cutter, l, site, start, setting, issues);

  const from = Math.max(start.u, limits.from, room.minU);
  const end = Math.max(kept.end.u, drawn.end.u, last.to.u + keep.u) + SAME;
  const to = Math.min(end, limits.to - reachAhead(insert), room.maxU);
  const follow = {
    contour: flat,
    start,
    clearance: l.clearance,
    runOut: wall === null ? null : cutter.limitedInBore({ u: last.to.u, v: last.to.v + keep.v }).v,
    feeds: l.feeds,
    from,
    to,
    ceiling: limits.ceiling,
  };
  const unlimited = () => {
    if (!l.limit) return {};
    const whole = tipEnvelopeOver(bounds, tool, l.frame, NO_OVERSIZE, toFinishOver(site, null));
    const until = Math.min(whole.end.u, end, room.maxU);
    return { unlimited: reachOf(whole, Math.max(whole.pathStart, start.u, room.minU), until, l.frame, tool) };
  };
  let division: Division = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    const upper = Math.min(top, limits.ceiling);
    const depth =
      upper - Math.max(floor - extent(insert).minV, deepestLevel(l, site, setting, kept.envelope, from, to));
    const divided = divide(depth, limitedInfeed(l.infeed, tool, depth, issues), issues);
    if (!divided) return withoutPath(issues);
    division = divided;
    if (division.passes === 0) issues.push(issue("nothingToCut", "warning", {}, "startU"));
    roughByLevels(cutter, {
      envelope: kept.envelope,
      top: upper,
      ...division,
      first: kept.pathStart,
      from,
      to,
      smoothing: l.smoothing,
      clearance: l.clearance,
      feeds: l.feeds,
      skipsAirPasses: setting.skipsAirPasses ?? false,
    });
    if (l.smoothing === 1 && division.passes > 0)
      followContour(cutter, { ...follow, ground: grown, smoothing: true }, issues);
    returnToStart(cutter, start, l, "rough", 6);
  }
  if (l.operation !== 1) {
    followContour(cutter, { ...follow, ground: l.operation === 3 ? grown : drawn, smoothing: false }, issues);
    returnToStart(cutter, start, l, "finish", 4);
  }
  return withAxisCheck(
    {
      ...sketch,
      moves: cutter.moves,
      issues,
      ...division,
      ...(setting.skipsAirPasses && renumberedPasses(cutter.moves)),
      infeed: length(division.infeed),
      area: areaOver(flat, l.frame, frontOf(l, site, start.u), top),
      reach: reachOf(drawn, Math.max(drawn.pathStart, from), Math.min(drawn.end.u, to), l.frame, tool),
      oversizeReach: reachOf(
        kept,
        Math.max(kept.pathStart, from),
        Math.min(Math.max(kept.end.u, drawn.end.u), to),
        l.frame,
        tool,
      ),
      ...unlimited(),
      ...limitsInPart(l.limit, called, l.frame),
    },
    setting,
    l.frame.transverse ? "startU" : "startV",
  );
}

/** Where the area begins: at the start point, or at the contour if the cycle ignores the material in front. */
const frontOf = (l: Leveled, site: Site, from: number) => (l.partInFront ? (site.flat[0] as FlatSegment).from.u : from);

const NO_OVERSIZE: Flat = { u: 0, v: 0 };

/** Bounds of the finishing path besides the contour. */
const toFinishOver = (site: Site, floor: number | null): Surroundings => ({
  wall: null,
  front: site.inFront ? "part" : "free",
  frontWall: null,
  floors: floor === null ? [] : [{ v: floor, on: "limit" as const }],
});

/**
 * The deepest level of roughing: of the contour without the elements that only break its edges, within the reach of
 * this tool.
 */
function deepestLevel(l: Leveled, site: Site, { tool }: PlanContext, kept: Envelope, from: number, to: number): number {
  const deepest = lowest(kept, from, to);
  const core = site.flat.slice(l.edges.start, site.flat.length - l.edges.end);
  if (core.length === 0 || core.length === site.flat.length) return deepest;
  const surface = tipEnvelopeOver(
    core.map((segment) => ({ segment, on: "contour" })),
    tool,
    l.frame,
    site.keep,
    toFinishOver(site, null),
  );
  return Math.max(deepest, lowest(surface.envelope, from, to));
}

/** The area over the contour and in front of it (from `front` on), up to the level of the start point, as corners. */
function areaCorners(site: Site, top: number, front: number): Flat[] {
  const [first, last] = [site.flat[0] as FlatSegment, site.flat[site.flat.length - 1] as FlatSegment];
  const [low, high, from] = [first.from.v - FAR, top + extent(site.insert).minV, Math.min(first.from.u, front)];
  return [
    { u: from, v: low },
    { u: from, v: high },
    { u: last.to.u, v: high },
    { u: last.to.u, v: low },
  ];
}

/**
 * Start position of the cycle, as the manual states it before step 1: clear of the area, or up to the contour start.
 */
function startOf(l: Leveled, site: Site, setting: PlanContext): Flat {
  const { called } = site;
  const first = (site.flat[0] as FlatSegment).from;
  const finishing = l.operation > 1;
  const low = l.startRule === "contour" && called.v < first.v - SAME;
  const v = low ? first.v + (finishing ? l.clearance : 0) : called.v;
  if (!reachesIn(l, site, setting)) return { u: called.u, v };
  const lead = leadIn(l, site);
  // The finishing of a shoulder begins at the level of the call, if there is no part in front of it.
  const clear =
    finishing && l.startRule === "shoulder" && !site.inFront
      ? v
      : Math.max(v, Math.max(site.highest, site.outer) + l.clearance);
  return { u: first.u - lead - l.clearance, v: clear };
}

/** Reach ahead of the tip of the edge that an infeed brings into the material. */
function leadIn(l: Leveled, site: Site): number {
  const depth = Math.max(site.called.v, site.highest, site.outer) - site.lowest;
  return reachAhead(site.insert, l.operation > 1 ? undefined : l.infeed > 0 ? Math.min(l.infeed, depth) : depth);
}

const reachesIn = (l: Leveled, site: Site, setting: PlanContext) =>
  site.called.u + leadIn(l, site) > (site.flat[0] as FlatSegment).from.u + SAME && setting.start.r >= 0;

/** Refuses a free contour that runs towards the start point, and a start on the other side of the axis. */
function wrongStart(l: Leveled, site: Site, setting: PlanContext): Issue | null {
  const last = (site.flat[site.flat.length - 1] as FlatSegment).to;
  const behind = l.startRule === "contour" && site.called.u > last.u - SAME;
  if (!behind && setting.start.r >= -SAME) return null;
  return issue("startOnWrongSide", "error", workingStart(l, site), "startU");
}

/** A start point that works: in front of the contour and above it, by the clearance. */
function workingStart(l: Leveled, site: Site): { x: number; z: number } {
  const u = (site.flat[0] as FlatSegment).from.u - leadIn(l, site) - l.clearance;
  const works = toPart(l.frame, { u, v: Math.max(site.highest, site.outer) + l.clearance });
  return { x: toDiameter(works.r < 0 ? radius(0) : works.r), z: works.z };
}

/** Moves the tool from the call to the start of the cycle, and reports a different start. */
function moveToStart(cutter: Cutter, l: Leveled, site: Site, start: Flat, setting: PlanContext, issues: Issue[]): void {
  const { called } = site;
  const first = (site.flat[0] as FlatSegment).from;
  const at = { x: toDiameter(setting.start.r), z: setting.start.z };
  if (l.startRule === "contour" && called.v < first.v - SAME)
    issues.push(issue("startBelowContour", "info", { below: first.v - called.v }, "startV"));
  const inside = reachesIn(l, site, setting) && (l.startRule === "contour" || called.v < site.outer - SAME);
  if (inside) issues.push(issue("startInArea", "warning", at, "start"));
  returnToStart(cutter, start, l, l.operation > 1 ? "finish" : "rough", 0);
}

/** Moves back to the cycle start. */
function returnToStart(cutter: Cutter, start: Flat, l: Leveled, run: "rough" | "finish", step: number): void {
  const p = { phase: "position", run, step } as const;
  cutter.link(start, {
    gap: l.clearance,
    feed: run === "finish" ? l.feeds.finish : l.feeds.rough,
    out: p,
    down: p,
    enter: p,
  });
}

/** A plan without a path, for the given reasons; `contour`: the drawn contour, in machining direction. */
export const emptyPlan = (issues: readonly Issue[], contour: readonly Segment[] = []): Plan => ({
  moves: [],
  issues,
  contour,
  passes: 0,
  infeed: length(0),
  area: [],
  part: [],
  openSide: at(0, 0),
  reach: [],
  oversizeReach: [],
  maxInfeed: length(0),
});
