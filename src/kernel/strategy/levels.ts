import { intervalsBelow } from "../reach/below.ts";
import {
  heightAt,
  higherOf,
  highest,
  linePiece,
  pathAlong,
  upperEnvelope,
  type Envelope,
  type Interval,
  type Origin,
} from "../reach/envelope.ts";
import type { FlatSegment } from "../geometry/flat.ts";
import type { Move } from "../plan/move.ts";
import { JOINED, ROUND, SAME, SLIVER } from "../tolerance.ts";
import type { Purpose } from "../plan/track.ts";
import type { Feeds } from "./feeds.ts";
import type { Cutter } from "./link.ts";

/** Input of roughing in levels. Heights and lengths in strategy space, mm. */
export interface Levels {
  readonly envelope: Envelope;
  /** The first level is one infeed below `top`. */
  readonly top: number;
  readonly passes: number;
  readonly infeed: number;
  /** The tip stays within this range of u, and meets the contour first at `first`. */
  readonly first: number;
  readonly from: number;
  readonly to: number;
  /** 0: follow the contour after each pass; 1 and 2: lift at 45°. */
  readonly smoothing: number;
  readonly clearance: number;
  readonly feeds: Feeds;
  /** Leave out passes that cut air. */
  readonly skipsAirPasses: boolean;
}

/**
 * One cut: a valley at a level, its entry (null: from the front), and the limit up to which its lift may follow the
 * contour.
 */
interface Cut {
  readonly pass: number;
  readonly valley: Interval;
  readonly entry: number | null;
  readonly limit: number;
  /** The valley of the previous level that contains this one. */
  readonly outer: Interval;
}

const purpose = (step: number, pass: number, plunging = false): Purpose =>
  plunging
    ? { phase: "rough", run: "rough", step, pass, plunging: true }
    : { phase: "rough", run: "rough", step, pass };

/** Whether an element falls, so that the tool goes into the material. */
export const isFalling = (s: FlatSegment) => s.to.v < s.from.v - ROUND;

const level = (l: Levels, pass: number) => l.top - pass * l.infeed;

/**
 * The cuts of all levels in order: the valleys of a level one after the other, each down to its floor before the next.
 */
function* cuts(l: Levels): Generator<Cut> {
  const open = (v: Interval) => v.from <= l.from + JOINED;
  const within = (pass: number, valleys: readonly Interval[], outer: Interval): Cut[] =>
    valleys.map((valley, k) => {
      const before = valleys[k - 1];
      const after = valleys[k + 1];
      const entry = open(valley) ? null : before ? highest(l.envelope, before.to, valley.from).u : outer.from;
      return { pass, valley, entry, limit: after ? highest(l.envelope, valley.to, after.from).u : outer.to, outer };
    });
  // A crest higher than the start point ends the area.
  const front = Math.max(l.top, heightAt(l.envelope, l.from));
  const reachable = intervalsBelow(l.envelope, level(l, 1), l.from, l.to).filter(
    (v) => open(v) || highest(l.envelope, l.from, v.from).v <= front + SAME,
  );
  // If the part in front is as high as the area, nothing is cut before the contour begins.
  const begin = heightAt(l.envelope, l.from) >= l.top - SAME ? Math.min(l.first, reachable[0]?.from ?? l.from) : l.from;
  const pending = within(1, reachable, { from: Math.max(begin, l.from), to: l.to }).reverse();
  for (let cut = pending.pop(); cut; cut = pending.pop()) {
    yield cut;
    if (cut.pass < l.passes)
      pending.push(
        ...within(
          cut.pass + 1,
          intervalsBelow(l.envelope, level(l, cut.pass + 1), cut.valley.from, cut.valley.to),
          cut.valley,
        ).reverse(),
      );
  }
}

/**
 * The printed steps 1 to 5 of roughing: infeed at rapid, cut, lift by the infeed, back at rapid, until the deepest
 * level. With smoothing 0, an outer element below the last level is cut at the end by following the contour.
 */
export function roughByLevels(cutter: Cutter, l: Levels): void {
  if (l.passes === 0) return;
  for (const cut of cuts(l)) {
    if (l.skipsAirPasses && isInAir(cutter, l, cut)) continue;
    enter(cutter, l, cut);
    cutter.feed({ u: cut.valley.to, v: level(l, cut.pass) }, l.feeds.rough, purpose(2, cut.pass));
    lift(cutter, l, cut);
  }
  if (l.smoothing === 0) followBelow(cutter, l);
}

/** The moves with passes renumbered after some were left out, and the number of passes. */
export function renumberedPasses(moves: readonly Move[]): { readonly moves: readonly Move[]; readonly passes: number } {
  const left = [
    ...new Set(moves.flatMap(({ phase, pass }) => (phase === "rough" && pass !== undefined ? [pass] : []))),
  ].sort((a, b) => a - b);
  const number = new Map(left.map((pass, i) => [pass, i + 1]));
  const counted = moves.map((move): Move => {
    const pass = move.phase === "rough" && move.pass !== undefined ? number.get(move.pass) : undefined;
    return pass === undefined ? move : { ...move, pass };
  });
  return { moves: counted, passes: left.length };
}

const FLOOR: Origin = { feature: "nose", on: "edge", corner: false };

/** Whether there is no stock above a level along its cut, and along the contour of its lift; slivers do not count. */
function isInAir({ frontier }: Cutter, l: Levels, { pass, valley, entry, limit }: Cut): boolean {
  const [from, to] = [entry ?? valley.from, l.smoothing === 0 ? Math.max(valley.to, limit) : valley.to];
  const height = level(l, pass);
  const floor = linePiece({ u: from, v: height }, { u: to, v: height }, FLOOR);
  return (
    floor === null || frontier.stockAbove(higherOf(l.envelope, upperEnvelope([floor])), { from, to }, SLIVER) === null
  );
}

const linked = (l: Levels, pass: number) => ({
  gap: Math.min(l.infeed, l.clearance),
  feed: l.feeds.plunge,
  out: purpose(4, pass),
  down: purpose(1, pass),
  enter: purpose(2, pass, true),
});

/** Moves to the beginning of a cut: in front of it, or down along the element that falls into its valley. */
function enter(cutter: Cutter, l: Levels, { pass, valley, entry }: Cut) {
  const height = level(l, pass);
  if (entry === null) return cutter.link({ u: valley.from, v: height }, linked(l, pass));
  cutter.link({ u: entry, v: Math.max(height, heightAt(l.envelope, entry)) }, linked(l, pass));
  cutter.along(
    pathAlong(l.envelope, entry, valley.from).map((s) => s.segment),
    (s) => ({ feed: isFalling(s) ? l.feeds.plunge : l.feeds.rough, purpose: purpose(2, pass, isFalling(s)) }),
  );
  cutter.feed({ u: valley.from, v: height }, l.feeds.plunge, purpose(2, pass, true));
}

/** Step 3: along the contour up to the previous level and clear of it, or back at 45°. */
function lift(cutter: Cutter, l: Levels, { pass, valley, limit, outer }: Cut) {
  const p = purpose(3, pass);
  const previous = level(l, pass - 1);
  if (l.smoothing === 0) {
    const up = highest(l.envelope, valley.to, Math.max(valley.to, limit));
    const end = up.v > previous - ROUND ? riseTo(l.envelope, valley.to, limit, previous) : up.u;
    cutter.along(
      pathAlong(l.envelope, valley.to, end).map((s) => s.segment),
      () => ({ feed: l.feeds.rough, purpose: p }),
    );
    cutter.feed(cutter.limitedInBore({ u: end, v: previous }), l.feeds.rough, p);
    cutter.feed(cutter.limitedInBore({ u: end, v: previous + l.infeed }), l.feeds.rough, p);
    return;
  }
  const back = Math.min(l.infeed, valley.to - valley.from);
  cutter.leave(back, -1, l.envelope, l.feeds.rough, p);
  cutter.feed(cutter.limitedInBore({ u: cutter.at.u, v: previous }), l.feeds.rough, p);
  // Too narrow to retract at 45°: straight up first, then back where the valley is wide enough.
  cutter.leave(Math.min(l.infeed - back, cutter.at.u - outer.from), -1, l.envelope, l.feeds.rough, p);
}

/** Cuts along the contour below the last level (a chamfer or a radius at an edge). */
function followBelow(cutter: Cutter, l: Levels) {
  const p = (step: number) => purpose(step, l.passes);
  for (const deeper of intervalsBelow(l.envelope, level(l, l.passes) - 2 * SAME, l.from, l.to)) {
    const lowest = pathAlong(l.envelope, deeper.from, deeper.to).map((s) => s.segment);
    const first = lowest[0];
    if (!first) continue;
    cutter.link(first.from, linked(l, l.passes));
    cutter.along(lowest, () => ({ feed: l.feeds.rough, purpose: p(2) }));
    cutter.leave(l.infeed, -1, l.envelope, l.feeds.rough, p(3));
  }
}

/** First u at or after `from` where the envelope has risen to `height`; `limit` when it does not. */
export function riseTo(e: Envelope, from: number, limit: number, height: number): number {
  const first = intervalsBelow(e, height, from, limit)[0];
  return first && first.from <= from + JOINED ? first.to : from;
}
