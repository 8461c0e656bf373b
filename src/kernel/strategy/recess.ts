import { lowest } from "../envelope.ts";
import { lowestOf, segmentToFlat, toFlat, toPart, type Flat, type FlatSegment, type Frame } from "../flat.ts";
import { cuttingWidth, isBar, noseRadius } from "../insert.ts";
import { issue, type Issue } from "../issue.ts";
import type { Plan, Setting } from "../plan.ts";
import type { Segment } from "../point.ts";
import type { Bound } from "../reach.ts";
import { SAME } from "../tolerance.ts";
import type { Tool, ToolType } from "../tool.ts";
import { roomOf } from "../track.ts";
import { length, toDiameter } from "../units.ts";
import { clearAcross } from "./across.ts";
import type { Feeds } from "./feeds.ts";
import { unfit } from "./fit.ts";
import { atCall, Frontier } from "./frontier.ts";
import { FAR, groundOver, insertIn, insidePart, reachOf, startInPart, type Surroundings } from "./ground.ts";
import { divide, limitedInfeed, type Division } from "./infeed.ts";
import { empty } from "./leveled.ts";
import { Cutter } from "./link.ts";
import { offsetPerPass } from "./offset.ts";
import { areaOver, partUnder } from "./outline-area.ts";
import { finishRecess } from "./recess-finish.ts";
import { roughRecess } from "./recess-rough.ts";
import { RECESS_CLEARANCE } from "./valley.ts";

/** A groove turned by plunging and cutting sideways in turn. */
export interface Recess {
  readonly frame: Frame;
  /** The finished groove from the edge where machining starts over both walls to the other edge, part space. */
  readonly contour: readonly Segment[];
  readonly operation: number;
  readonly infeed: number;
  readonly feeds: Feeds;
  readonly oversize: { readonly r: number; readonly z: number };
  readonly oneWay: boolean;
  /** Programmed shortening per pass, mm; 0: the control's own 0.1. */
  readonly offset: number;
  /** A floor with rounded corners is finished in one go. */
  readonly roundedFloor: boolean;
}

/** What can plunge into solid material. */
const RECESSING: readonly ToolType[] = ["RECTURN", "RECESS", "BUTTON"];

/** Plans roughing and finishing of a recess. Never throws; what cannot be planned is an issue. */
export function planRecess(l: Recess, setting: Setting): Plan {
  const { tool } = setting;
  const flat = l.contour.map((s) => segmentToFlat(l.frame, s));
  const [first, last] = [flat[0], flat[flat.length - 1]];
  if (!first || !last) return empty([]);
  const called = toFlat(l.frame, setting.start);
  const opening = Math.max(first.from.v, last.to.v);
  const top = Math.max(called.v, opening);
  const sketch = {
    ...empty([]),
    contour: l.contour,
    part: partUnder(flat, l.frame, true),
    area: areaOver(flat, l.frame, Infinity, top),
    openSide: toPart(l.frame, { u: 0, v: 1 }),
    most: length(l.infeed),
    oversize: l.oversize,
  };
  const refused = unfit(tool, l.frame, RECESSING);
  if (refused) return { ...sketch, issues: [refused] };
  const issues: Issue[] = [];
  if (tool.TYPE === "RECESS") issues.push(issue("toolCannotCutSideways", "warning", { type: tool.TYPE }, "tool"));
  if (called.v < opening - SAME) issues.push(issue("startBelowContour", "info", { below: opening - called.v }, "startV"));

  const span = { from: first.from.u, to: last.to.u };
  const inFront = top > opening + SAME;
  const surroundings = surroundingsOf(top, inFront, floorOf(tool, opening, flat, issues));
  const keep = l.frame.transverse ? { u: l.oversize.r, v: l.oversize.z } : { u: l.oversize.z, v: l.oversize.r };
  const bounds: Bound[] = flat.map((segment) => ({ segment, on: "contour" }));
  const kept = groundOver(bounds, tool, l.frame, keep, surroundings(true));
  const drawn = groundOver(bounds, tool, l.frame, { u: 0, v: 0 }, surroundings(false));
  if (insidePart(drawn, called)) {
    const works = toPart(l.frame, { u: (span.from + span.to) / 2, v: opening + RECESS_CLEARANCE });
    return { ...sketch, issues: [...issues, startInPart({ x: toDiameter(works.r), z: works.z })] };
  }
  const grown = groundOver(bounds, tool, l.frame, keep, surroundings(false));
  const insert = insertIn(tool, l.frame);
  const area = [{ u: span.from, v: top - FAR }, { u: span.from, v: top }, { u: span.to, v: top }, { u: span.to, v: top - FAR }];
  const stands = atCall({ stock: setting.stock, area, frame: l.frame, insert }, drawn.bare,
    l.operation > 1 ? { grown: grown.bare, infeed: l.infeed } : null);
  const cutter = new Cutter(l.frame, setting.feedUnit, called, roomOf(l.frame), new Frontier(stands, insert), top + RECESS_CLEARANCE);
  const start = { u: called.u, v: top };
  back(cutter, start, l.operation > 1 ? l.feeds.finish : l.feeds.rough, l.operation > 1 ? "finish" : "rough", 0);

  let division: Division = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    const deepest = lowest(kept.envelope, span.from, span.to);
    const depth = deepest > opening - SAME ? 0 : top - deepest;
    const divided = divide(depth, limitedInfeed(l.infeed, tool, depth, issues), issues);
    if (!divided) return { ...sketch, issues };
    division = divided;
    if (division.passes === 0) issues.push(issue("nothingToCut", "warning", {}, "tool"));
    else {
      const usable = Math.max(0, cuttingWidth(tool) - 2 * noseRadius(tool));
      const offset = isBar(tool) ? offsetPerPass(l.offset, division.passes, l.oneWay, usable, issues) : 0;
      roughRecess(cutter, { ground: kept, span, top, inFront, offset, ...division, oneWay: l.oneWay, feeds: l.feeds });
    }
    back(cutter, start, l.feeds.rough, "rough", 8);
  }
  if (l.operation !== 1 && lowest(drawn.envelope, span.from, span.to) < opening - SAME) {
    finishRecess(cutter, {
      ground: l.operation === 3 ? grown : drawn,
      top,
      feed: l.feeds.finish,
      oneGo: l.roundedFloor,
      apart: keep.u + noseRadius(tool),
      span,
    });
    back(cutter, start, l.feeds.finish, "finish", 7);
  }
  return clearAcross({
    ...sketch,
    moves: cutter.moves,
    issues,
    passes: division.passes,
    infeed: length(division.infeed),
    reach: reachOf(drawn, drawn.start.u, drawn.end.u, l.frame, tool),
    kept: reachOf(kept, kept.start.u, kept.end.u, l.frame, tool),
  }, setting, l.frame.transverse ? "startU" : "startV");
}

/** The level that CUTLENGTH of a bar ends at; null when it reaches the floor. */
export function floorOf(tool: Tool, opening: number, flat: readonly FlatSegment[], issues: Issue[]): number | null {
  const edge = tool.CUTLENGTH;
  const depth = opening - Math.min(...flat.map(lowestOf));
  if (!isBar(tool) || edge === undefined || !(edge > 0) || depth <= edge + SAME) return null;
  issues.push(issue("depthOverCutLength", "warning", { depth, cutLength: edge, nearest: opening - edge }, "depth"));
  return opening - edge;
}

/** What lies beside the recess: the part, and in front of the opening walls as wide as it, when roughing. */
const surroundingsOf = (top: number, inFront: boolean, deepest: number | null) => (walls: boolean): Surroundings => ({
  wall: walls && inFront ? top + FAR : null,
  front: "part",
  frontWall: walls && inFront ? top + FAR : null,
  floors: deepest === null ? [] : [{ v: deepest, on: "cutLength" }],
});

/** To the cycle start, before and after. */
function back(cutter: Cutter, start: Flat, feed: number, run: "rough" | "finish", step: number): void {
  const p = { phase: "position", run, step } as const;
  cutter.link(start, { gap: RECESS_CLEARANCE, feed, out: p, down: p, enter: p });
}
