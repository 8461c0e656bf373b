import type { Cycle } from "../../cycles/define.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { isInside } from "../../kernel/area/clip.ts";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { cuttingWidth, isBar, noseRadius, tipDirection, tipOffset } from "../../kernel/cutter/insert.ts";
import { at, part as geometry, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Move } from "../../kernel/plan/move.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { diameter, radius, radiusOf, toDiameter } from "../../kernel/units.ts";
import type { SetJob } from "../../program/job/job.ts";
import { jobFor, withValue } from "../../program/job/requested-job.ts";
import { cylinderAround } from "../../program/job/requested-shape.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import type { HeldBar } from "../../report/advice/stability.ts";
import { outlinesOf } from "../../sim/outlines.ts";
import { needsBoreBehind } from "../../sim/tool-limits.ts";
import type { OpenRegion } from "../open-regions.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Action, ActionKind, PlanRequest } from "../types.ts";
import { barDiameter } from "../values/cutting-values.ts";
import { leastDepth } from "../values/turning-values.ts";
import { clearRadius } from "./bore.ts";
import { BESIDE, contourUpTo, freeInside, withinRear, type BoreWay } from "./bore-turning.ts";
import { actionOf, fitsOf, fitted, ranked, toolsOf, type Better, type Fitted } from "./candidates.ts";
import type { CutRequest } from "./values-of-job.ts";

/** How far an outline of a holder stands out towards the axis from the tip, mm. */
const standsOut = (ring: Ring): number => -Math.min(0, ...ring.map(({ r }) => r));

/** The least radius at which the tip of a bar may be in a bore, so that its shank is clear of the opposite wall. */
const leastTip = (tool: Tool, bore: number): number => standsOut(holderOutlines(tool).at(-1) ?? []) - bore;

/** The same with a clearance. */
export const startLimit = (tool: Tool, bore: number): number => leastTip(tool, bore) + BESIDE;

/** Radius at which the tip of a bar starts; null where the bar is too thick. */
export function startFor(tool: Tool, { clear, low }: BoreWay): number | null {
  const r = Math.max(0, low, startLimit(tool, clear));
  return r <= clear - BESIDE && (tool.DMIN ?? 0) <= toDiameter(radius(clear)) ? r : null;
}

/** The job of a cycle inside, from a start point in the bore. */
export function jobInside(
  cycle: Cycle,
  wanted: ShapeRequest,
  stock: readonly Ring[],
  start: { readonly z: number; readonly r: number },
): SetJob {
  const bore = clearRadius(stock, start.z, frontOf(stock));
  return {
    ...jobFor(cycle, wanted, stock),
    // The way into the bore depends on its size at the mouth.
    blank: { ...cylinderAround(stock), bore: Number.isFinite(bore) ? positionAsTyped(toDiameter(radius(bore))) : "0" },
    start: { x: positionAsTyped(toDiameter(radius(start.r))), z: positionAsTyped(start.z) },
  };
}

/** Tools that point away from the axis. */
export const barsOf = (request: PlanRequest, types: (tool: Tool) => boolean): readonly Tool[] =>
  toolsOf(request).filter((tool) => tipDirection(tool.TO).v > 0 && types(tool));

/** Length of a bar behind its tip in addition to the depth of its cut, mm. */
const HELD_BEHIND = 5;

/** A bar as it sticks out for a cut. */
export function heldBar(tool: Tool, depth: number): HeldBar | null {
  const across = barDiameter(tool);
  return across === null ? null : { overhang: depth + HELD_BEHIND, diameter: across };
}

/** A cut goes at least so deep into the material, mm. */
const INTO = 0.02;
/** Points of a move at which that is measured, as shares of it. */
const MEASURED = [0.25, 0.5, 0.75, 1] as const;

/** Directions in which the nose is looked at, from the end of a bore over its wall to the front. */
const LOOKED = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((k) => (k * Math.PI) / 8);

/**
 * Whether a path cuts into the material of a region, and not only along it. The rounded nose cuts, not the theoretical
 * tip: on a chamfer that lies behind the contour.
 */
function cutsInto({ moves }: Plan, tool: Tool, { rings }: Pick<OpenRegion, "rings">): boolean {
  const tip = tipOffset(tool);
  const cutting = noseRadius(tool) - INTO;
  const nose = LOOKED.map((a) => at(cutting * Math.cos(a) - tip.u, cutting * Math.sin(a) - tip.v));
  return moves.some(({ kind, to }, i) => {
    const from = moves[i - 1]?.to ?? to;
    const isIn = (k: number) => {
      const p = at(from.z + k * (to.z - from.z), from.r + k * (to.r - from.r));
      return nose.some(({ z, r }) => rings.filter((ring) => isInside(ring, at(p.z + z, p.r + r))).length % 2 === 1);
    };
    return kind !== "rapid" && MEASURED.some(isIn);
  });
}

/** Steps of Z at which a bore and the edges of a body are measured, mm. */
const [STEP, EDGE] = [0.1, 0.25];
/** Steps of an edge along the axis: no neck of a bore is shorter, mm. */
const NECK = 1;
/** The error of that, mm: a body may seem to touch by so much, and surely stays clear with so much room. */
const NEARLY = 0.1;

/** The radius of a bore in each step of Z from the front of the stock. */
function wallsOf(stock: readonly Ring[], front: number): (step: number) => number {
  const known: number[] = [];
  return (step) =>
    (known[step] ??= step < 0 ? Infinity : clearRadius(stock, front - (step + 1) * STEP, front - step * STEP));
}

/** Points on edges of outlines, at most some mm apart along them, and the corners between. */
const pointsOn = (rings: readonly Ring[], apart: (rise: number) => number): readonly Pt[] =>
  rings.flatMap((ring) =>
    ring.flatMap((to, i) => {
      const from = ring.at(i - 1) ?? to;
      const [along, across] = [to.z - from.z, to.r - from.r];
      const count = Math.max(1, Math.ceil(Math.abs(along) / apart(Math.abs(across))));
      return Array.from({ length: count }, (_, k) => at(to.z - (k / count) * along, to.r - (k / count) * across));
    }),
  );

/** The part of an insert that is farthest from the axis: a blade widens the bore along its whole width. */
function edgeOf(insert: Ring) {
  const flat = insert.filter(({ r }) => r > -SAME).map(({ z }) => z);
  return { ahead: Math.min(0, ...flat), behind: Math.max(0, ...flat) };
}

/**
 * The holder of a bar: `beside` its tip it may meet a neck of the bore anywhere along its edges, the highest point first.
 * What may meet the wall `across` the axis has passed all that is in front of it, so that corners and sloping edges are
 * enough: those of the holder, and with the insert, which the cycle checks itself where it has a path. `needs`: the least
 * radius of a bore by its row.
 */
const bodyOf = perObject((tool: Tool) => {
  const { insert, holder } = outlinesOf()(tool);
  const beside = pointsOn(holder, (rise) => (rise < SAME ? NECK : EDGE)).toSorted((a, b) => b.r - a.r);
  const row = {
    beside,
    up: beside[0]?.r ?? -Infinity,
    ahead: Math.min(0, boxAround([beside]).left),
    edge: edgeOf(insert),
    tool,
    needs: radiusOf(tool.DMIN ?? diameter(0)),
  };
  const withAcross = (rings: readonly Ring[]) => {
    const across = pointsOn(rings, (rise) => (rise < SAME ? Infinity : EDGE)).filter(({ r }) => r < 0);
    return { ...row, across, down: -boxAround([across]).low };
  };
  return { holder: withAcross(holder), all: withAcross([insert, ...holder]) };
});

/** A bore: the Z of its front, and its radius in each step from there. */
interface Bore {
  readonly front: number;
  readonly wallAt: (step: number) => number;
}

/**
 * The Z of the tip at which a bar comes nearer to the wall of a bore than each of the `rooms`, mm, the largest first, or
 * stands in one that is narrower than its row says: as many as it comes nearer than. The path widens the bore as it goes.
 */
function blockedAt(
  moves: readonly Pick<Move, "kind" | "to">[],
  { across, beside, down, up, ahead, edge, tool, needs }: ReturnType<typeof bodyOf>["holder"],
  { front, wallAt }: Bore,
  rooms: readonly number[],
): readonly number[] {
  const stepOf = (z: number) => Math.floor((front - z) / STEP);
  const cut: number[] = [];
  /** The narrowest place in front of each step. */
  const narrow: number[] = [];
  const boreAt = (step: number) => Math.max(wallAt(step), cut[step] ?? 0);
  const narrowAt = (step: number) => {
    for (let k = narrow.length; k <= step; k += 1) narrow[k] = Math.min(narrow[k - 1] ?? Infinity, boreAt(k));
    return narrow[step] ?? Infinity;
  };
  const widen = (step: number, r: number) => {
    if (step < 0 || r <= boreAt(step)) return;
    cut[step] = r;
    for (let k = step; k < narrow.length; k += 1) {
      const least = Math.min(narrow[k - 1] ?? Infinity, boreAt(k));
      if (k > step && narrow[k] === least) break;
      narrow[k] = least;
    }
  };
  const isMet = (z: number, r: number, narrowest: number, room: number) => {
    const least = narrowest - room;
    if (narrowest >= needs && r + least >= down && r + up <= least) return false;
    // A step holds the narrowest place up to its rear end.
    const until = room < 0 ? STEP : 0;
    if (narrowAt(stepOf(z + needsBoreBehind(tool, r) + until)) < needs - SAME) return true;
    if (r + least < down && across.some((p) => r + narrowAt(stepOf(z + p.z)) - room < -p.r)) return true;
    for (const p of beside) {
      if (r + p.r <= least) return false;
      if (z + p.z < front && r + p.r > boreAt(stepOf(z + p.z)) - room) return true;
    }
    return false;
  };
  const met: number[] = [];
  let before = moves[0]?.to ?? at(front, 0);
  for (const { kind, to } of moves) {
    const from = before;
    before = to;
    if (kind === "rapid") continue;
    const count = Math.max(1, Math.ceil(Math.abs(to.z - from.z) / STEP));
    let last = stepOf(from.z + edge.behind);
    for (let i = 0; i <= count; i += 1) {
      const [z, r] = [from.z + (i / count) * (to.z - from.z), from.r + (i / count) * (to.r - from.r)];
      const [first, end] = [stepOf(z + edge.behind), stepOf(z + edge.ahead)];
      // No step between is left out by rounding.
      for (let k = Math.min(last + 1, first); k <= Math.max(last - 1, end); k += 1) widen(k, r);
      last = first;
      if (z >= front) continue;
      const narrowest = narrowAt(stepOf(z + ahead));
      for (let room = rooms[met.length]; room !== undefined && isMet(z, r, narrowest, room); room = rooms[met.length])
        met.push(z);
      if (met.length === rooms.length) return met;
    }
  }
  return met;
}

/** The rearmost Z of a path. */
const rearOf = ({ moves }: Plan): number => Math.min(...moves.map(({ to }) => to.z));

/** Whether a cycle plunges into valleys. */
const PLUNGING = "Q487";

/** What a bar does inside. */
export interface BoreWork {
  readonly kind: ActionKind;
  readonly wanted: ShapeRequest;
  /** Another shape for the same: each tool has the one whose path takes less time. */
  readonly other?: ShapeRequest;
  readonly region: Pick<OpenRegion, "box" | "rings">;
  readonly way: BoreWay;
  readonly cut: Omit<CutRequest, "stock" | "bar" | "smallest" | "largest">;
  /** Whether it goes into a contour that widens behind a neck; absent where there is none. */
  readonly plunges?: boolean;
  /** Most tools for each cycle. */
  readonly most: number;
}

/** A cut less deep is none; room in front of the place where a bar is blocked, mm. */
const [SHORTEST, BACK] = [1, 0.2];
/** Most ends in front of it that are tried, and most corners of the contour in front of it. */
const [MOST_BACK, MOST_CORNERS] = [3, 2];

/** Actions of bars on a contour, and those that go only as far into it as the body of a bar does. */
interface BarActions {
  readonly whole: readonly Action[];
  readonly short: () => readonly Action[];
}

/** The actions of several ways to make a place: those that make a whole contour, else the short ones. */
export function wholeFirst(ways: readonly BarActions[]): readonly Action[] {
  const whole = ways.flatMap((way) => way.whole);
  return whole.length > 0 ? whole : ways.flatMap((way) => way.short());
}

/**
 * The actions of a cycle with the bars that enter and cut, those that reach most first. Roughing and finishing in one call
 * only with those that make the whole contour.
 */
export function barActions(
  { kind, wanted, other, region, way, cut, plunges, most }: BoreWork,
  cycle: Cycle,
  tools: readonly Tool[],
  stock: readonly Ring[],
  request: PlanRequest,
  better: Better = () => 0,
): BarActions {
  const front = frontOf(stock);
  const chain = wanted.contour ?? [];
  const inOneCall = kind === "roughInside" && cut.operation === "both";
  const bore = { front, wallAt: wallsOf(stock, front) };
  const isOwn = ({ T }: Tool) => !request.usualTools?.includes(T);
  const enters = (tool: Tool) => startFor(tool, way) !== null;
  /**
   * The radius that a bar finds behind its tip: a finishing pass from in front of the face makes the bore for a body that
   * does not enter, as far as it cuts the wall, and not only rubs along it or cuts the bottom. Roughing needs a hole that
   * the body enters, for its chips.
   */
  const foundBy = (tool: Tool, low: number) => {
    if (enters(tool) || cut.operation !== "finish" || way.z < front) return way.clear;
    const wall = geometry.flattenedChain(chain, CHORD).flatMap(({ r }) => (r > low + BESIDE - SAME ? [r] : []));
    const made = Math.min(...wall);
    return made < Infinity && made > way.clear + leastDepth(tool) ? made : way.clear;
  };
  /** Bars that may touch: they take no place of others. */
  const near: (Fitted & Pick<OpenRegion, "box">)[] = [];
  /** Where bars that enter are blocked, and the rear end of their path; null where they have none. */
  const blocked = new Map<Tool, { readonly met: number; readonly rear: number } | null>();
  const fitOfBar = (tool: Tool, until = -Infinity) => {
    const box = { ...region.box, left: Math.max(region.box.left, until) };
    const [smallest, largest] = [toDiameter(radius(way.clear)), toDiameter(radius(box.high))];
    const isCut = until > -Infinity;
    const low = isCut ? Math.max(way.low, clearRadius(stock, until, front) - BESIDE) : way.low;
    const r = startFor(tool, { ...way, low, clear: foundBy(tool, low) });
    if (r === null) return null;
    const width = isBar(tool) && cut.operation !== "rough" ? cuttingWidth(tool) : 0;
    const jobOf = (shape: ShapeRequest): SetJob => {
      const whole = shape.contour ?? [];
      const ended = isCut ? contourUpTo(whole, until, stock, request.part, cut.operation) : whole;
      const made = withinRear(ended, width, request.part);
      const own = jobInside(cycle, made === whole ? shape : freeInside(made), stock, { z: way.z, r });
      return plunges === undefined || !cycle.params[PLUNGING] ? own : withValue(own, PLUNGING, plunges ? 1 : 0);
    };
    const asked = { ...cut, stock, smallest, largest, bar: heldBar(tool, front - box.left) };
    const jobs = { job: jobOf(wanted), ...(other && { other: jobOf(other) }) };
    const fit = fitted({ cycle, ...jobs, cut: asked }, tool, request);
    if (fit && ((inOneCall && !fit.makesContour) || !cutsInto(fit.plan, tool, region))) return null;
    // Whether a bar stays clear of a whole contour is known but for the error; an end is put where it surely does.
    const rooms = isCut ? [NEARLY] : [0, -NEARLY];
    const met = fit ? blockedAt(fit.plan.moves, bodyOf(tool).holder, bore, rooms) : [];
    const [first] = met;
    if (fit && first === undefined) return { ...fit, box };
    blocked.set(tool, fit && first !== undefined ? { met: first, rear: rearOf(fit.plan) } : null);
    if (fit && met.length < rooms.length) near.push({ ...fit, box });
    return null;
  };
  const actionFrom = ({ tool, job, values, box }: (typeof near)[number]): Action => {
    const variant = `X${job.start.x} Z${job.start.z}${plunges === false ? " over" : ""}${inOneCall ? " finish" : ""}`;
    const action = actionOf({ kind, site: "inside", cycle, box, variant }, tool, job, values);
    return inOneCall ? { ...action, inOneCall } : action;
  };
  const shortOf = (tool: Tool, limit: number) => {
    const ended = (until: number) => (until > region.box.right - SHORTEST ? null : fitOfBar(tool, until));
    let until = limit + BACK;
    for (let i = 0; i < MOST_BACK; i += 1) {
      blocked.delete(tool);
      const fit = ended(until);
      if (fit) return fit;
      // The way off the wall goes farther, and takes the body nearer to the other one.
      const { met, rear } = blocked.get(tool) ?? { met: until, rear: until };
      until += Math.max(2 * (met - until), met - rear) + BACK;
    }
    const inFront = chain.map(({ to }) => to.z).filter((z) => z > limit + SAME);
    for (const z of [...new Set(inFront)].toSorted((x, y) => x - y).slice(0, MOST_CORNERS)) {
      const fit = ended(z);
      if (fit) return fit;
    }
    return null;
  };
  const short = () => {
    const along = geometry.flattenedChain(chain, CHORD).map((to) => ({ kind: "feed", to }) as const);
    const limits = [...blocked].map(([tool, at]) => {
      const limit = at?.met ?? blockedAt(along, bodyOf(tool).all, bore, [NEARLY])[0] ?? Infinity;
      return { tool, limit };
    });
    const deepestFirst = limits.toSorted((a, b) => a.limit - b.limit);
    const firstOf = (some: typeof limits) => {
      for (const { tool, limit } of some) {
        const fit = shortOf(tool, limit);
        if (fit) return fit;
      }
      return null;
    };
    const deepest = firstOf(deepestFirst);
    // With a usual tool that the table lacks also the deepest of the operator's own.
    const own = deepest && !isOwn(deepest.tool) ? firstOf(deepestFirst.filter(({ tool }) => isOwn(tool))) : null;
    return [deepest, own].flatMap((fit) => (fit ? [actionFrom(fit)] : []));
  };
  const fitsWith = (some: readonly Tool[]) => fitsOf(some, most, request, (tool) => fitOfBar(tool), better);
  const entering = fitsWith(tools.filter(enters));
  const [isMade, isMadeByOwn] = [entering, entering.filter(({ tool }) => isOwn(tool))].map((fits) =>
    fits.some(({ makesContour }) => makesContour),
  );
  // Bars that make their own room cut with their whole body in the hole, so that those that enter it go first.
  const others = tools.filter((tool) => !enters(tool) && !isMadeByOwn && (!isMade || isOwn(tool)));
  const whole = [...entering, ...fitsWith(others), ...ranked(near, better).slice(0, most)].map(actionFrom);
  return { whole, short };
}
