import { lowest, pathAlong, staysAbove, type Interval } from "../envelope.ts";
import { lowestOf, reversed, segmentToFlat, shifted, toFlat, toPart, type Flat, type FlatSegment, type Frame } from "../flat.ts";
import { cuttingWidth, flanksUnknown, isBar, noseRadius } from "../insert.ts";
import { issue, type Issue } from "../issue.ts";
import type { Plan, Setting } from "../plan.ts";
import type { Segment } from "../point.ts";
import type { Bound } from "../reach.ts";
import { SAME } from "../tolerance.ts";
import { Track, type Purpose } from "../track.ts";
import { length } from "../units.ts";
import type { Feeds } from "./feeds.ts";
import { FAR, groundOver, reachOf, type Ground, type Surroundings } from "./ground.ts";
import { divide, limitedInfeed } from "./infeed.ts";
import { back, empty, wrongSide } from "./leveled.ts";
import { offsetPerPass } from "./offset.ts";
import { areaOver, partUnder } from "./outline-area.ts";
import { finishRecess } from "./recess-finish.ts";
import { containing, deepestIn, RECESS_CLEARANCE } from "./valley.ts";

/** A groove turned by plunging and cutting sideways in turn. */
export interface Recess {
  readonly frame: Frame;
  /** From the edge where machining starts over both walls to the other edge, part space. */
  readonly contour: readonly Segment[];
  readonly operation: number;
  readonly infeed: number;
  readonly feeds: Feeds;
  readonly oversize: { readonly r: number; readonly z: number };
  readonly oneWay: boolean;
  /** Programmed shortening per pass, mm; 0: the control's own 0.1. */
  readonly offset: number;
  /** Shift of the floor in the finishing cut, mm, positive out of the material, and the contour that it makes. */
  readonly depthCompensation: number;
  readonly compensated: readonly Segment[];
  /** A floor with rounded corners is finished in one go. */
  readonly roundedFloor: boolean;
}

/** Plans roughing and finishing of a recess. Never throws; what cannot be planned is an issue. */
export function planRecess(l: Recess, setting: Setting): Plan {
  const issues: Issue[] = [];
  const { tool } = setting;
  const flat = l.contour.map((s) => segmentToFlat(l.frame, s));
  const first = flat[0];
  const last = flat[flat.length - 1];
  if (!first || !last) return empty(issues);
  const called = toFlat(l.frame, setting.start);
  // The floor is meant to come out elsewhere than drawn: what is proved is the contour with that floor.
  const proved = l.operation === 1 ? flat : l.compensated.map((s) => segmentToFlat(l.frame, s));
  const opening = Math.max(first.from.v, last.to.v);
  const top = Math.max(called.v, opening);
  const sketch = { contour: l.contour, part: partUnder(proved, l.frame, true), area: areaOver(proved, l.frame, Infinity, top), openSide: toPart(l.frame, { u: 0, v: 1 }) };
  const wrong = wrongSide(tool, l.frame);
  if (wrong) return { ...empty([wrong]), ...sketch };
  if (flanksUnknown(tool)) issues.push(issue("flanksNotChecked", "info", {}, "tool"));
  if (tool.TYPE !== "RECTURN") issues.push(issue("toolCannotCutSideways", "warning", { type: tool.TYPE }, "tool"));

  const track = new Track(l.frame, setting.feedUnit, called);
  if (called.v < opening - SAME) {
    const at = toPart(l.frame, called);
    issues.push(issue("startBelowContour", "info", { z: at.z, contour: toPart(l.frame, { u: called.u, v: opening }).z }, "start.z"));
    track.rapid("v", opening, { phase: "position", run: l.operation > 1 ? "finish" : "rough", step: 0 });
  }
  const start = track.at;
  const floor = Math.min(...flat.map(lowestOf));
  const deepest = isBar(tool) && tool.CUTLENGTH !== undefined && opening - floor > tool.CUTLENGTH + SAME ? opening - tool.CUTLENGTH : null;
  if (deepest !== null && tool.CUTLENGTH !== undefined) {
    const nearest = toPart(l.frame, { u: 0, v: deepest }).z;
    issues.push(issue("depthOverCutLength", "warning", { depth: opening - floor, cutLength: tool.CUTLENGTH, nearest }, "Q494"));
  }
  const inFront = top > opening + SAME;
  const surroundings = (walls: boolean): Surroundings => ({
    wall: walls && inFront ? top + FAR : null, front: "part", frontWall: walls && inFront ? top + FAR : null,
    floors: deepest === null ? [] : [{ v: deepest, on: "cutLength" }],
  });
  const keep = l.frame.transverse ? { u: l.oversize.r, v: l.oversize.z } : { u: l.oversize.z, v: l.oversize.r };
  const bounds: Bound[] = flat.map((segment) => ({ segment, on: "contour" }));
  const kept = groundOver(bounds, tool, l.frame, keep, surroundings(true));
  const drawn = groundOver(bounds, tool, l.frame, { u: 0, v: 0 }, surroundings(false));
  let division = { passes: 0, infeed: 0 };
  if (l.operation === 0 || l.operation === 1) {
    const depth = top - lowest(kept.envelope, first.from.u, last.to.u);
    division = divide(depth, limitedInfeed(l.infeed, tool, depth, issues));
    if (division.passes === 0 || lowest(kept.envelope, first.from.u, last.to.u) > opening - SAME) {
      division = { passes: 0, infeed: 0 };
      issues.push(issue("nothingToCut", "warning", {}, "tool"));
    } else {
      const usable = Math.max(0, cuttingWidth(tool) - 2 * noseRadius(tool));
      const offset = isBar(tool) ? offsetPerPass(l.offset, division.passes, l.oneWay, usable, issues) : 0;
      rough(track, l, { ground: kept, span: { from: first.from.u, to: last.to.u }, top, inFront, offset, ...division });
    }
    back(track, start, "rough", 8);
  }
  if (l.operation !== 1 && lowest(drawn.envelope, first.from.u, last.to.u) < opening - SAME) {
    const ground = l.operation === 3 ? groundOver(bounds, tool, l.frame, keep, surroundings(false)) : drawn;
    finishRecess(track, {
      ground, top, feed: l.feeds.finish, oneGo: l.roundedFloor, compensation: l.depthCompensation,
      apart: keep.u + noseRadius(tool), span: { from: first.from.u, to: last.to.u },
    });
    back(track, start, "finish", 7);
  }
  return {
    ...sketch, moves: track.moves, issues, passes: division.passes, infeed: length(division.infeed),
    reach: reachOf(drawn, drawn.start.u, drawn.end.u, l.frame, tool),
    kept: reachOf(kept, kept.start.u, kept.end.u, l.frame, tool), most: length(l.infeed), oversize: l.oversize,
  };
}

interface Rough {
  readonly ground: Ground;
  readonly span: Interval;
  readonly top: number;
  readonly inFront: boolean;
  readonly passes: number;
  readonly infeed: number;
  readonly offset: number;
}

/** The printed steps 1 to 7: plunge, cut sideways, plunge …, and at the end one cut along each wall. */
function rough(track: Track, l: Recess, r: Rough) {
  const e = r.ground.envelope;
  const level = (i: number) => r.top - i * r.infeed;
  const centre = deepestIn(e, level(r.passes), r.span);
  const valley = (i: number): Interval => containing(e, level(i), r.span, centre);
  const shortened = { left: 0, right: 0 };
  // The columns that every pass so far has cleared: only there the way out is free.
  const clear = { from: -Infinity, to: Infinity };
  const p = (step: number, pass: number, plunging = false): Purpose => ({ phase: "rough", run: "rough", step, pass, ...(plunging ? { plunging: true as const } : {}) });

  let here = valley(1);
  track.rapid("u", here.from, p(1, 1));
  track.feed({ u: here.from, v: level(1) }, l.feeds.plunge, p(1, 1, true));
  for (let i = 1; i <= r.passes; i++) {
    const side = l.oneWay || i % 2 === 1 ? "right" : "left";
    if (i > 1) shortened[side] += r.offset;
    const end = side === "right" ? Math.max(here.from, here.to - shortened.right) : Math.min(here.to, here.from + shortened.left);
    clear.from = Math.max(clear.from, Math.min(track.at.u, end));
    clear.to = Math.min(clear.to, Math.max(track.at.u, end));
    track.feed({ u: end, v: level(i) }, l.feeds.rough, p(2, i));
    if (i === r.passes) break;
    const next = valley(i + 1);
    if (l.oneWay) {
      track.feed({ u: end, v: level(i) + RECESS_CLEARANCE }, l.feeds.rough, p(4, i));
      track.rapid("u", here.from, p(4, i));
      track.feed({ u: here.from, v: level(i) }, l.feeds.plunge, p(4, i));
      down(track, pathAlong(e, here.from, next.from).map((s) => s.segment), { u: next.from, v: level(i + 1) }, l.feeds.plunge, p(5, i + 1, true));
    } else {
      const wall = side === "right"
        ? pathAlong(e, next.to, here.to).map((s) => shifted(reversed(s.segment), -shortened.right, 0)).reverse()
        : pathAlong(e, here.from, next.from).map((s) => shifted(s.segment, shortened.left, 0));
      const wanted = side === "right" ? next.to - shortened.right : next.from + shortened.left;
      const target = { u: Math.min(Math.max(wanted, next.from), next.to), v: level(i + 1) };
      const fits = Math.abs(target.u - wanted) < SAME && Math.abs(track.at.u - (side === "right" ? here.to - shortened.right : here.from + shortened.left)) < SAME;
      down(track, fits ? wall : [], target, l.feeds.plunge, p(5, i + 1, true));
    }
    here = next;
  }
  wallCuts(track, l, r, here, shortened, clear);
}

/** Along a wall to the next level; without a wall to follow, sideways first and then straight down. */
function down(track: Track, wall: readonly FlatSegment[], target: Flat, feed: number, p: Purpose) {
  if (wall.length === 0) track.feed({ u: target.u, v: track.at.v }, feed, p);
  track.along(wall, () => ({ feed, purpose: p }));
  track.feed(target, feed, p);
}

/** What the shortening left: one plunging cut along each wall down to the floor. */
function wallCuts(track: Track, l: Recess, r: Rough, floor: Interval, shortened: { left: number; right: number }, columns: { from: number; to: number }) {
  const e = r.ground.envelope;
  const p: Purpose = { phase: "rough", run: "rough", step: 7 };
  const cutting: Purpose = { ...p, plunging: true };
  const clear = r.top + RECESS_CLEARANCE;
  const open = containing(e, r.top, { from: r.span.from - FAR, to: r.span.to + FAR }, (floor.from + floor.to) / 2);
  const left = r.inFront ? open.from : Math.max(open.from, r.ground.start.u);
  const right = r.inFront ? open.to : Math.min(open.to, r.ground.end.u);
  const bottom = r.top - r.passes * r.infeed;
  const rise = () => {
    if (track.at.u < columns.from - SAME || track.at.u > columns.to + SAME) track.feed({ u: track.at.u, v: clear }, l.feeds.rough, p);
    track.rapid("v", clear, p);
  };
  const out = (towards: number) => {
    // Away from the wall, but not into what still stands at the other one.
    const free = Math.min(Math.max(towards, columns.from), Math.max(columns.to, track.at.u));
    const d = Math.min(RECESS_CLEARANCE, Math.abs(free - track.at.u));
    const leaning = { u: track.at.u + Math.sign(free - track.at.u) * d, v: bottom + RECESS_CLEARANCE };
    track.feed(staysAbove(e, leaning, track.at) ? leaning : { u: track.at.u, v: bottom + RECESS_CLEARANCE }, l.feeds.rough, p);
    rise();
  };
  track.feed({ u: track.at.u, v: bottom + Math.min(r.infeed, RECESS_CLEARANCE) }, l.feeds.rough, p);
  rise();
  const cut = (begin: number, path: readonly FlatSegment[], end: Flat, along: number, inwards: number) => {
    track.rapid("u", begin, p);
    track.rapid("v", Math.max(r.top, path[0]?.from.v ?? r.top), p);
    track.along(path, () => ({ feed: l.feeds.plunge, purpose: cutting }));
    track.feed(end, l.feeds.plunge, cutting);
    track.feed({ u: along, v: bottom }, l.feeds.rough, p);
    out(inwards);
  };
  columns.from = Math.min(columns.from, floor.from);
  cut(left, pathAlong(e, left, floor.from).map((s) => s.segment), { u: floor.from, v: bottom }, Math.min(floor.to, floor.from + shortened.left), floor.to);
  columns.to = Math.max(columns.to, floor.to);
  cut(right, pathAlong(e, floor.to, right).map((s) => reversed(s.segment)).reverse(), { u: floor.to, v: bottom }, Math.max(floor.from, floor.to - shortened.right), floor.from);
}
