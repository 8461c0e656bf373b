import { pieceOf } from "../reach/cut-envelope.ts";
import { crossings, heightAt, pathAlong, staysAbove, valueAt, type Envelope, type Stretch } from "../reach/envelope.ts";
import { flat, normalAt, tangentAt, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../plan/track.ts";
import type { Feeds } from "./feeds.ts";
import type { TipEnvelope } from "./tip-envelope.ts";
import { isFalling } from "./levels.ts";
import type { Cutter, Link } from "./link.ts";

export interface Finish {
  readonly ground: TipEnvelope;
  /** The finished contour, for the envelope of the set-up clearance. */
  readonly contour: readonly FlatSegment[];
  readonly start: Flat;
  readonly clearance: number;
  /** Height up to which the cut continues at its end, where a wall closes the area behind the contour; else null. */
  readonly runOut: number | null;
  readonly feeds: Feeds;
  /** The tip stays within this range of u and below this height (a machining limit). */
  readonly from: number;
  readonly to: number;
  readonly ceiling: number;
  /** True for the smoothing cut, which is part of roughing and uses its feeds. */
  readonly smoothing: boolean;
  /** Number of a roughing pass along the contour. */
  readonly pass?: number;
  /** Height of the start point, to which the tool retracts straight at feed after a pass that ends below it. */
  readonly backTo?: number;
}

/**
 * The printed finishing steps: infeed at rapid to the clearance, the contour from start to end at feed, lift by the
 * clearance at feed (after a roughing pass along the contour: back to the height of the start point). The caller
 * returns to the cycle start. A machining limit interrupts the cut until the contour comes back from behind the limit.
 */
export function followContour(cutter: Cutter, f: Finish, issues: Issue[]): void {
  const u0 = Math.max(f.ground.pathStart, f.from);
  const u1 = Math.min(f.ground.end.u, f.to);
  // In a groove as wide as the insert, only the way out remains.
  const along = u1 > u0 + SAME ? pathAlong(f.ground.envelope, u0, u1) : [];
  const runs = u1 > u0 - SAME ? withinLimits([...along, ...exitWall(f, Math.max(u0, u1))], f.ceiling) : [];
  if (runs.length === 0) return void issues.push(issue("nothingToCut", "warning", {}, "tool"));
  const near = !isRoughing(f) && f.contour.some((s) => flat.distanceTo(s, f.start) < f.clearance - SAME);
  if (near) issues.push(issue("startInsideEnvelope", "warning", { clearance: f.clearance }, "start"));
  runs.forEach((run, i) => {
    const whole = i === 0 && f.ground.pathStart >= f.from - SAME ? withEntryWall(f, run) : run;
    leadIn(cutter, f, whole, near && i === 0);
    cutter.along(whole, (s) =>
      f.smoothing && isFalling(s)
        ? { feed: f.feeds.plunge, purpose: { ...purpose(f, 2), plunging: true } }
        : { feed: feedOf(f), purpose: purpose(f, 2) },
    );
    if (f.backTo !== undefined && f.backTo > cutter.at.v + SAME)
      cutter.feed({ u: cutter.at.u, v: f.backTo }, feedOf(f), purpose(f, 3));
    else cutter.leave(f.clearance, -1, f.ground.envelope, feedOf(f), purpose(f, 3));
  });
}

const isRoughing = (f: Finish) => f.smoothing || f.pass !== undefined;
function purpose({ smoothing, pass }: Finish, step: number): Purpose {
  if (pass !== undefined) return { phase: "rough", run: "rough", step, pass };
  return smoothing ? { phase: "smooth", run: "rough", step: 5 } : { phase: "finish", run: "finish", step };
}
const feedOf = (f: Finish) => (isRoughing(f) ? f.feeds.rough : f.feeds.finish);

/** The end of the path: up a wall at the end of the contour, or one that closes the area behind it. */
function exitWall(f: Finish, u: number): Stretch[] {
  const at = heightAt(f.ground.envelope, u - 2 * SAME);
  const end = Math.max(f.ground.end.v, f.runOut ?? -Infinity);
  // Without a bound below the tip there is no wall to leave by.
  if (at === -Infinity || f.to < f.ground.end.u - SAME || end <= at + SAME) return [];
  return [{ segment: { kind: "line", from: { u, v: at }, to: { u, v: end } }, origin: null }];
}

/** Splits a path into the runs on this side of the machining limits. */
export function withinLimits(path: readonly Stretch[], ceiling: number): FlatSegment[][] {
  const runs: FlatSegment[][] = [];
  let open = false;
  path.forEach(({ segment, origin }, i) => {
    const next = path[i + 1];
    // A vertical step belongs to the section it leads to.
    const behind = origin === null ? next?.origin?.on === "limit" : origin.on === "limit";
    const above = flat.boxOf(segment).high > ceiling + SAME;
    const parts = behind ? [] : above ? partsBelow(segment, ceiling) : [segment];
    if (parts.length === 0) open = false;
    for (const part of parts) {
      if (!open || part.from !== segment.from) runs.push([]);
      runs.at(-1)?.push(part);
      open = part.to === segment.to;
    }
  });
  return runs;
}

/** The parts of an element below a height, cut at the crossings. */
function partsBelow(s: FlatSegment, height: number): FlatSegment[] {
  const on = { feature: "nose", on: "limit", corner: false } as const;
  const piece = pieceOf(s, on);
  if (!piece) return Math.min(s.from.v, s.to.v) >= height - SAME ? [] : [upTo(s, height)];
  const level = { arc: 0, u0: piece.u0, u1: piece.u1, v0: height, slope: 0, origin: on } as const;
  const points = [s.from, ...crossings(piece, level, piece.u0, piece.u1).map((u): Flat => ({ u, v: height })), s.to];
  return points.slice(1).flatMap((to, i) => {
    const from = points[i] as Flat;
    return valueAt(piece, (from.u + to.u) / 2) < height ? [{ ...s, from, to }] : [];
  });
}

/** A vertical move cut at a height. */
const upTo = (s: FlatSegment, height: number): FlatSegment =>
  s.from.v > height
    ? { ...s, from: { u: s.from.u, v: height } }
    : s.to.v > height
      ? { ...s, to: { u: s.to.u, v: height } }
      : s;

/** A contour that begins with a wall is entered at the foot of that wall, or followed from its top down. */
function withEntryWall(f: Finish, run: readonly FlatSegment[]): FlatSegment[] {
  const first = run[0] as FlatSegment;
  const top = f.ground.start.v;
  const left = heightAt(f.ground.envelope, first.from.u - SAME);
  const v =
    first.from.v < top - SAME
      ? top
      : first.from.v <= top + SAME
        ? first.from.v
        : Math.min(first.from.v, Math.max(top, left));
  return Math.abs(v - first.from.v) <= SAME
    ? [...run]
    : [{ kind: "line", from: { u: first.from.u, v }, to: first.from }, ...run];
}

/**
 * Approaches the beginning of a run: along the extension of its first element; if that is not free, from the open side,
 * perpendicular to it; last from straight above. Inside the clearance envelope the tool goes straight there.
 */
function leadIn(cutter: Cutter, f: Finish, run: readonly FlatSegment[], near: boolean): void {
  const first = run[0] as FlatSegment;
  const to = first.from;
  const link: Link = {
    gap: f.clearance,
    feed: feedOf(f),
    out: purpose(f, (f.pass ?? 1) > 1 ? 4 : 1),
    down: purpose(f, 1),
    enter: purpose(f, 1),
  };
  const bare = f.ground.partEnvelope;
  if (near && staysAbove(bare, cutter.at, to) && !isBlocked(bare, cutter.at, to))
    return cutter.feed(to, feedOf(f), purpose(f, 1));
  const along = tangentAt(first, "from");
  const square = normalAt(first, "from");
  const from =
    [{ u: -along.u, v: -along.v }, square]
      .map((d) => cutter.limitedInBore({ u: to.u + d.u * f.clearance, v: to.v + d.v * f.clearance }, to))
      .find((p) => staysAbove(bare, p, to) && !isBlocked(bare, p, to) && p.u >= f.from - f.clearance) ??
    cutter.limitedInBore({ u: to.u, v: to.v + f.clearance }, to);
  cutter.link(from, link);
  cutter.feed(to, feedOf(f), purpose(f, 1));
}

/** True if a corner reaches over a vertical move down. */
const isBlocked = (part: Envelope, from: Flat, to: Flat) =>
  Math.abs(from.u - to.u) <= SAME && heightAt(part, to.u) > Math.max(to.v, from.v) + SAME;
