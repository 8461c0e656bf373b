import { heightAt, pathAlong } from "../reach/envelope.ts";
import { flat, segmentToFlat, toFlat, toPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { flanksUnknown } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { tracedStock, type Plan, type PlanContext } from "../plan/plan.ts";
import type { Segment } from "../geometry/point.ts";
import type { Bound } from "../reach/reach.ts";
import { SAME } from "../tolerance.ts";
import { roomOf } from "../plan/track.ts";
import { length, toDiameter } from "../units.ts";
import { withAxisCheck } from "./across.ts";
import { beyondAxis } from "./axis.ts";
import type { Feeds } from "./feeds.ts";
import { followContour, type Finish } from "./finish.ts";
import { unfitIssue } from "./fit.ts";
import { envelopeAtCall, Frontier } from "./frontier.ts";
import {
  tipEnvelopeOver,
  insertIn,
  insidePart,
  reachAhead,
  reachOf,
  startInPart,
  type TipEnvelope,
  type Surroundings,
} from "./tip-envelope.ts";
import { limitedInfeed } from "./infeed.ts";
import { oversizeContour } from "./oversize-contour.ts";
import { emptyPlan, TURNING } from "./leveled.ts";
import { renumberedPasses } from "./levels.ts";
import { Cutter } from "./link.ts";
import { areaBetween, partUnder } from "./outline-area.ts";
import { divideAllowance, type Allowance } from "./parallel-infeed.ts";

/** A cycle whose passes run along the contour: the blank is the contour with an allowance, like a casting. */
export interface ContourParallel {
  readonly frame: Frame;
  /** In machining direction, part space. */
  readonly contour: readonly Segment[];
  readonly operation: number;
  readonly clearance: number;
  /** Allowance on the contour, perpendicular to it, mm. */
  readonly allowance: number;
  /**
   * True: every pass removes the same area, so that longer ones are thinner; false: all passes have the same infeed.
   */
  readonly sameArea: boolean;
  readonly infeed: number;
  readonly feeds: Feeds;
  /** Oversize on the radius and along Z, mm. */
  readonly oversize: { readonly r: number; readonly z: number };
}

/** Bounds of a path besides the contour. */
const AROUND: Surroundings = { wall: null, front: "free", frontWall: null, floors: [] };

/** Plans roughing and finishing along a contour. Never throws; what cannot be planned is an issue. */
export function planContourParallel(l: ContourParallel, setting: PlanContext): Plan {
  const { tool } = setting;
  const contour = l.contour.map((s) => segmentToFlat(l.frame, s));
  if (contour.length === 0) return emptyPlan([]);
  const called = toFlat(l.frame, setting.start);
  const sketch = {
    ...emptyPlan([]),
    contour: l.contour,
    part: partUnder(contour, l.frame, false),
    area: areaBetween(contour, oversizeContour(l.contour, l.frame, { r: 0, z: 0, round: l.allowance }), l.frame),
    openSide: toPart(l.frame, { u: 0, v: 1 }),
    isParallel: true,
    maxInfeed: length(l.infeed),
    oversize: l.oversize,
  };
  const insert = insertIn(tool, l.frame);
  const lead = reachAhead(insert);
  const works = workingStart(l, contour, lead);
  const refused = [unfitIssue(tool, l.frame, TURNING), wrongStart(contour, called, setting, works)].filter(
    (i) => i !== null,
  );
  if (refused.length > 0) return { ...sketch, issues: refused };
  const issues: Issue[] = [];
  if (flanksUnknown(tool)) issues.push(issue("flanksNotChecked", "info", {}, "tool"));
  if (tool.TYPE === "RECESS") issues.push(issue("toolCannotCutSideways", "warning", { type: tool.TYPE }, "tool"));

  const bounds = contour.map((segment): Bound => ({ segment, on: "contour" }));
  const keep = l.frame.transverse ? { u: l.oversize.r, v: l.oversize.z } : { u: l.oversize.z, v: l.oversize.r };
  const over = (round: number) => tipEnvelopeOver(bounds, tool, l.frame, { ...keep, round }, AROUND);
  const drawn = tipEnvelopeOver(bounds, tool, l.frame, { u: 0, v: 0 }, AROUND);
  if (insidePart(drawn, called)) return { ...sketch, issues: [...issues, startInPart(works)] };
  const kept = over(0);
  const blank = tipEnvelopeOver(bounds, tool, l.frame, { u: 0, v: 0, round: l.allowance }, AROUND);
  const stands = envelopeAtCall(
    { stock: tracedStock(setting), area: sketch.area.map((p) => toFlat(l.frame, p)), frame: l.frame, insert },
    drawn.partEnvelope,
    l.operation > 1 ? { grown: kept.partEnvelope, infeed: Math.min(l.infeed, l.allowance) } : null,
  );
  const first = (contour[0] as FlatSegment).from;
  const start = startOf(l, called, { u: first.u - lead - l.clearance, behind: first.u }, blank);
  if (start.v > called.v || inAllowance(called, blank))
    issues.push(issue("startInArea", "warning", { x: toDiameter(setting.start.r), z: setting.start.z }, "start"));
  else if (start.u < called.u)
    issues.push(issue("startBehindContour", "info", { behind: called.u - first.u, clearance: l.clearance }, "startU"));
  const room = roomOf(l.frame, beyondAxis(tool, contour, l.frame));
  const cutter = new Cutter(
    l.frame,
    setting.feedUnit,
    called,
    room,
    new Frontier(stands, insert),
    Math.max(called.v, start.v),
  );
  returnToStart(cutter, start, l, l.operation > 1 ? "finish" : "rough", 0);

  const follow = {
    contour,
    start,
    clearance: l.clearance,
    runOut: null,
    feeds: l.feeds,
    from: room.minU,
    to: room.maxU,
    ceiling: room.maxV,
    smoothing: false,
  };
  let passes: readonly number[] = [];
  if (l.operation === 0 || l.operation === 1) {
    const depth = l.allowance - Math.min(keep.u, keep.v);
    const divided = divideAllowance(allowanceOf(l, depth, over), limitedInfeed(l.infeed, tool, depth, issues), issues);
    if (!divided) return { ...sketch, issues };
    passes = divided;
    if (passes.length === 0) issues.push(issue("nothingToCut", "warning", {}, "infeed"));
    roughAlong(cutter, { ...follow, ground: kept, backTo: start.v }, passes, over);
    returnToStart(cutter, start, l, "rough", 6);
  }
  if (l.operation !== 1) {
    followContour(cutter, { ...follow, ground: l.operation === 3 ? kept : drawn }, issues);
    returnToStart(cutter, start, l, "finish", 4);
  }
  return withAxisCheck(
    {
      ...sketch,
      issues,
      // A pass without a path is left out.
      ...renumberedPasses(cutter.moves),
      infeed: length(greatest(passes)),
      reach: reachOf(drawn, drawn.pathStart, drawn.end.u, l.frame, tool),
      oversizeReach: reachOf(kept, kept.pathStart, Math.max(kept.end.u, drawn.end.u), l.frame, tool),
    },
    setting,
    l.frame.transverse ? "startU" : "startV",
  );
}

/**
 * The printed steps 1 to 5 of roughing: infeed, along the contour, back to the start point in X at feed, at rapid to
 * the beginning of the next pass, until the oversize is reached (TNC7, 81762x-17, topic "Cycle 815").
 */
function roughAlong(
  cutter: Cutter,
  follow: Finish,
  passes: readonly number[],
  over: (round: number) => TipEnvelope,
): void {
  let left = passes.reduce((sum, infeed) => sum + infeed, 0);
  passes.forEach((infeed, i) => {
    const last = i === passes.length - 1;
    left = last ? 0 : left - infeed;
    // A pass entirely beyond the axis is left out without an issue.
    followContour(
      cutter,
      { ...follow, ground: last ? follow.ground : over(left), pass: i + 1, clearance: follow.clearance },
      [],
    );
  });
}

/** Input of the division: the allowance, and the length of a pass at its outside and at its inside. */
function allowanceOf(l: ContourParallel, depth: number, over: (round: number) => TipEnvelope): Allowance {
  if (!l.sameArea || !(depth > SAME)) return { depth, outer: 1, inner: 1 };
  const along = ({ envelope, pathStart, end }: TipEnvelope) =>
    pathAlong(envelope, pathStart, end.u).reduce((sum, { segment }) => sum + flat.lengthOf(segment), 0);
  return { depth, outer: along(over(depth)), inner: along(over(0)) };
}

const greatest = (infeeds: readonly number[]) => Math.max(0, ...infeeds);

/** Height of the allowance at a tip position; −∞ in front of it. */
const allowanceAt = (blank: TipEnvelope, u: number) => (u < blank.pathStart ? -Infinity : heightAt(blank.envelope, u));
const inAllowance = ({ u, v }: Flat, blank: TipEnvelope): boolean => v < allowanceAt(blank, u) - SAME;

/**
 * Start position of the cycle: the position at the call; from behind the contour start along Z to the set-up clearance
 * in front of it (as printed, for roughing and finishing alike); then straight up out of the allowance.
 */
function startOf(
  l: ContourParallel,
  called: Flat,
  front: { readonly u: number; readonly behind: number },
  blank: TipEnvelope,
): Flat {
  const at = called.u > front.behind + SAME ? { u: front.u, v: called.v } : called;
  return inAllowance(at, blank) ? { u: at.u, v: allowanceAt(blank, at.u) + l.clearance } : at;
}

/** Refuses a contour that runs towards the start point, and a start on the other side of the axis. */
function wrongStart(
  contour: readonly FlatSegment[],
  called: Flat,
  { start }: PlanContext,
  works: { x: number; z: number },
): Issue | null {
  const last = (contour.at(-1) as FlatSegment).to;
  return called.u > last.u - SAME || start.r < -SAME ? issue("startOnWrongSide", "error", works, "startU") : null;
}

/** A start point that works: in front of the contour and above its allowance, by the clearance. */
function workingStart(l: ContourParallel, contour: readonly FlatSegment[], lead: number): { x: number; z: number } {
  const u = (contour[0] as FlatSegment).from.u - lead - l.clearance;
  const v = Math.max(...contour.map((s) => flat.boxOf(s).high)) + l.allowance + l.clearance;
  const works = toPart(l.frame, { u, v: Math.min(v, roomOf(l.frame).maxV) });
  return { x: toDiameter(works.r), z: works.z };
}

/** Moves back to the cycle start. */
function returnToStart(cutter: Cutter, start: Flat, l: ContourParallel, run: "rough" | "finish", step: number): void {
  const p = { phase: "position", run, step } as const;
  cutter.link(start, {
    gap: l.clearance,
    feed: run === "finish" ? l.feeds.finish : l.feeds.rough,
    out: p,
    down: p,
    enter: p,
  });
}
