import { below, heightAt, highest, pathAlong, type Envelope, type Interval } from "../envelope.ts";
import type { Flat, FlatSegment } from "../flat.ts";
import { ROUND, SAME } from "../tolerance.ts";
import type { Purpose, Track } from "../track.ts";
import type { Feeds } from "./feeds.ts";

/** How roughing by levels runs. Heights and lengths in strategy space, mm. */
export interface Levels {
  readonly envelope: Envelope;
  /** Tip at the cycle start; the first level lies one infeed under `top`. */
  readonly start: Flat;
  readonly top: number;
  readonly passes: number;
  readonly infeed: number;
  /** The tip stays within this stretch of u. */
  readonly from: number;
  readonly to: number;
  /** 0: follow the contour after each pass; 1 and 2: lift at 45°. */
  readonly smoothing: number;
  readonly feeds: Feeds;
}

const purpose = (step: number, pass: number, plunging = false): Purpose =>
  plunging ? { phase: "rough", run: "rough", step, pass, plunging: true } : { phase: "rough", run: "rough", step, pass };

/** A falling element: the tool goes into the material there. */
export const falls = (s: FlatSegment) => s.to.v < s.from.v - ROUND;

/**
 * The printed steps 1 to 5: infeed at rapid, cut, lift by the infeed, back at rapid, until the deepest level. Valleys
 * that a level meets are cut in order, each to its floor before the next.
 */
export function roughByLevels(track: Track, l: Levels): void {
  const level = (i: number) => l.top - i * l.infeed;
  const open = (v: Interval) => v.from <= l.from + 1e-7;

  const cut = (i: number, valley: Interval, entry: number | null) => {
    const height = level(i);
    const p = (step: number, plunging = false) => purpose(step, i, plunging);
    // From another valley the way leads over the level where both were still one.
    if (track.at.v < level(i - 1)) track.rapid("v", level(i - 2), p(4));
    const over = entry === null ? track.at.v : highest(l.envelope, Math.min(track.at.u, entry), entry).v;
    if (track.at.v < over) track.rapid("v", over, p(4));
    if (entry === null) {
      track.rapid("u", valley.from, p(4));
      track.rapid("v", height, p(1));
    } else {
      track.rapid("u", entry, p(4));
      track.rapid("v", Math.max(level(i - 1), heightAt(l.envelope, entry)), p(1));
      track.feed({ u: entry, v: Math.max(height, heightAt(l.envelope, entry)) }, l.feeds.plunge, p(2, true));
      track.along(pathAlong(l.envelope, entry, valley.from).map((s) => s.segment), (s) =>
        ({ feed: falls(s) ? l.feeds.plunge : l.feeds.rough, purpose: p(2, falls(s)) }));
      track.feed({ u: valley.from, v: height }, l.feeds.plunge, p(2, true));
    }
    track.feed({ u: valley.to, v: height }, l.feeds.rough, p(2));
  };

  const lift = (i: number, valley: Interval, limit: number, outer: Interval) => {
    const p = purpose(3, i);
    const previous = level(i - 1);
    if (l.smoothing === 0) {
      const up = highest(l.envelope, valley.to, Math.max(valley.to, limit));
      const end = up.v > previous - ROUND ? riseTo(l.envelope, valley.to, limit, previous) : up.u;
      track.along(pathAlong(l.envelope, valley.to, end).map((s) => s.segment), () => ({ feed: l.feeds.rough, purpose: p }));
      track.feed({ u: end, v: previous }, l.feeds.rough, p);
      track.feed({ u: end, v: previous + l.infeed }, l.feeds.rough, p);
      return;
    }
    const back = Math.min(l.infeed, valley.to - valley.from);
    track.feed({ u: valley.to - back, v: level(i) + back }, l.feeds.rough, p);
    track.feed({ u: track.at.u, v: previous }, l.feeds.rough, p);
    // Too narrow to lean back: straight up first, and back where the valley is wide enough.
    const rest = Math.min(l.infeed - back, track.at.u - outer.from);
    track.feed({ u: track.at.u - rest, v: previous + rest }, l.feeds.rough, p);
  };

  /** The valleys of one level with where to enter each: in front (null), or where it falls from the level before. */
  const tasks = (i: number, valleys: readonly Interval[], outer: Interval) =>
    valleys.map((valley, k) => {
      const before = valleys[k - 1];
      const after = valleys[k + 1];
      const entry = open(valley) ? null : before ? highest(l.envelope, before.to, valley.from).u : outer.from;
      return { i, valley, outer, entry, limit: after ? highest(l.envelope, valley.to, after.from).u : outer.to };
    });

  if (l.passes === 0) return;
  const whole = { from: l.from, to: l.to };
  const front = Math.max(l.top, heightAt(l.envelope, l.from));
  const reachable = below(l.envelope, level(1), l.from, l.to).filter((v) => open(v) || highest(l.envelope, l.from, v.from).v <= front + SAME);
  const pending = tasks(1, reachable, whole).reverse();
  for (let task = pending.pop(); task; task = pending.pop()) {
    const { i, valley, outer, entry, limit } = task;
    cut(i, valley, entry);
    lift(i, valley, limit, outer);
    if (i < l.passes) pending.push(...tasks(i + 1, below(l.envelope, level(i + 1), valley.from, valley.to), valley).reverse());
  }
}

/** First u at or after `from` where the envelope has risen to `height`; `limit` when it does not. */
export function riseTo(e: Envelope, from: number, limit: number, height: number): number {
  const first = below(e, height, from, limit)[0];
  return first && first.from <= from + 1e-6 ? first.to : from;
}
