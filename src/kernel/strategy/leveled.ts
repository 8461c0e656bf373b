import { bridged } from "../bridge.ts";
import { extent } from "../convex.ts";
import { lowest } from "../envelope.ts";
import { lowestOf, segmentToFlat, toFlat, toPart, type Flat, type Frame } from "../flat.ts";
import { isBar, flanksUnknown, noseRadius } from "../insert.ts";
import { issue, type Issue } from "../issue.ts";
import type { Plan, Setting } from "../plan.ts";
import type { Segment } from "../point.ts";
import type { Bound } from "../reach.ts";
import { SAME } from "../tolerance.ts";
import { Track, roomOf } from "../track.ts";
import { axial, length, radius, toDiameter } from "../units.ts";
import type { Feeds } from "./feeds.ts";
import { finishContour } from "./finish.ts";
import { FAR, groundOver, insertIn, leadOf, reachOf, type Surroundings } from "./ground.ts";
import { divide, limitedInfeed } from "./infeed.ts";
import { roughByLevels } from "./levels.ts";
import { areaOver, partUnder } from "./outline-area.ts";

/** A cycle that removes its area by levels and then follows the contour: 81x along the axis, 82x across it. */
export interface Leveled {
  readonly frame: Frame;
  /** In machining direction, part space. */
  readonly contour: readonly Segment[];
  readonly operation: number;
  readonly clearance: number;
  readonly infeed: number;
  readonly feeds: Feeds;
  /** Oversize on the radius and along Z, mm. */
  readonly oversize: { readonly r: number; readonly z: number };
  readonly plunging: boolean;
  readonly smoothing: number;
  /** Machining limits in strategy space; null where there is none. */
  readonly limit: { readonly u: number; readonly v: number } | null;
  /** Height of the outer corner of the area where that is higher than the contour's first point; else null. */
  readonly outerHeight: number | null;
  /** "shoulder": clear of the box first across, then along. "contour": along the tool axis up to the contour start. */
  readonly startRule: "shoulder" | "contour";
}

/** Plans roughing and finishing of a leveled cycle. Never throws; what cannot be planned is an issue. */
export function planLeveled(l: Leveled, setting: Setting): Plan {
  const issues: Issue[] = [];
  const { tool } = setting;
  const flat = l.contour.map((s) => segmentToFlat(l.frame, s));
  const first = flat[0];
  const last = flat[flat.length - 1];
  if (!first || !last) return empty(issues);
  const wrong = wrongSide(tool, l.frame);
  if (wrong) issues.push(wrong);
  if (flanksUnknown(tool)) issues.push(issue("flanksNotChecked", "info", {}, "tool"));
  if (isBar(tool) && tool.TYPE === "RECESS") issues.push(issue("toolCannotCutSideways", "warning", { type: tool.TYPE }, "tool"));

  // Cut from the middle outwards, the part goes on between the first point and the axis.
  const pinInFront = l.frame.transverse && l.frame.signU > 0;
  const bounds: Bound[] = l.plunging ? flat.map((segment) => ({ segment, on: "contour" })) : bridged(flat);
  const floor = Math.min(...flat.map(lowestOf));
  const highest = Math.max(...flat.flatMap((s) => [s.from.v, s.to.v]));
  const bottom = extent(insertIn(tool, l.frame)).minV;
  const outer = Math.max(l.outerHeight ?? first.from.v, first.from.v) - bottom;
  const called = toFlat(l.frame, setting.start);
  const wanted: Track = new Track(l.frame, setting.feedUnit, called);
  if (wrong) return { ...empty(issues), contour: l.contour, part: partUnder(flat, l.frame, pinInFront), area: areaOver(flat, l.frame, called.u, Math.max(called.v, outer)) };

  const start = placed(l, tool, wanted, called, { u: first.from.u, v: first.from.v }, last.to.u, Math.max(highest, outer), floor, issues);
  const top = Math.max(start.v, outer);
  const limits = limitsOf(l, called, issues);
  const wall = top + bottom > last.to.v + SAME ? top + FAR : null;
  const limit = limits.floor === null ? [] : [{ v: limits.floor, on: "limit" as const }];
  const toFinish: Surroundings = { wall: null, front: "free", frontWall: null, floors: limit };
  const keep = l.frame.transverse ? { u: l.oversize.r, v: l.oversize.z } : { u: l.oversize.z, v: l.oversize.r };
  const none = { u: 0, v: 0 };
  const room = roomOf(l.frame);
  const from = Math.max(start.u, limits.from, room.minU);

  const grown = l.operation === 3 || l.smoothing === 1 ? groundOver(bounds, tool, l.frame, keep, toFinish) : null;
  const kept = groundOver(bounds, tool, l.frame, keep, { ...toFinish, wall, floors: [...limit, { v: floor + keep.v, on: "edge" }] });
  const drawn = groundOver(bounds, tool, l.frame, none, toFinish);
  const end = Math.max(kept.end.u, drawn.end.u, last.to.u + keep.u) + SAME;
  const to = Math.min(end, limits.to - leadOf(insertIn(tool, l.frame)), room.maxU);
  const runOut = wall === null ? null : last.to.v + keep.v;
  const unlimited = () => {
    if (!l.limit) return {};
    const whole = groundOver(bounds, tool, l.frame, none, { ...toFinish, floors: [] });
    return { unlimited: reachOf(whole, Math.max(whole.first, start.u, room.minU), Math.min(whole.end.u, end, room.maxU), l.frame, tool) };
  };
  let division = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    const upper = Math.min(top, limits.ceiling);
    const depth = upper - lowest(kept.envelope, from, to);
    division = divide(depth, limitedInfeed(l.infeed, tool, depth, issues));
    if (division.passes === 0) issues.push(issue("nothingToCut", "warning", {}, "start.x"));
    roughByLevels(wanted, { envelope: kept.envelope, start, top: upper, ...division, from, to, smoothing: l.smoothing, feeds: l.feeds });
    if (grown && l.smoothing === 1 && division.passes > 0) {
      back(wanted, start, "rough", 4);
      finishContour(wanted, { ground: grown, contour: flat, start, clearance: l.clearance, roughed: kept.envelope, stepped: true, runOut, kept: division.infeed, aside: division.infeed, feeds: l.feeds, from, to, smoothing: true }, issues);
    }
    back(wanted, start, "rough", 6);
  }
  if (l.operation !== 1) {
    const ground = (l.operation === 3 ? grown : null) ?? drawn;
    const steps = l.smoothing === 2 ? division.infeed : 0;
    finishContour(wanted, { ground, contour: flat, start, clearance: l.clearance, roughed: l.operation === 0 ? kept.envelope : [], stepped: l.smoothing === 2, runOut, kept: keep.v + steps, aside: keep.u + steps, feeds: l.feeds, from, to, smoothing: false }, issues);
    back(wanted, start, "finish", 4);
  }
  return {
    moves: wanted.moves, issues, contour: l.contour, ...division, infeed: length(division.infeed),
    area: areaOver(flat, l.frame, start.u, top), part: partUnder(flat, l.frame, pinInFront),
    openSide: toPart(l.frame, { u: 0, v: 1 }), reach: reachOf(drawn, Math.max(drawn.first, from), Math.min(drawn.end.u, to), l.frame, tool),
    kept: reachOf(kept, Math.max(kept.first, from), Math.min(kept.end.u, to), l.frame, tool), most: length(l.infeed), oversize: l.oversize, ...unlimited(),
  };
}

/** Back to the cycle start at rapid, one axis at a time, first away from the part. */
export function back(track: Track, start: Flat, run: "rough" | "finish", step: number) {
  const p = { phase: "position", run, step } as const;
  if (start.v > track.at.v) track.rapid("v", start.v, p);
  track.rapid("u", start.u, p);
  track.rapid("v", start.v, p);
}

export const empty = (issues: readonly Issue[]): Plan => ({ moves: [], issues, contour: [], passes: 0, infeed: length(0), area: [], part: [], openSide: { z: axial(0), r: radius(0) }, reach: [], kept: [], most: length(0) });

/** The body of the insert lies on the material side: it cannot work here. */
export function wrongSide(tool: Setting["tool"], frame: Frame): Issue | null {
  const e = extent(insertIn(tool, frame));
  return -e.minV > e.maxV + 2 * noseRadius(tool) + SAME ? issue("toolOnWrongSide", "error", { orientation: tool.TO }, "tool") : null;
}

/** The cycle start as the manual places it before step 1: clear of the area, or up to the contour start. */
function placed(l: Leveled, tool: Setting["tool"], track: Track, called: Flat, first: Flat, end: number, height: number, floor: number, issues: Issue[]): Flat {
  const finishing = l.operation > 1;
  const p = { phase: "position", run: finishing ? "finish" : "rough", step: 0 } as const;
  const depth = Math.max(called.v, height) - floor;
  const lead = leadOf(insertIn(tool, l.frame), finishing ? undefined : l.infeed > 0 ? Math.min(l.infeed, depth) : depth);
  const over = called.u + lead > first.u + SAME;
  const at = toPart(l.frame, called);
  const where = { x: toDiameter(at.r), z: at.z };
  if (l.startRule === "contour" && called.v < first.v - SAME) {
    issues.push(issue("startBelowContour", "info", { z: at.z, contour: toPart(l.frame, first).z }, "start.z"));
    track.rapid("v", finishing ? first.v + l.clearance : first.v, p);
  }
  if (over) {
    issues.push(issue(called.u < end ? "startInArea" : "startInMaterial", "warning", where, "start.x"));
    if (!finishing || l.startRule === "contour") track.rapid("v", Math.max(track.at.v, height + l.clearance), p);
    track.rapid("u", first.u - lead - l.clearance, p);
  }
  return track.at;
}

interface Limits {
  readonly from: number;
  readonly to: number;
  readonly floor: number | null;
  readonly ceiling: number;
}

/** The side of each limit on which the tool stands at the call is machined, the other is not cut. */
function limitsOf(l: Leveled, called: Flat, issues: Issue[]): Limits {
  const none = { from: -Infinity, to: Infinity, floor: null, ceiling: Infinity };
  if (!l.limit) return none;
  const before = called.u <= l.limit.u;
  const above = called.v >= l.limit.v;
  const flat = l.contour.map((s) => segmentToFlat(l.frame, s));
  const q = (axis: "u" | "v") => ((axis === "u") === l.frame.transverse ? "Q480" : "Q482");
  const shown = (axis: "u" | "v", value: number) => {
    const p = toPart(l.frame, axis === "u" ? { u: value, v: 0 } : { u: 0, v: value });
    return (axis === "u") === l.frame.transverse ? toDiameter(p.r) : p.z;
  };
  const us = flat.flatMap((s) => [s.from.u, s.to.u]);
  const vs = flat.flatMap((s) => [s.from.v, s.to.v]);
  if (before ? l.limit.u <= Math.min(...us) : l.limit.u >= Math.max(...us))
    issues.push(issue("limitOnWrongSide", "warning", { limit: shown("u", l.limit.u), nearest: shown("u", before ? Math.max(...us) : Math.min(...us)) }, q("u")));
  if (above ? l.limit.v >= Math.max(...vs) : l.limit.v <= Math.min(...vs))
    issues.push(issue("limitOnWrongSide", "warning", { limit: shown("v", l.limit.v), nearest: shown("v", above ? Math.min(...vs) : Math.max(...vs)) }, q("v")));
  return { from: before ? -Infinity : l.limit.u, to: before ? l.limit.u : Infinity, floor: above ? l.limit.v : null, ceiling: above ? Infinity : l.limit.v };
}
