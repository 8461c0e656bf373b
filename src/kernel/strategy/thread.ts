import { extent } from "../reach/convex.ts";
import { segmentToPart, toFlat, toPart, type Flat, type Frame } from "../geometry/flat.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { cutLength, pointAngle, withToothFor } from "../cutter/insert.ts";
import { METRIC, METRIC_ANGLE } from "../contour/metric-thread.ts";
import { depthByAngle } from "../thread/profiles.ts";
import type { Plan, PlanContext } from "../plan/plan.ts";
import { part, type Segment } from "../geometry/point.ts";
import { CHORD, ROUND, SAME } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";
import { roomOf, Track, type Purpose } from "../plan/track.ts";
import {
  angleUnder,
  degrees,
  inDegrees,
  type Length,
  length,
  radians,
  roundedAngle,
  roundedDown,
  toDiameter,
} from "../units.ts";
import { withAxisCheck } from "./across.ts";
import { squareTo, unfitForThread } from "./fit.ts";
import { envelopeAtCall, Frontier } from "./frontier.ts";
import { FAR, insertIn, startInPart } from "./tip-envelope.ts";
import { limitedInfeed } from "./infeed.ts";
import { POINT_TOOL } from "./oversize-contour.ts";
import { emptyPlan } from "./leveled.ts";
import { areaAbove, areaUnder, partBetween } from "./outline-area.ts";
import { depthAlong, heightOn, passAt, risesAt, steepestRise, type ThreadLine } from "./thread-path.ts";
import { threadDepths } from "./thread-infeeds.ts";
import { shortestRunIn } from "./thread-run-in.ts";
import { lowerSide, teeth, tipsOf } from "./thread-profile.ts";
import { stockOverCrestIssues, stockTooHighIssue } from "./thread-stock.ts";

/** A cycle that cuts a thread. Lengths mm, angles degrees. */
export interface Thread {
  readonly frame: Frame;
  /** The nominal line in cutting direction, part space: the crest of an outside thread, the root of an inside one. */
  readonly contour: readonly Segment[];
  readonly inside: boolean;
  /** Travel per spindle revolution. */
  readonly lead: number;
  readonly starts: number;
  /** Perpendicular to the cutting direction; 0 means the depth of the metric profile. */
  readonly depth: number;
  readonly runIn: number;
  readonly overrun: number;
  readonly runOut: number;
  readonly infeed: number;
  readonly flankAngle: number;
  readonly constantDepth: boolean;
  readonly startAngle: number;
  readonly airCuts: number;
  readonly clearance: number;
}

/** Most spindle revolutions in one operation: more are certainly unintended. */
const MOST_TURNS = 100_000;
/**
 * Most revolutions in one cut of each start: every revolution is a tooth of the section, and the time of the polygon
 * engine grows with the square of their number.
 */
const MOST_TEETH = 2_000;
/** The same in a run-out, where each tooth has a height of its own and the engine meets all of them at each height. */
const MOST_RISING = 400;

/** The target thread, independent of its passes. */
interface ThreadTarget extends ThreadLine {
  readonly pitch: number;
}

/**
 * The issue for a depth that was not entered: that of the metric profile is assumed, which an insert with another angle
 * does not have.
 */
function assumedDepthIssue({ inside }: Thread, depth: number, pitch: number, tool: Tool): Issue {
  const factor = inside ? METRIC.inside : METRIC.outside;
  // A tool of another kind makes no thread at all.
  const angle = tool.TYPE === "THREAD" ? pointAngle(tool) : METRIC_ANGLE;
  if (Math.abs(angle - METRIC_ANGLE) < ROUND)
    return issue("depthFromPitch", "info", { depth, pitch, factor }, "threadDepth");
  const right = depthByAngle(angle, pitch, inside);
  return issue(
    "depthOfOtherProfile",
    "warning",
    {
      depth,
      pitch,
      factor,
      angle,
      ...(right?.factor !== undefined && { right: right.factor }),
      ...(right && { nearest: right.depth }),
    },
    "threadDepth",
  );
}

/** The target thread, with all issues that can be found before it is cut; null if its values make none. */
function threadTarget(t: Thread, tool: Tool, issues: Issue[]): ThreadTarget | null {
  if (!(t.lead > 0)) {
    issues.push(issue("pitchZero", "error", {}, "pitch"));
    return null;
  }
  const pitch = t.lead / Math.max(1, t.starts);
  const factor = t.inside ? METRIC.inside : METRIC.outside;
  const depth = t.depth > 0 ? t.depth : pitch * factor;
  if (!(t.depth > 0)) issues.push(assumedDepthIssue(t, depth, pitch, tool));
  const crest = part
    .flattenedChain(t.contour, CHORD)
    .map((p) => toFlat(t.frame, p))
    .map(({ u, v }) => ({
      u,
      v: t.inside ? v + depth : v,
    }));
  const [first, last] = [crest[0], crest.at(-1)];
  if (!first || !last || crest.slice(1).some((p, i) => p.u - (crest[i] as Flat).u < SAME)) {
    issues.push(issue("threadTurnsBack", "error", { axis: t.frame.transverse ? "X" : "Z" }, "contour"));
    return null;
  }
  const size = last.u - first.u;
  if (t.runOut > size + ROUND) {
    issues.push(issue("runOutTooLong", "error", { size: t.runOut, max: size, nearest: roundedDown(size) }, "runOut"));
    return null;
  }
  const room = roomOf(t.frame);
  return {
    crest,
    pitch,
    depth,
    runIn: Math.min(t.runIn, first.u - room.minU),
    overrun: Math.min(t.overrun, room.maxU - last.u),
    runOut: t.runOut,
  };
}

/** The insert of a thread tool, or for pictures one with the flanks of the metric profile. */
const insertFor = (tool: Tool, frame: Frame): Tool =>
  tool === POINT_TOOL ? { ...POINT_TOOL, TYPE: "THREAD", TO: squareTo(frame) } : tool;

/** Issues of a tool that does not fit the thread. */
function toolIssues(t: Thread, w: ThreadTarget, tool: Tool): Issue[] {
  const unfit = unfitForThread(tool, t.frame);
  if (unfit) return [unfit];
  const half = pointAngle(tool) / 2;
  const found: Issue[] = [];
  if (t.flankAngle > half + ROUND)
    found.push(
      issue(
        "flankInfeedTooSteep",
        "error",
        {
          angle: t.flankAngle,
          most: half,
          nearest: roundedAngle(half) <= half ? roundedAngle(half) : angleUnder(half),
        },
        "infeedAngle",
      ),
    );
  const high = extent(insertIn(tool, t.frame)).maxV;
  const depth = depthAlong(w, half);
  if (depth === Infinity) {
    const angle = roundedAngle(inDegrees(Math.atan(steepestRise(w))));
    found.push(issue("threadTooSteep", "error", { angle, most: roundedAngle(90 - half) }, "crest"));
  } else if (depth > high + SAME) found.push(issue("threadOverInsert", "error", { depth, most: high }, "threadDepth"));
  return found;
}

/** Plans the passes of a thread. Never throws; what cannot be planned is an issue. */
export function planThread(t: Thread, setting: PlanContext): Plan {
  const issues: Issue[] = [];
  const called = insertFor(setting.tool, t.frame);
  const w = threadTarget(t, called, issues);
  if (!w) return emptyPlan(issues, t.contour);
  const needed = depthAlong(w, pointAngle(called) / 2);
  const tool = withToothFor(Number.isFinite(needed) ? needed : w.depth, called);
  const refused = toolIssues(t, w, tool);
  if (setting.tool !== POINT_TOOL && refused.length === 0 && cutLength(called) === undefined)
    issues.push(issue("toothAssumed", "info", { height: extent(insertIn(tool, t.frame)).maxV }, "tool"));
  const most = limitedInfeed(t.infeed, tool, w.depth, issues);
  const depths = threadDepths(w.depth, most, t.constantDepth, issues);
  const deepest = passAt(w, w.depth, 0);
  const [begins, ends] = [deepest[0] as Flat, deepest.at(-1) as Flat];
  const cuts = Math.max(1, t.starts) * ((depths?.length ?? 0) + t.airCuts);
  const turns = Math.max(1, (ends.u - begins.u) / t.lead) * cuts;
  const inOneCut = (ends.u - begins.u) / w.pitch;
  const bounds = [
    { turns: inOneCut, most: MOST_TEETH, at: "pitch" },
    { turns: w.runOut / w.pitch, most: MOST_RISING, at: "runOut" },
    { turns, most: MOST_TURNS, at: "pitch" },
  ] as const;
  const exceeded = bounds.find((b) => b.turns > b.most);
  if (exceeded)
    refused.push(
      issue("threadTooMany", "error", { turns: Math.round(exceeded.turns), most: exceeded.most }, exceeded.at),
    );
  if (!depths || refused.length > 0) return { ...emptyPlan([...refused, ...issues], t.contour) };
  const side = lowerSide(tool, t.frame);
  const slope = Math.tan(radians(t.flankAngle));
  const phase = ((((-t.startAngle * t.starts) / 360) % 1) + 1) % 1;
  const passes = depths.map((d) => passAt(w, d, slope));
  // Where the last pass rises along a run-out, an earlier one set back along the flank leaves its groove.
  const rising = passes.slice(0, -1).flatMap((pass, i) => {
    const back = (w.depth - (depths[i] as number)) * slope;
    return back > 0 ? tipsOf(pass, w.pitch, phase).filter(({ u }) => u + back > risesAt(w)) : [];
  });
  const tips = [...tipsOf(deepest, w.pitch, phase), ...rising];
  const contour = teeth(w, tips, side);
  const sketch: Plan = {
    ...emptyPlan([]),
    ...(tool !== setting.tool && setting.tool !== POINT_TOOL && { tool }),
    contour: contour.map((s) => segmentToPart(t.frame, s)),
    part: partBetween(contour, t.frame),
    area: areaUnder(contour, w.crest, t.frame),
    openSide: toPart(t.frame, { u: 0, v: 1 }),
    maxInfeed: length(t.infeed),
    thread: {
      pitch: length(w.pitch),
      lead: length(t.lead),
      starts: t.starts,
      depths: depths as Length[],
      slope,
      out: toPart(t.frame, { u: -slope, v: 1 }),
      above: areaAbove(w.crest, t.frame),
      crest: w.crest.map((p) => toPart(t.frame, p)),
      end: toPart(t.frame, ends),
      runIn: length(t.runIn),
      side,
    },
  };
  const way = rapidHeights(t, w, { tool, setting, deepest, depths, slope });
  if ("code" in way) return { ...sketch, issues: [...issues, way] };
  issues.push(...stockOverCrestIssues(w, t.frame, setting.stock, { from: (deepest[0] as Flat).u, to: ends.u }));
  const reach = tips
    .map((p) => toPart(t.frame, p))
    .map((at) => ({ path: { kind: "line", from: at, to: at } as const, reason: null }));
  return withAxisCheck(
    {
      ...sketch,
      moves: movesOf(t, setting, way, passes),
      issues,
      passes: depths.length,
      infeed: length(depths[0] as number),
      reach,
      oversizeReach: reach,
    },
    setting,
    "startV",
  );
}

interface Passes {
  readonly deepest: readonly Flat[];
  readonly depths: readonly number[];
  readonly slope: number;
}

/** Heights of the moves across: from the start point and back, and from pass to pass. */
interface RapidHeights {
  readonly start: Flat;
  readonly link: number;
  readonly over: number;
}

/** Heights at which rapids are free; the issue if there are none. */
function rapidHeights(
  t: Thread,
  w: ThreadTarget,
  { tool, setting, deepest, depths, slope }: Passes & { tool: Tool; setting: PlanContext },
): RapidHeights | Issue {
  const { frame } = t;
  const insert = insertIn(tool, frame);
  const start = toFlat(frame, setting.start);
  const [first, last] = [w.crest[0] as Flat, w.crest.at(-1) as Flat];
  const top = Math.max(...w.crest.map((p) => p.v));
  const corner = (u: number, v: number): Flat => ({ u, v });
  const area = [corner(first.u, top - FAR), ...w.crest, corner(last.u, top - FAR)];
  const frontier = new Frontier(envelopeAtCall({ stock: setting.stock, area, frame, insert }, [], null), insert);
  const [begins, ends] = [deepest[0] as Flat, deepest.at(-1) as Flat];
  const back = (w.depth - (depths[0] as number)) * slope;
  const stands = Math.max(
    top,
    heightOn(w.crest, begins.u),
    heightOn(w.crest, ends.u),
    frontier.over(begins.u - back - SAME, ends.u + SAME),
  );
  // Inside, the back of the insert keeps clear of the wall on the other side of the axis.
  const ceiling = t.inside && !frame.transverse ? Math.min(0, -top - extent(insert).maxV) : Infinity;
  const raised = (height: number) => Math.max(height, Math.min(height + t.clearance, ceiling));
  const over = raised(stands);
  const link = Math.max(
    over,
    start.v,
    raisedOver(frontier.over(start.u, begins.u - back)),
    raisedOver(frontier.over(ends.u, start.u)),
  );
  function raisedOver(height: number) {
    return height > stands ? raised(height) : -Infinity;
  }
  const isFree = (runIn: number) =>
    depths.every((d) => {
      const [missing, u] = [w.depth - d, first.u - runIn];
      return frontier.freeFrom(u - missing * slope) <= heightOn(w.crest, u) - d + SAME;
    });
  if (!isFree(w.runIn)) {
    const at = toPart(frame, begins);
    const nearest = shortestRunIn(isFree, w.runIn, t.lead);
    return issue(
      "runInBlocked",
      "error",
      { x: toDiameter(at.r), z: at.z, ...(nearest !== null && { nearest }) },
      "runIn",
    );
  }
  const blocked = stockTooHighIssue(w, frame, insert, setting.stock, { from: begins.u - back, to: ends.u });
  if (blocked) return blocked;
  if (frontier.freeFrom(start.u) > start.v + SAME) {
    const works = toPart(frame, { u: begins.u, v: over });
    return startInPart({ x: toDiameter(works.r), z: works.z });
  }
  return { start, link, over };
}

/** The moves of all starts, in the steps of the manual. */
function movesOf(
  t: Thread,
  setting: PlanContext,
  way: RapidHeights,
  passes: readonly (readonly Flat[])[],
): Plan["moves"] {
  const track = new Track(t.frame, setting.feedUnit, way.start, roomOf(t.frame));
  const axis = t.frame.transverse ? "r" : "z";
  const at = (step: number, pass?: number): Purpose => ({
    phase: pass === undefined ? "position" : "thread",
    run: "rough",
    step,
    ...(pass !== undefined && { pass }),
  });
  const cut = (points: readonly Flat[], angle: number, purpose: Purpose) => {
    const first = points[0] as Flat;
    points.slice(1).forEach((p, i) => {
      const turned = ((points[i] as Flat).u - first.u) / t.lead;
      const locked = {
        pitch: length(t.lead),
        axis,
        angle: degrees((angle + 360 * turned) % 360),
        stops: i === points.length - 2,
      } as const;
      track.thread(p, locked, purpose);
    });
  };
  const starts = Math.max(1, t.starts);
  for (let start = 0; start < starts; start += 1) {
    const angle = (t.startAngle + (360 * start) / starts) % 360;
    for (let pass = 1; pass <= passes.length + t.airCuts; pass += 1) {
      const points = passes[Math.min(pass, passes.length) - 1] as readonly Flat[];
      const air = pass > passes.length;
      const going = at(pass > 1 ? (air ? 6 : 4) : start > 0 ? 7 : 1);
      if (start === 0 && pass === 1) track.rapid("v", way.link, going);
      const first = points[0] as Flat;
      track.rapid("u", first.u, going);
      track.rapid("v", first.v, going);
      cut(points, angle, at(air ? 6 : 2, pass));
      track.rapid("v", way.over, at(air ? 6 : 3));
    }
  }
  track.rapid("v", way.link, at(8));
  track.rapid("u", way.start.u, at(8));
  track.rapid("v", way.start.v, at(8));
  return track.moves;
}
