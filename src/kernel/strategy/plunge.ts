import { extent } from "../convex.ts";
import { segmentToFlat, toFlat, toPart, type Flat, type FlatSegment, type Frame } from "../flat.ts";
import { cuttingWidth, isBar, noseRadius } from "../insert.ts";
import { issue, type Issue } from "../issue.ts";
import type { Plan, Setting } from "../plan.ts";
import type { Segment } from "../point.ts";
import type { Bound } from "../reach.ts";
import { JOINED, SAME } from "../tolerance.ts";
import type { Tool, ToolType } from "../tool.ts";
import { roomOf } from "../track.ts";
import { length, toDiameter } from "../units.ts";
import { clearAcross } from "./across.ts";
import { basinsOf, type Basin } from "./basins.ts";
import { unfit } from "./fit.ts";
import { atCall, Frontier } from "./frontier.ts";
import { FAR, groundOver, insertIn, insidePart, reachOf, startInPart, type Ground, type Surroundings } from "./ground.ts";
import { MOST_PASSES } from "./infeed.ts";
import { empty } from "./leveled.ts";
import { limitsOf, type Limits } from "./limits.ts";
import { Cutter } from "./link.ts";
import { areaOver, partUnder } from "./outline-area.ts";
import { bitesOf, roughByPlunges, type Bites, type PlungeCut } from "./plunge-cuts.ts";
import { finishByHalves } from "./plunge-finish.ts";
import { placesIn, reachOfStep, type Places, type Spacing } from "./plunge-places.ts";
import { floorOf } from "./recess.ts";

/** A recess, or a contour with any number of them, cut by plunges side by side. */
export interface Plunging extends PlungeCut {
  readonly frame: Frame;
  /** The finished contour in machining direction, part space; the part goes on beyond both its ends. */
  readonly contour: readonly Segment[];
  readonly operation: number;
  readonly clearance: number;
  readonly finishingFeed: number;
  readonly oversize: { readonly r: number; readonly z: number };
  /** Side step as a share of the width of the edge. */
  readonly overlap: number;
  readonly comb: boolean;
  /** Machining limits in strategy space; null where there are none. */
  readonly limit: Flat | null;
}

/** What can plunge into solid material. */
const PLUNGING: readonly ToolType[] = ["RECESS", "RECTURN", "BUTTON"];

/** A tool without a width, as the point that a picture is drawn for, plunges so many times side by side. */
const NOMINAL = 6;

/** A bar a millionth narrower, so that a groove exactly as wide as it is one: no envelope has a place without any width. */
const slim = (tool: Tool): Tool =>
  isBar(tool) && cuttingWidth(tool) > 0 ? { ...tool, CUTWIDTH: length((tool.CUTWIDTH ?? 0) - 10 * JOINED) } : tool;

/** Everything about the place that the steps of a plan share, in strategy space. */
interface Site {
  readonly flat: readonly FlatSegment[];
  readonly first: Flat;
  readonly last: Flat;
  readonly called: Flat;
  readonly keep: Flat;
  /** Height that cutting begins at: the start point, or the contour where that stands higher. */
  readonly top: number;
  readonly limits: Limits;
}

/** Plans roughing and finishing by plunges. Never throws; what cannot be planned is an issue. */
export function planPlunging(l: Plunging, setting: Setting): Plan {
  const flat = l.contour.map((s) => segmentToFlat(l.frame, s));
  const [first, last] = [flat[0]?.from, flat.at(-1)?.to];
  if (!first || !last) return empty([]);
  const issues: Issue[] = [];
  const called = toFlat(l.frame, setting.start);
  const opening = Math.max(...flat.flatMap((s) => [s.from.v, s.to.v]));
  const top = Math.max(called.v, opening);
  const keep = l.frame.transverse ? { u: l.oversize.r, v: l.oversize.z } : { u: l.oversize.z, v: l.oversize.r };
  const sketch = {
    ...empty([]),
    contour: l.contour,
    part: partUnder(flat, l.frame, true),
    area: areaOver(flat, l.frame, Infinity, top),
    openSide: toPart(l.frame, { u: 0, v: 1 }),
    most: length(l.bite),
    oversize: l.oversize,
  };
  const refused = unfit(setting.tool, l.frame, PLUNGING);
  if (refused) return { ...sketch, issues: [refused] };
  if (called.v < opening - SAME) issues.push(issue("startBelowContour", "info", { below: opening - called.v }, "startV"));

  const tool = slim(setting.tool);
  const site: Site = { flat, first, last, called, keep, top, limits: limitsOf(l.limit, called, flat, issues) };
  const over = surroundingsOf(site, floorOf(tool, opening, flat, issues));
  const bounds: Bound[] = flat.map((segment) => ({ segment, on: "contour" }));
  const kept = groundOver(bounds, tool, l.frame, keep, over(true));
  const drawn = groundOver(bounds, tool, l.frame, { u: 0, v: 0 }, over(false));
  if (insidePart(drawn, called)) {
    const works = toPart(l.frame, { u: (first.u + last.u) / 2, v: opening + l.clearance });
    return { ...sketch, issues: [...issues, startInPart({ x: toDiameter(works.r), z: works.z })] };
  }
  const grown = groundOver(bounds, tool, l.frame, keep, over(false));
  const insert = insertIn(tool, l.frame);
  const area = [{ u: first.u, v: top - FAR }, { u: first.u, v: top }, { u: last.u, v: top }, { u: last.u, v: top - FAR }];
  const stands = atCall({ stock: setting.stock, area, frame: l.frame, insert }, drawn.bare,
    l.operation > 1 ? { grown: grown.bare, infeed: SAME } : null);
  const frontier = new Frontier(stands, insert, site.limits.ceiling);
  const cutter = new Cutter(l.frame, setting.feedUnit, called, roomOf(l.frame), frontier, top + l.clearance);
  cutter.frontier.cameDown(called);
  const start = { u: called.u, v: top };
  const back = (run: "rough" | "finish", step: number) => {
    const p = { phase: "position", run, step } as const;
    cutter.link(start, { gap: l.clearance, feed: run === "rough" ? l.feed : l.finishingFeed, out: p, down: p, enter: p });
  };
  back(l.operation > 1 ? "finish" : "rough", 0);

  const reachable = (g: Ground) => {
    const { minU, maxU } = extent(insert);
    return { from: Math.max(g.start.u, site.limits.from - minU), to: Math.min(g.end.u, site.limits.to - maxU) };
  };
  let cuts: Bites = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    const upper = Math.min(top, site.limits.ceiling);
    const { from, to } = reachable(kept);
    const basins = to > from - SAME ? basinsOf(kept.envelope, { from, to: Math.max(from, to) }, upper) : [];
    const spacing = spacingOf(l, tool, last.u - first.u);
    if (plungesIn(basins, spacing) > MOST_PASSES) return { ...sketch, issues: [...issues, tooClose(basins, spacing)] };
    const places = basins.map((b) => placesIn(b, kept.envelope, spacing));
    const bites = bitesIn(places, upper, l.bite);
    if (bites > MOST_PASSES) return { ...sketch, issues: [...issues, tooShallow(places, upper, bites)] };
    if (bites === 0) issues.push(issue("nothingToCut", "warning", {}, "tool"));
    cuts = roughByPlunges(cutter, { ...l, ground: kept, basins, places, spacing, top: upper });
    back("rough", 6);
  }
  if (l.operation !== 1) {
    const ground = l.operation === 3 ? grown : drawn;
    const { from, to } = reachable(ground);
    const basins = to > from - SAME ? basinsOf(ground.envelope, { from, to: Math.max(from, to) }, Infinity) : [];
    finishByHalves(cutter, { ground, basins, top, clearance: l.clearance, feed: l.finishingFeed });
    back("finish", 8);
  }
  const unlimited = () => {
    if (!l.limit) return {};
    const whole = groundOver(bounds, tool, l.frame, { u: 0, v: 0 },
      surroundingsOf({ ...site, limits: limitsOf(null, called, flat, []) }, null)(false));
    return { unlimited: reachOf(whole, whole.start.u, whole.end.u, l.frame, tool) };
  };
  const { from, to } = reachable(drawn);
  return clearAcross({
    ...sketch,
    moves: cutter.moves,
    issues,
    passes: cuts.passes,
    infeed: length(cuts.infeed),
    reach: reachOf(drawn, from, to, l.frame, tool),
    kept: reachOf(kept, Math.max(kept.start.u, from), Math.min(kept.end.u, to), l.frame, tool),
    ...unlimited(),
  }, setting, l.frame.transverse ? "startU" : "startV");
}

/** What lies beside the contour: the part, and in front of an end that is lower than the start point a wall, when roughing. */
const surroundingsOf = ({ first, last, top, limits }: Site, deepest: number | null) => (walls: boolean): Surroundings => ({
  wall: walls && top > last.v + SAME ? top + FAR : null,
  front: "part",
  frontWall: walls && top > first.v + SAME ? top + FAR : null,
  floors: [
    ...(deepest === null ? [] : [{ v: deepest, on: "cutLength" as const }]),
    ...(limits.floor === null ? [] : [{ v: limits.floor, on: "limit" as const }]),
  ],
});

/** How the plunges of a tool lie side by side over an opening. */
function spacingOf(l: Plunging, tool: Tool, opening: number): Spacing {
  const round = 2 * noseRadius(tool);
  const own = isBar(tool) ? cuttingWidth(tool) : round;
  const width = own > SAME ? own : opening / NOMINAL;
  return { width, level: isBar(tool) ? Math.max(0, own - round) : 0, step: l.overlap * width, comb: l.comb };
}

/** All bites of all plunges. */
const bitesIn = (places: readonly Places[], top: number, bite: number): number =>
  places.flatMap((p) => [...p.full, ...p.webs]).reduce((sum, p) => sum + bitesOf(top - p.v, bite), 0);

const plungesIn = (basins: readonly Basin[], s: Spacing): number => {
  const step = reachOfStep(s);
  return basins.reduce((sum, b) => sum + b.stops.length + (step > 0 ? (b.to - b.from) / step : Infinity), 0);
};

/** More plunges than anybody means: the smallest overlap that makes fewer, as a share of the width. */
function tooClose(basins: readonly Basin[], s: Spacing): Issue {
  const stops = basins.reduce((sum, b) => sum + b.stops.length, 0);
  const wide = basins.reduce((sum, b) => sum + b.to - b.from, 0);
  const nearest = Math.ceil((wide / Math.max(1, MOST_PASSES - stops) / s.width) * 1000) / 1000;
  return issue("tooManyPasses", "error", { passes: Math.ceil(plungesIn(basins, s)), most: MOST_PASSES, nearest }, "overlap");
}

/** More bites than anybody means: the smallest one that makes fewer. */
function tooShallow(places: readonly Places[], top: number, passes: number): Issue {
  const all = places.flatMap((p) => [...p.full, ...p.webs]);
  const deepest = Math.max(...all.map((p) => top - p.v));
  const nearest = Math.ceil((deepest / Math.max(1, Math.floor(MOST_PASSES / all.length))) * 1000) / 1000;
  return issue("tooManyPasses", "error", { passes, most: MOST_PASSES, nearest }, "infeed");
}
