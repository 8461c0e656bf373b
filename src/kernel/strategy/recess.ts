import { intervalsBelow } from "../reach/below.ts";
import { lowest, type Interval } from "../reach/envelope.ts";
import { toPart, type Flat } from "../geometry/flat.ts";
import { cuttingWidth, isBar, noseRadius } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import type { Plan, PlanContext } from "../plan/plan.ts";
import { SAME } from "../tolerance.ts";
import type { ToolType } from "../plan/tool.ts";
import { roomOf } from "../plan/track.ts";
import { length, toDiameter } from "../units.ts";
import { withAxisCheck } from "./across.ts";
import { beyondAxis } from "./axis.ts";
import type { Feeds } from "./feeds.ts";
import { unfitIssue } from "./fit.ts";
import { FAR, type TipEnvelope, tipEnvelopeOver, insertIn, insidePart, startInPart } from "./tip-envelope.ts";
import { divide, limitedInfeed, type Division } from "./infeed.ts";
import { emptyPlan } from "./leveled.ts";
import { limitsInPart, limitsOf } from "./limits.ts";
import { Cutter } from "./link.ts";
import { offsetPerPass } from "./offset.ts";
import { finishRecess, type RecessFinish } from "./recess-finish.ts";
import { roughRecess } from "./recess-rough.ts";
import {
  floorOf,
  frontierAt,
  reachWithin,
  siteOf,
  draftPlan,
  surroundingsOf,
  tipBetween,
  unlimitedReach,
  type RecessInput,
} from "./recess-site.ts";
import { RECESS_CLEARANCE } from "./valley.ts";

/**
 * A groove turned by alternately plunging and cutting sideways: its contour runs from the edge where machining starts
 * to the other edge.
 */
export interface Recess extends RecessInput {
  readonly infeed: number;
  readonly feeds: Feeds;
  readonly oneWay: boolean;
  /** Programmed shortening per pass, mm; 0: the control's own 0.1. */
  readonly offset: number;
  /** Walls that the finishing cut takes downwards; "none" finishes in one go. */
  readonly downwards: RecessFinish["downwards"];
  /**
   * True for a programmed contour, which is cut wherever it runs; a groove is cut only where its opening admits the
   * tool.
   */
  readonly free: boolean;
}

/** Tool types that can plunge into solid material. */
const RECESSING: readonly ToolType[] = ["RECTURN", "RECESS", "BUTTON"];

/** Plans roughing and finishing of a recess. Never throws; what cannot be planned is an issue. */
export function planRecess(l: Recess, setting: PlanContext): Plan {
  const { tool } = setting;
  const site = siteOf(l, setting);
  if (!site) return emptyPlan([]);
  const { flat, bounds, first, last, called, keep, opening, top } = site;
  const sketch = draftPlan(l, site, l.infeed);
  const refused = unfitIssue(tool, l.frame, RECESSING);
  if (refused) return { ...sketch, issues: [refused] };
  const issues: Issue[] = [];
  if (tool.TYPE === "RECESS") issues.push(issue("toolCannotCutSideways", "warning", { type: tool.TYPE }, "tool"));
  if (called.v < opening - SAME)
    issues.push(issue("startBelowContour", "info", { below: opening - called.v }, "startV"));

  const span = { from: first.u, to: last.u };
  const limits = limitsOf(l.limit, called, flat, issues);
  const insert = insertIn(tool, l.frame);
  const room = tipBetween(limits, insert);
  const surroundings = surroundingsOf(site, limits, floorOf(tool, site, setting, issues));
  const kept = tipEnvelopeOver(bounds, tool, l.frame, keep, surroundings(true));
  const drawn = tipEnvelopeOver(bounds, tool, l.frame, { u: 0, v: 0 }, surroundings(false));
  if (insidePart(drawn, called)) {
    const works = toPart(l.frame, { u: (span.from + span.to) / 2, v: opening + RECESS_CLEARANCE });
    return { ...sketch, issues: [...issues, startInPart({ x: toDiameter(works.r), z: works.z })] };
  }
  const grown = tipEnvelopeOver(bounds, tool, l.frame, keep, surroundings(false));
  // Next to an end lower than the rest there may be stock: the finishing cut stays between the walls there, as roughing
  // does.
  const low = { first: opening > first.v + SAME, last: opening > last.v + SAME };
  const closed = low.first || low.last;
  const finishedTo = (g: TipEnvelope, by: Flat): { readonly ground: TipEnvelope; readonly area: Interval } => {
    if (!closed) return { ground: g, area: room };
    const around = {
      ...surroundings(false),
      ...(low.last && { wall: top + FAR }),
      ...(low.first && { frontWall: top + FAR }),
    };
    const ground = tipEnvelopeOver(bounds, tool, l.frame, by, around);
    const open = intervalsBelow(ground.envelope, top, span.from - FAR, span.to + FAR);
    const [from, to] = [
      low.first ? (open[0]?.from ?? Infinity) : -Infinity,
      low.last ? (open.at(-1)?.to ?? -Infinity) : Infinity,
    ];
    return { ground, area: { from: Math.max(room.from, from), to: Math.min(room.to, to) } };
  };
  const deepestPath = finishedTo(drawn, { u: 0, v: 0 });
  const frontier = frontierAt(site, setting, insert, {
    drawn,
    grown,
    infeed: l.infeed,
    operation: l.operation,
    ceiling: limits.ceiling,
  });
  const cutter = new Cutter(
    l.frame,
    setting.feedUnit,
    called,
    roomOf(l.frame, beyondAxis(tool, site.flat, l.frame)),
    frontier,
    top,
  );
  const start = { u: called.u, v: top };
  returnToStart(
    cutter,
    start,
    l.operation > 1 ? l.feeds.finish : l.feeds.rough,
    l.operation > 1 ? "finish" : "rough",
    0,
  );

  let division: Division = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    // A tool that fits exactly may be beyond an end within the tolerance.
    const beyond = (apart: number) => (apart > 0 && apart <= SAME ? apart : 0);
    const [left, right] = [span.from - beyond(span.from - kept.start.u), span.to + beyond(kept.end.u - span.to)];
    const deepest = lowest(kept.envelope, Math.max(left, room.from), Math.min(right, room.to));
    const upper = Math.min(top, limits.ceiling);
    const depth = deepest > (l.free ? upper : opening) - SAME ? 0 : upper - deepest;
    const divided = divide(depth, limitedInfeed(l.infeed, tool, depth, issues), issues);
    if (!divided) return { ...sketch, issues };
    division = divided;
    if (division.passes === 0) issues.push(issue("nothingToCut", "warning", {}, "tool"));
    else {
      const usable = Math.max(0, cuttingWidth(tool) - 2 * noseRadius(tool));
      const offset = isBar(tool) ? offsetPerPass(l.offset, division.passes, l.oneWay, usable, issues) : 0;
      const between = {
        from: Math.max(room.from, top > first.v + SAME ? span.from - FAR : kept.start.u),
        to: Math.min(room.to, top > last.v + SAME ? span.to + FAR : kept.end.u),
      };
      roughRecess(cutter, {
        ground: kept,
        area: between,
        top: upper,
        offset,
        ...division,
        oneWay: l.oneWay,
        feeds: l.feeds,
      });
    }
    returnToStart(cutter, start, l.feeds.rough, "rough", 8);
  }
  const enters = l.free || lowest(drawn.envelope, span.from, span.to) < opening - SAME;
  if (l.operation !== 1 && enters) {
    finishRecess(cutter, {
      ...(l.operation === 3 ? finishedTo(grown, keep) : deepestPath),
      top,
      feed: l.feeds.finish,
      downwards: l.downwards,
      apart: keep.u + noseRadius(tool),
      ceiling: limits.ceiling,
    });
    returnToStart(cutter, start, l.feeds.finish, "finish", 7);
  }
  return withAxisCheck(
    {
      ...sketch,
      moves: cutter.moves,
      issues,
      passes: division.passes,
      infeed: length(division.infeed),
      reach: reachWithin(deepestPath.ground, deepestPath.area, l.frame, tool),
      oversizeReach: reachWithin(kept, room, l.frame, tool),
      ...unlimitedReach(l, site, tool),
      ...limitsInPart(l.limit, called, l.frame),
    },
    setting,
    l.frame.transverse ? "startU" : "startV",
  );
}

/** Moves to the cycle start, before and after: the tool was there before, so it comes down at rapid. */
function returnToStart(cutter: Cutter, start: Flat, feed: number, run: "rough" | "finish", step: number): void {
  const p = { phase: "position", run, step } as const;
  cutter.link(start, { gap: 0, feed, out: p, down: p, enter: p });
}
