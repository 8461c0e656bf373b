import { heightAt, pathAlong, type Interval } from "../reach/envelope.ts";
import { flat, lowestOf, tangentAt, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../plan/track.ts";
import { withinLimits } from "./finish.ts";
import type { TipEnvelope } from "./tip-envelope.ts";
import { isFalling } from "./levels.ts";
import type { Cutter } from "./link.ts";
import { liftUnder, RECESS_CLEARANCE } from "./valley.ts";

export interface RecessFinish {
  readonly ground: TipEnvelope;
  /** Height in front of the recess at which the tool may travel. */
  readonly top: number;
  readonly feed: number;
  /**
   * Walls cut downwards, so that the cuts meet on the floor: none, every one that rises from a corner, or only those
   * that rise steeply from a sharp one.
   */
  readonly downwards: "none" | "every" | "steep";
  /** Distance from the second wall before its oversize is cut, mm. */
  readonly apart: number;
  /** Range of the tip, and its greatest height (machining limits). */
  readonly area: Interval;
  readonly ceiling: number;
}

/** One finishing cut: from above its start along a path to `foot`; `room` is the space behind it for the retraction. */
interface Cut {
  readonly path: readonly FlatSegment[];
  readonly foot: Flat;
  readonly back: boolean;
  readonly room: number;
  /** True for the last cut, which follows the contour to the end of the run. */
  readonly last: boolean;
}

const p = (step: number): Purpose => ({ phase: "finish", run: "finish", step });

/**
 * The printed finishing steps 1 to 6 of a recess, valley by valley; the caller returns to the cycle start. Without a
 * path there is no cut.
 */
export function finishRecess(cutter: Cutter, f: RecessFinish): void {
  const e = f.ground.envelope;
  const [left, right] = [Math.max(f.ground.start.u, f.area.from), Math.min(f.ground.end.u, f.area.to)];
  if (left > right + SAME) return;
  const [begins, ends] = [left < f.ground.start.u + SAME, right > f.ground.end.u - SAME];
  const link = (step: number) => ({ gap: RECESS_CLEARANCE, feed: f.feed, out: p(step), down: p(step), enter: p(step) });
  const out = (step: number) => cutter.link({ u: cutter.at.u, v: f.top }, link(step));
  /** Moves to the clearance above the start of a wall, at most up to the travel height. */
  const into = (u: number, height: number, step: number) =>
    cutter.link({ u, v: Math.min(f.top, Math.max(height, heightAt(e, u)) + RECESS_CLEARANCE) }, link(step));

  const whole = right > left + SAME ? pathAlong(e, left, right) : [];
  const runs = whole.length > 0 ? withinLimits(whole, f.ceiling) : [[]];
  runs.forEach((run, i) => {
    // Between two walls the tool has a single position: the middle of its slot.
    const begin = run.length > 0 ? left : (left + right) / 2;
    const at = { u: begin, v: heightAt(e, begin) };
    const [first, last] = [begins && i === 0, ends && i === runs.length - 1];
    const walls = { left: first ? f.ground.start.v : -Infinity, right: last ? f.ground.end.v : -Infinity };
    for (const cut of cutsOf(run, at, walls, f)) {
      const begin = cut.path[0]?.from ?? cut.foot;
      const height = cut.back
        ? begin.u >= right - SAME
          ? walls.right
          : begin.v
        : begin.u <= left + SAME
          ? walls.left
          : begin.v;
      into(begin.u, Math.max(height, Math.min(begin.v, f.ceiling)), cut.back ? 5 : 1);
      const floor = Math.min(cut.foot.v, ...cut.path.map(lowestOf));
      const onFloor = (s: FlatSegment) =>
        s.kind === "line" && Math.abs(s.from.v - floor) < SAME && Math.abs(s.to.v - floor) < SAME;
      const step = (s: FlatSegment) => (cut.back ? 6 : onFloor(s) ? 3 : 2);
      cutter.along(cut.path, (s) => ({ feed: f.feed, purpose: p(step(s)) }));
      cutter.feed(cut.foot, f.feed, p(cut.back ? 6 : 2));
      if (cut.last && last) cutter.feed({ u: right, v: Math.max(cutter.at.v, f.ground.end.v) }, f.feed, p(3));
      else cutter.leave(liftUnder(f.top, cutter.at.v), -1, e, f.feed, p(cut.back ? 6 : 4), cut.room);
      out(cut.back ? 6 : 4);
    }
  });
}

/** Heights of the walls at the ends of a run; −∞ if there is none. */
interface EndWalls {
  readonly left: number;
  readonly right: number;
}

/**
 * A rise at which a bar would press sideways into the oversize of a wall: steeper than 45°, out of a corner sharper
 * than 30°.
 */
const STEEP = { rise: Math.SQRT1_2, turn: 0.5 };
const UP: Flat = { u: 0, v: 1 };
const LEVEL: Flat = { u: 1, v: 0 };

/**
 * The cuts along a run: each valley from its first wall to the floor, then from the top of its second wall to the end
 * of the first cut.
 */
function cutsOf(run: readonly FlatSegment[], at: Flat, walls: EndWalls, f: RecessFinish): Cut[] {
  const segments = [...run];
  const cuts: Cut[] = [];
  let begin = 0;
  const corner = (k: number): Flat => (k > 0 ? segments[k - 1]?.to : segments[0]?.from) ?? at;
  const rises = (k: number): boolean => {
    if (f.downwards === "none") return false;
    const wall = walls.right > corner(k).v + SAME ? UP : LEVEL;
    const [before, after] = [segments[k - 1], segments[k]];
    const [a, b] = [before && k > begin ? tangentAt(before, "to") : LEVEL, after ? tangentAt(after, "from") : wall];
    const turn = flat.cross(a, b);
    return f.downwards === "every" ? b.v > SAME && turn > SAME : b.v >= STEEP.rise && turn >= STEEP.turn;
  };
  for (let k = 0; k <= segments.length; k += 1) {
    if (!rises(k)) continue;
    const foot = corner(k);
    let b = k;
    while (b > begin && !isFalling(segments[b - 1] as FlatSegment)) b -= 1;
    const ramp = segments[b - 1];
    if (b === k && b > begin && ramp && f.downwards === "steep" && tangentAt(ramp, "to").u > STEEP.rise) b -= 1;
    const from = segments[b]?.from.u ?? foot.u;
    const floor = b < k ? { from: Math.min(from, foot.u), to: foot.u } : { from: foot.u, to: foot.u };
    const meet = Math.max((floor.from + floor.to) / 2, floor.to - f.apart - RECESS_CLEARANCE / 2);
    const split = b < k ? splitAt(segments, b, k, meet) : { at: k, added: 0 };
    const end = k + split.added;
    const top = f.downwards === "every" ? segments.length : topOf(segments, end);
    const where = segments[split.at - 1]?.to ?? foot;
    const here = split.at > 0 ? where : foot;
    const room = here.u - floor.from;
    const isWall = begin === 0 && walls.left > here.v + SAME;
    if (split.at > begin || isWall)
      cuts.push({ path: segments.slice(begin, split.at), foot: here, back: false, room, last: false });
    // A tool as wide as the groove has finished both walls in one cut.
    if (segments.length > 0 || !isWall)
      cuts.push({
        path: segments.slice(split.at, top).map(flat.reversed).reverse(),
        foot: here,
        back: true,
        room,
        last: false,
      });
    begin = top;
    k = top;
  }
  const rest = segments.slice(begin);
  if (rest.length > 0 || cuts.length === 0)
    cuts.push({ path: rest, foot: rest.at(-1)?.to ?? at, back: false, room: RECESS_CLEARANCE, last: true });
  return cuts;
}

/** Splits the path at a place between two of its joints; at an existing joint nothing is added. */
function splitAt(segments: FlatSegment[], from: number, to: number, u: number): { at: number; added: number } {
  for (let i = from; i < to; i += 1) {
    const s = segments[i] as FlatSegment;
    if (s.to.u < u - SAME) continue;
    if (u <= s.from.u + SAME) return { at: i, added: 0 };
    if (u >= s.to.u - SAME) return { at: i + 1, added: 0 };
    segments.splice(i, 1, ...halves(s, u));
    return { at: i + 1, added: 1 };
  }
  return { at: to, added: 0 };
}

/** An element of an envelope, split at a place. */
function halves(s: FlatSegment, u: number): [FlatSegment, FlatSegment] {
  const k = (u - s.from.u) / (s.to.u - s.from.u);
  const side = s.kind === "arc" && s.turn === "ccw" ? -1 : 1;
  const v =
    s.kind === "line"
      ? s.from.v + k * (s.to.v - s.from.v)
      : s.centre.v + side * Math.sqrt(Math.max(0, flat.radiusOf(s) ** 2 - (u - s.centre.u) ** 2));
  return [
    { ...s, to: { u, v } },
    { ...s, from: { u, v } },
  ];
}

/** The joint at the end of a rise from `k` on; a hill is split at its highest point. */
function topOf(segments: FlatSegment[], k: number): number {
  let top = k;
  for (let s = segments[top]; s; s = segments[top]) {
    const hill = s.kind === "arc" && s.turn === "cw" && s.centre.u > s.from.u + SAME && s.centre.u < s.to.u - SAME;
    if (hill && s.kind === "arc") {
      segments.splice(top, 1, ...halves(s, s.centre.u));
      return top + 1;
    }
    if (s.to.v <= s.from.v + SAME) return top;
    top += 1;
  }
  return top;
}
