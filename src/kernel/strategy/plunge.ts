import { toPart } from "../geometry/flat.ts";
import { cuttingWidth, isBar, noseRadius } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import type { Plan, PlanContext } from "../plan/plan.ts";
import { SAME } from "../tolerance.ts";
import type { Tool, ToolType } from "../plan/tool.ts";
import { roomOf } from "../plan/track.ts";
import { length, toDiameter } from "../units.ts";
import { withAxisCheck } from "./across.ts";
import { beyondAxis } from "./axis.ts";
import { basinsOf, type Basin } from "./basins.ts";
import { unfitIssue } from "./fit.ts";
import { tipEnvelopeOver, insertIn, insidePart, startInPart } from "./tip-envelope.ts";
import { MOST_PASSES } from "./infeed.ts";
import { emptyPlan } from "./leveled.ts";
import { limitsInPart, limitsOf } from "./limits.ts";
import { Cutter } from "./link.ts";
import { bitesOf, roughByPlunges, type Bites, type PlungeCut } from "./plunge-cuts.ts";
import { finishByHalves } from "./plunge-finish.ts";
import { placesIn, reachOfStep, type Places, type Spacing } from "./plunge-places.ts";
import {
  floorOf,
  frontierAt,
  onContour,
  reachWithin,
  siteOf,
  draftPlan,
  surroundingsOf,
  tipBetween,
  unlimitedReach,
  type RecessInput,
} from "./recess-site.ts";

/** A recess, or a contour with any number of them, cut by plunges side by side. */
export interface Plunging extends PlungeCut, RecessInput {
  readonly clearance: number;
  readonly finishingFeed: number;
  /** Side step as a share of the width of the edge. */
  readonly overlap: number;
  readonly comb: boolean;
}

/** Tool types that can plunge into solid material. */
const PLUNGING: readonly ToolType[] = ["RECESS", "RECTURN", "BUTTON"];

/** Number of plunges side by side for a tool without a width, such as the point that pictures use. */
const NOMINAL = 6;

/** Plans roughing and finishing by plunges. Never throws; what cannot be planned is an issue. */
export function planPlunging(l: Plunging, setting: PlanContext): Plan {
  const { tool } = setting;
  // A hill between two recesses is skipped: no plunge begins that high.
  const site = siteOf(l, setting, (s) => Math.max(s.from.v, s.to.v));
  if (!site) return emptyPlan([]);
  const { bounds, first, last, called, keep, opening, top } = site;
  const issues: Issue[] = [];
  const sketch = draftPlan(l, site, l.bite);
  const refused = unfitIssue(tool, l.frame, PLUNGING);
  if (refused) return { ...sketch, issues: [refused] };
  if (called.v < opening - SAME)
    issues.push(issue("startBelowContour", "info", { below: opening - called.v }, "startV"));

  const limits = limitsOf(l.limit, called, site.flat, issues);
  const over = surroundingsOf(site, limits, floorOf(tool, site, setting, issues));
  const kept = tipEnvelopeOver(bounds, tool, l.frame, keep, over(true));
  const drawn = tipEnvelopeOver(bounds, tool, l.frame, { u: 0, v: 0 }, over(false));
  if (insidePart(drawn, called)) {
    const works = toPart(l.frame, { u: (first.u + last.u) / 2, v: opening + l.clearance });
    return { ...sketch, issues: [...issues, startInPart({ x: toDiameter(works.r), z: works.z })] };
  }
  const grown = tipEnvelopeOver(bounds, tool, l.frame, keep, over(false));
  const insert = insertIn(tool, l.frame);
  const frontier = frontierAt(site, setting, insert, {
    drawn,
    grown,
    infeed: SAME,
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
  // The tool was there before, so it comes down at rapid.
  const back = (run: "rough" | "finish", step: number) => {
    const p = { phase: "position", run, step } as const;
    cutter.link(start, { gap: 0, feed: run === "rough" ? l.feed : l.finishingFeed, out: p, down: p, enter: p });
  };
  back(l.operation > 1 ? "finish" : "rough", 0);

  const room = tipBetween(limits, insert);
  let cuts: Bites = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    const upper = Math.min(top, limits.ceiling);
    const { from, to } = onContour(kept, room);
    const basins = to > from - SAME ? basinsOf(kept.envelope, { from, to: Math.max(from, to) }, upper) : [];
    const spacing = spacingOf(l, tool, last.u - first.u);
    if (plungesIn(basins, spacing) > MOST_PASSES) return { ...sketch, issues: [...issues, tooClose(basins, spacing)] };
    const places = basins.map((b) => placesIn(b, kept.envelope, spacing));
    const bites = bitesIn(places, upper, l.bite);
    if (bites > MOST_PASSES) return { ...sketch, issues: [...issues, tooShallow(places, upper, bites)] };
    if (bites === 0) issues.push(issue("nothingToCut", "warning", {}, "tool"));
    cuts = roughByPlunges(cutter, { ...l, ground: kept, basins, places, spacing, room, top: upper });
    back("rough", 6);
  }
  if (l.operation !== 1) {
    const ground = l.operation === 3 ? grown : drawn;
    const { from, to } = onContour(ground, room);
    const basins = to > from - SAME ? basinsOf(ground.envelope, { from, to: Math.max(from, to) }, Infinity) : [];
    finishByHalves(cutter, { ground, basins, top, clearance: l.clearance, feed: l.finishingFeed });
    back("finish", 8);
  }
  return withAxisCheck(
    {
      ...sketch,
      moves: cutter.moves,
      issues,
      passes: cuts.passes,
      infeed: length(cuts.infeed),
      reach: reachWithin(drawn, room, l.frame, tool),
      oversizeReach: reachWithin(kept, onContour(drawn, room), l.frame, tool),
      ...unlimitedReach(l, site, tool),
      ...limitsInPart(l.limit, called, l.frame),
    },
    setting,
    l.frame.transverse ? "startU" : "startV",
  );
}

/** Spacing of a tool's plunges over an opening. */
function spacingOf(l: Plunging, tool: Tool, opening: number): Spacing {
  const round = 2 * noseRadius(tool);
  const own = isBar(tool) ? cuttingWidth(tool) : round;
  const width = own > SAME ? own : opening / NOMINAL;
  return { width, level: isBar(tool) ? Math.max(0, own - round) : 0, step: l.overlap * width, comb: l.comb };
}

/** Total number of bites of all plunges. */
const bitesIn = (places: readonly Places[], top: number, bite: number): number =>
  places.flatMap((p) => [...p.full, ...p.webs]).reduce((sum, p) => sum + bitesOf(top - p.v, bite), 0);

const plungesIn = (basins: readonly Basin[], s: Spacing): number => {
  const step = reachOfStep(s);
  return basins.reduce((sum, b) => sum + b.stops.length + (step > 0 ? (b.to - b.from) / step : Infinity), 0);
};

/** The issue for too many plunges, with the smallest overlap that makes fewer, as a share of the width. */
function tooClose(basins: readonly Basin[], s: Spacing): Issue {
  const stops = basins.reduce((sum, b) => sum + b.stops.length, 0);
  const wide = basins.reduce((sum, b) => sum + b.to - b.from, 0);
  const nearest = Math.ceil((wide / Math.max(1, MOST_PASSES - stops) / s.width) * 1000) / 1000;
  return issue(
    "tooManyPasses",
    "error",
    { passes: Math.ceil(plungesIn(basins, s)), most: MOST_PASSES, nearest },
    "overlap",
  );
}

/** The issue for too many bites, with the smallest bite that makes fewer. */
function tooShallow(places: readonly Places[], top: number, passes: number): Issue {
  const all = places.flatMap((p) => [...p.full, ...p.webs]);
  const deepest = Math.max(...all.map((p) => top - p.v));
  const nearest = Math.ceil((deepest / Math.max(1, Math.floor(MOST_PASSES / all.length))) * 1000) / 1000;
  return issue("tooManyPasses", "error", { passes, most: MOST_PASSES, nearest }, "infeed");
}
