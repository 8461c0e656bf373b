import { heightAt, highest, pathAlong, staysAbove, type Envelope } from "../envelope.ts";
import { distance, type Flat, type FlatSegment } from "../flat.ts";
import { issue, type Issue } from "../issue.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose, Track } from "../track.ts";
import type { Feeds } from "./feeds.ts";
import type { Ground } from "./ground.ts";
import { falls } from "./levels.ts";

export interface Finish {
  readonly ground: Ground;
  /** The contour finished to, for the envelope of the set-up clearance. */
  readonly contour: readonly FlatSegment[];
  readonly start: Flat;
  readonly clearance: number;
  /** Where roughing with this tool ended; empty when there was none. */
  readonly roughed: Envelope;
  /** Roughing lifted at 45° and left its steps. */
  readonly stepped: boolean;
  /** Height that the cut runs on to at its end, where a wall closes the area behind the contour; else null. */
  readonly runOut: number | null;
  /** What roughing has left above the contour and beside it, mm. */
  readonly kept: number;
  readonly aside: number;
  readonly feeds: Feeds;
  /** The tip stays within this stretch of u. */
  readonly from: number;
  readonly to: number;
  /** The smoothing cut runs as part of roughing, at its feeds. */
  readonly smoothing: boolean;
}

/**
 * The printed finishing steps: infeed at rapid to the clearance, the contour from start to end at feed, lift by the
 * clearance at feed. Going back to the cycle start is the caller's.
 */
export function finishContour(track: Track, f: Finish, issues: Issue[]): void {
  const p = (step: number): Purpose => f.smoothing
    ? { phase: "smooth", run: "rough", step: 5 }
    : { phase: "finish", run: "finish", step };
  const feed = f.smoothing ? f.feeds.rough : f.feeds.finish;
  const u0 = Math.max(f.ground.first, f.from);
  const u1 = Math.min(f.ground.end.u, f.to);
  if (!(u1 > u0)) return void issues.push(issue("nothingToCut", "warning", {}, "tool"));
  const path = pathAlong(f.ground.envelope, u0, u1);
  const first = path[0]?.segment.from;
  if (!first) return;
  // A contour that begins with a rise is joined at its foot; one that the insert cannot touch there, where it can.
  const left = heightAt(f.ground.envelope, u0 - SAME);
  const low = f.ground.start.v;
  // One that begins with a wall that falls is followed from the top of the wall.
  const begin = { u: u0, v: first.v < low - SAME ? low : first.v <= low + SAME ? first.v : Math.min(first.v, Math.max(low, left)) };
  if (!f.smoothing && nearContour(f.start, f.contour) < f.clearance) {
    issues.push(issue("startInsideEnvelope", "warning", { clearance: f.clearance }, "start.x"));
  } else {
    // Where lifts at 45° leave steps, only the column of the start point is free all the way down.
    const before = Math.min(f.stepped ? f.start.u : Math.max(f.start.u, u0 - f.clearance), u0);
    const free = Math.max(begin.v, highest(f.ground.envelope, before, u0).v) + Math.max(f.clearance, f.kept);
    const above = Math.max(free, heightAt(f.roughed, before));
    if (track.at.v < above) track.rapid("v", above, p(1));
    track.rapid("u", before, p(1));
    track.rapid("v", above, p(1));
    // The level in front of the contour bounds the area, not the part: the way may end below it.
    const way = { u: begin.u, v: Math.max(begin.v, left) };
    if (!staysAbove(f.ground.envelope, track.at, way)) track.feed({ u: begin.u, v: track.at.v }, feed, p(1));
  }
  track.feed(begin, feed, p(1));
  track.along(path.map((s) => s.segment), (s) => f.smoothing && falls(s)
    ? { feed: f.feeds.plunge, purpose: { ...p(2), plunging: true } }
    : { feed, purpose: p(2) });
  if (f.to >= f.ground.end.u - SAME) track.feed({ u: u1, v: Math.max(track.at.v, f.ground.end.v, f.runOut ?? -Infinity) }, feed, p(2));
  lift(track, f, feed, p(3));
}

/**
 * Lifts by the clearance: leaning back from what stands beyond the end of the contour, or, where the contour
 * behind is in the way, straight up out of the area.
 */
function lift(track: Track, f: Finish, feed: number, purpose: Purpose) {
  const { at } = track;
  const back = Math.max(f.clearance, f.aside);
  const leaning = { u: Math.max(at.u - back, f.from), v: at.v + back };
  const straight = { u: at.u, v: Math.max(at.v + f.clearance, f.start.v) };
  track.feed(staysAbove(f.ground.envelope, leaning, at) ? leaning : straight, feed, purpose);
}

/** Distance from a point to a contour, mm; an arc is judged by its ends and its nearest point. */
function nearContour(p: Flat, contour: readonly FlatSegment[]): number {
  let near = Infinity;
  for (const s of contour) {
    if (s.kind === "line") {
      const du = s.to.u - s.from.u;
      const dv = s.to.v - s.from.v;
      const k = Math.min(1, Math.max(0, ((p.u - s.from.u) * du + (p.v - s.from.v) * dv) / (du * du + dv * dv || 1)));
      near = Math.min(near, Math.hypot(p.u - s.from.u - k * du, p.v - s.from.v - k * dv));
    } else near = Math.min(near, distance(p, s.from), distance(p, s.to));
  }
  return near;
}
