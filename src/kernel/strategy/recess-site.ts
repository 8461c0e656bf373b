import { extent, type Convex } from "../reach/convex.ts";
import { withCuts } from "../reach/cut-envelope.ts";
import type { Interval, Origin } from "../reach/envelope.ts";
import {
  highestOf,
  lowestOf,
  segmentToFlat,
  toFlat,
  toPart,
  type Flat,
  type FlatSegment,
  type Frame,
} from "../geometry/flat.ts";
import { isBar } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { tracedStock, type Plan, type Reach, type PlanContext } from "../plan/plan.ts";
import type { Ring, Segment } from "../geometry/point.ts";
import type { Bound } from "../reach/reach.ts";
import { SAME } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";
import { length } from "../units.ts";
import { envelopeAtCall, Frontier } from "./frontier.ts";
import { FAR, type TipEnvelope, tipEnvelopeOver, reachOf, type Surroundings } from "./tip-envelope.ts";
import { emptyPlan } from "./leveled.ts";
import type { Limits } from "./limits.ts";
import { areaOver, partUnder } from "./outline-area.ts";

/*
 * A contour that a tool plunges into, whether it then continues sideways or retracts: the part continues beyond both
 * its ends.
 */

/** Input of such a machining operation, for all strategies. */
export interface RecessInput {
  readonly frame: Frame;
  /** The finished contour in machining direction, part space. */
  readonly contour: readonly Segment[];
  readonly operation: number;
  readonly oversize: { readonly r: number; readonly z: number };
  /** Machining limits in strategy space; null where there are none. */
  readonly limit: Flat | null;
}

/** Geometry shared by the steps of a plan, in strategy space. */
export interface RecessSite {
  readonly frame: Frame;
  readonly flat: readonly FlatSegment[];
  readonly bounds: readonly Bound[];
  readonly first: Flat;
  readonly last: Flat;
  readonly called: Flat;
  readonly keep: Flat;
  /** Greatest height of the contour. */
  readonly opening: number;
  /** Height at which cutting begins: the start point, or the contour if that is higher. */
  readonly top: number;
}

/** The geometry of a contour; null if it has no elements. `height`: height of an element for this strategy. */
export function siteOf(
  { frame, contour, oversize }: RecessInput,
  { start }: PlanContext,
  height: (s: FlatSegment) => number = highestOf,
): RecessSite | null {
  const flat = contour.map((s) => segmentToFlat(frame, s));
  const [first, last] = [flat[0]?.from, flat.at(-1)?.to];
  if (!first || !last) return null;
  const called = toFlat(frame, start);
  const opening = Math.max(...flat.map(height));
  const keep = frame.transverse ? { u: oversize.r, v: oversize.z } : { u: oversize.z, v: oversize.r };
  const bounds = flat.map((segment): Bound => ({ segment, on: "contour" }));
  return { frame, flat, bounds, first, last, called, keep, opening, top: Math.max(called.v, opening) };
}

/** The plan before the tool is considered. */
export const draftPlan = (
  { contour, frame, oversize }: RecessInput,
  { flat, top }: RecessSite,
  most: number,
): Plan => ({
  ...emptyPlan([]),
  contour,
  part: partUnder(flat, frame, true),
  area: areaOver(flat, frame, Infinity, top),
  openSide: toPart(frame, { u: 0, v: 1 }),
  maxInfeed: length(most),
  oversize,
});

/** Surroundings of the contour: the part, and when roughing a wall in front of an end lower than the start point. */
export const surroundingsOf =
  ({ first, last, top }: RecessSite, limits: Limits, deepest: number | null) =>
  (walls: boolean): Surroundings => ({
    wall: walls && top > last.v + SAME ? top + FAR : null,
    front: "part",
    frontWall: walls && top > first.v + SAME ? top + FAR : null,
    floors: [
      ...(deepest === null ? [] : [{ v: deepest, on: "cutLength" as const }]),
      ...(limits.floor === null ? [] : [{ v: limits.floor, on: "limit" as const }]),
    ],
  });

/** Further input of a frontier: if the stock is unknown, finishing assumes `infeed` above the oversize of `grown`. */
interface FrontierInput {
  readonly drawn: TipEnvelope;
  readonly grown: TipEnvelope;
  readonly infeed: number;
  readonly operation: number;
  readonly ceiling: number;
}

const TOP: Origin = { feature: "nose", on: "edge", corner: false };

/** The stock at the call. */
export function frontierAt(site: RecessSite, setting: PlanContext, insert: Convex, o: FrontierInput): Frontier {
  const { first, last, called, opening, top, frame } = site;
  // Next to an end lower than the rest there may be stock.
  const { minU, maxU } = extent(insert);
  const beside = (end: Flat) => (opening > end.v + SAME ? maxU - minU : 0);
  const [from, to] = [first.u - beside(first), last.u + beside(last)];
  const area = [
    { u: from, v: top - FAR },
    { u: from, v: top },
    { u: to, v: top },
    { u: to, v: top - FAR },
  ];
  // Above the start point there is no stock to cut the recess from.
  const grown = withCuts(
    o.grown.partEnvelope,
    [{ arc: 0, u0: from - FAR, u1: to + FAR, v0: top, slope: 0, origin: TOP }],
    Infinity,
  );
  const roughed = o.operation > 1 ? { grown, infeed: o.infeed, top } : null;
  const stands = envelopeAtCall({ stock: tracedStock(setting), area, frame, insert }, o.drawn.partEnvelope, roughed);
  const frontier = new Frontier(stands, insert, o.ceiling);
  frontier.openColumn(called);
  return frontier;
}

/**
 * Height of the material above a contour: of the stock if known, else of the blank, assumed to be cut down to the
 * contour's height (decision "CUTLENGTH counts in the material").
 */
function stockHeight({ frame, flat, opening }: RecessSite, { stock, blank }: PlanContext): number {
  const us = flat.flatMap((s) => [s.from.u, s.to.u]);
  const span = { from: Math.min(...us), to: Math.max(...us) };
  const high = (rings: readonly Ring[]) =>
    Math.max(
      ...rings.map((ring) =>
        highestIn(
          ring.map((p) => toFlat(frame, p)),
          span,
        ),
      ),
    );
  if (stock) return high(stock);
  return blank && blank.length > 0 ? Math.min(opening, high(blank)) : opening;
}

/** The highest point of an outline within an interval of u; −∞ if it has none there. */
const highestIn = (ring: readonly Flat[], { from, to }: Interval): number =>
  ring.reduce((most, p, i) => {
    const q = ring[(i + 1) % ring.length] as Flat;
    const [a, b] = p.u < q.u ? [p, q] : [q, p];
    if (b.u < from || a.u > to) return most;
    const at = (u: number) => (b.u - a.u > SAME ? a.v + ((u - a.u) / (b.u - a.u)) * (b.v - a.v) : Math.max(a.v, b.v));
    return Math.max(most, at(Math.max(a.u, from)), at(Math.min(b.u, to)));
  }, -Infinity);

/** The deepest level that CUTLENGTH of a bar allows, measured in the material; null if it reaches the floor. */
export function floorOf(tool: Tool, site: RecessSite, setting: PlanContext, issues: Issue[]): number | null {
  const edge = tool.CUTLENGTH;
  if (!isBar(tool) || edge === undefined || !(edge > 0)) return null;
  const stands = stockHeight(site, setting);
  const depth = stands - Math.min(...site.flat.map(lowestOf));
  if (depth <= edge + SAME) return null;
  issues.push(issue("depthOverCutLength", "warning", { depth, cutLength: edge }, "depth"));
  return Math.min(stands - edge, site.top);
}

/** Range of the tip in which neither corner of the edge crosses a machining limit. */
export function tipBetween({ from, to }: Limits, insert: Convex): Interval {
  const { minU, maxU } = extent(insert);
  return { from: from - minU, to: to - maxU };
}

/** The part of an interval that is on the contour. */
export const onContour = ({ start, end }: TipEnvelope, { from, to }: Interval): Interval => ({
  from: Math.max(start.u, from),
  to: Math.min(end.u, to),
});

/** The deepest path over a ground, within this interval. */
export function reachWithin(g: TipEnvelope, places: Interval, frame: Frame, tool: Tool): Reach[] {
  const { from, to } = onContour(g, places);
  return reachOf(g, from, to, frame, tool);
}

/** The same without machining limits, for a plan that has some. */
export function unlimitedReach({ limit, frame }: RecessInput, site: RecessSite, tool: Tool): Pick<Plan, "unlimited"> {
  if (!limit) return {};
  const around = { wall: null, front: "part", frontWall: null, floors: [] } as const;
  const whole = tipEnvelopeOver(site.bounds, tool, frame, { u: 0, v: 0 }, around);
  return { unlimited: reachOf(whole, whole.start.u, whole.end.u, frame, tool) };
}
